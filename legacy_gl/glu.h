/* The part of the OpenGL Utility Library (GLU 1.3) that OpenGL 1.x programs lean on, over
 * legacy_gl/gl.h.
 *
 * Implemented: matrices (chapter 4), error and version strings (2.1, 8), quadrics (chapter 6).
 *
 * Not here: image scaling and mipmaps (3), tessellation (5), NURBS (7). They are not declared, so
 * that a program that needs them fails to compile instead of failing to draw.
 *
 * Differs: nothing known in what is drawn. Every call hands the GL the same numbers in the same
 * order as libGLU 9.0.2, except where libGLU reads uninitialised memory: flat normals of GLU_POINT
 * quadrics (the smooth normals here) and of GLU_SILHOUETTE quadrics (those of GLU_LINE here).
 *
 * Each gluX is declared as lgluX, and gluX is mapped to it unless LEGACY_GL_NO_NAMES is defined.
 * The header may be included together with <GL/glu.h>, in either order.
 */
#ifndef LEGACY_GL_GLU_H
#define LEGACY_GL_GLU_H

#include <legacy_gl/gl.h>

#ifndef LEGACY_GL_NO_NAMES
#define gluCylinder lgluCylinder
#define gluDeleteQuadric lgluDeleteQuadric
#define gluDisk lgluDisk
#define gluErrorString lgluErrorString
#define gluGetString lgluGetString
#define gluLookAt lgluLookAt
#define gluNewQuadric lgluNewQuadric
#define gluOrtho2D lgluOrtho2D
#define gluPartialDisk lgluPartialDisk
#define gluPerspective lgluPerspective
#define gluPickMatrix lgluPickMatrix
#define gluProject lgluProject
#define gluQuadricCallback lgluQuadricCallback
#define gluQuadricDrawStyle lgluQuadricDrawStyle
#define gluQuadricNormals lgluQuadricNormals
#define gluQuadricOrientation lgluQuadricOrientation
#define gluQuadricTexture lgluQuadricTexture
#define gluSphere lgluSphere
#define gluUnProject lgluUnProject
#define gluUnProject4 lgluUnProject4
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Booleans, versions and string names. */
#define GLU_FALSE 0
#define GLU_TRUE 1
#define GLU_VERSION_1_1 1
#define GLU_VERSION_1_2 1
#define GLU_VERSION_1_3 1
#define GLU_VERSION 100800
#define GLU_EXTENSIONS 100801

/* Errors. */
#define GLU_INVALID_ENUM 100900
#define GLU_INVALID_VALUE 100901
#define GLU_OUT_OF_MEMORY 100902
#define GLU_INCOMPATIBLE_GL_VERSION 100903
#define GLU_INVALID_OPERATION 100904

/* Quadrics: callback, draw style, normals, orientation. */
#define GLU_ERROR 100103
#define GLU_POINT 100010
#define GLU_LINE 100011
#define GLU_FILL 100012
#define GLU_SILHOUETTE 100013
#define GLU_SMOOTH 100000
#define GLU_FLAT 100001
#define GLU_NONE 100002
#define GLU_OUTSIDE 100020
#define GLU_INSIDE 100021

#ifdef __cplusplus
class GLUquadric;
#else
typedef struct GLUquadric GLUquadric;
#endif
typedef GLUquadric GLUquadricObj;

/* The type of every GLU callback; a GLU_ERROR callback is called as void(GLenum error). */
typedef void(LEGACY_GL_APIENTRY* _GLUfuncptr)(void);

/* --- Matrices, GLU 1.3 section 4.1. Each multiplies the top of the current matrix stack. ---------
 */

/* A projection with the eye at the origin, looking along -z; fov_y_degrees is the whole vertical
 * angle, aspect is width / height, near and far are distances. Nothing happens, and no error is
 * raised, when the aspect is 0, the distances are equal or the angle's sine is 0. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluPerspective(GLdouble fov_y_degrees, GLdouble aspect,
                                                      GLdouble near_distance,
                                                      GLdouble far_distance);

/* A view from the eye towards the centre, with the up vector upwards in the picture. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluLookAt(GLdouble eye_x, GLdouble eye_y, GLdouble eye_z,
                                                 GLdouble center_x, GLdouble center_y,
                                                 GLdouble center_z, GLdouble up_x, GLdouble up_y,
                                                 GLdouble up_z);

/* glOrtho with the depth range -1 to 1. Errors: as glOrtho. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluOrtho2D(GLdouble left, GLdouble right, GLdouble bottom,
                                                  GLdouble top);

/* Restricts drawing to a region of the viewport, width × height pixels around (x, y) in window
 * coordinates. Nothing happens when the width or the height is not positive. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluPickMatrix(GLdouble x, GLdouble y, GLdouble width,
                                                     GLdouble height, GLint* viewport);

/* --- Projection of points, GLU 1.3 section 4.2 ---------------------------------------------------
 */

/* Object to window coordinates. GLU_FALSE, and nothing is written, when the clip w is 0. */
LEGACY_GL_API GLint LEGACY_GL_APIENTRY lgluProject(GLdouble object_x, GLdouble object_y,
                                                   GLdouble object_z, const GLdouble* modelview,
                                                   const GLdouble* projection,
                                                   const GLint* viewport, GLdouble* window_x,
                                                   GLdouble* window_y, GLdouble* window_z);

/* Window to object coordinates. GLU_FALSE, and nothing is written, when projection × modelview is
 * singular or the object w is 0. */
LEGACY_GL_API GLint LEGACY_GL_APIENTRY lgluUnProject(GLdouble window_x, GLdouble window_y,
                                                     GLdouble window_z, const GLdouble* modelview,
                                                     const GLdouble* projection,
                                                     const GLint* viewport, GLdouble* object_x,
                                                     GLdouble* object_y, GLdouble* object_z);

/* The same with a clip w and a depth range, and without the division by the object w; for points
 * of a feedback buffer. GLU_FALSE, and nothing is written, when projection × modelview is singular.
 */
LEGACY_GL_API GLint LEGACY_GL_APIENTRY
lgluUnProject4(GLdouble window_x, GLdouble window_y, GLdouble window_z, GLdouble clip_w,
               const GLdouble* modelview, const GLdouble* projection, const GLint* viewport,
               GLdouble range_near, GLdouble range_far, GLdouble* object_x, GLdouble* object_y,
               GLdouble* object_z, GLdouble* object_w);

/* --- Strings, GLU 1.3 section 2.1 and chapter 8
 * --------------------------------------------------- */

/* The text of a GL or GLU error code; null when it is none. The texts are libGLU's. */
LEGACY_GL_API const GLubyte* LEGACY_GL_APIENTRY lgluErrorString(GLenum error);

/* GLU_VERSION or GLU_EXTENSIONS; null for any other name. */
LEGACY_GL_API const GLubyte* LEGACY_GL_APIENTRY lgluGetString(GLenum name);

/* --- Quadrics, GLU 1.3 chapter 6
 * ------------------------------------------------------------------ The surfaces are made of
 * glBegin/glEnd, so they go into display lists. Wrong arguments call the GLU_ERROR callback, and
 * change and draw nothing. As in libGLU, more than 239 slices, and more than 239 stacks of a
 * sphere, are drawn as 239. */

/* A new quadric: GLU_SMOOTH, GLU_FILL, GLU_OUTSIDE, no texture coordinates. Null when out of
 * memory. */
LEGACY_GL_API GLUquadric* LEGACY_GL_APIENTRY lgluNewQuadric(void);

/* Null is ignored. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluDeleteQuadric(GLUquadric* quadric);

/* GLU_NONE, GLU_FLAT or GLU_SMOOTH. Errors: GLU_INVALID_ENUM. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluQuadricNormals(GLUquadric* quadric, GLenum normals);

/* GLU_FILL, GLU_LINE, GLU_SILHOUETTE or GLU_POINT. Errors: GLU_INVALID_ENUM. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluQuadricDrawStyle(GLUquadric* quadric, GLenum style);

/* GLU_OUTSIDE or GLU_INSIDE: where the normals point. Errors: GLU_INVALID_ENUM. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluQuadricOrientation(GLUquadric* quadric,
                                                             GLenum orientation);

/* Whether texture coordinates are given. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluQuadricTexture(GLUquadric* quadric, GLboolean texture);

/* which is GLU_ERROR; null removes the callback. Errors: GLU_INVALID_ENUM, to the callback in
 * place. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluQuadricCallback(GLUquadric* quadric, GLenum which,
                                                          _GLUfuncptr callback);

/* A sphere around the origin; slices around the z axis, stacks along it.
 * Errors: GLU_INVALID_VALUE when radius < 0, slices < 2 or stacks < 1. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluSphere(GLUquadric* quadric, GLdouble radius, GLint slices,
                                                 GLint stacks);

/* An open cylinder or cone along z, of radius base at z = 0 and top at z = height.
 * Errors: GLU_INVALID_VALUE when base, top or height < 0, when slices < 2 or stacks < 1, or when
 * height = 0 and base = top. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluCylinder(GLUquadric* quadric, GLdouble base, GLdouble top,
                                                   GLdouble height, GLint slices, GLint stacks);

/* A disk at z = 0 with a hole of the inner radius. Its front is towards +z when GLU_OUTSIDE.
 * Errors: GLU_INVALID_VALUE when inner < 0, outer ≤ 0, inner > outer, slices < 2 or loops < 1. */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluDisk(GLUquadric* quadric, GLdouble inner, GLdouble outer,
                                               GLint slices, GLint loops);

/* The part of that disk from start over sweep; 0 is along +y and 90 along +x. Errors: as lgluDisk.
 */
LEGACY_GL_API void LEGACY_GL_APIENTRY lgluPartialDisk(GLUquadric* quadric, GLdouble inner,
                                                      GLdouble outer, GLint slices, GLint loops,
                                                      GLdouble start_degrees,
                                                      GLdouble sweep_degrees);

#ifdef __cplusplus
}
#endif

#endif
