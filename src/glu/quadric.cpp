#include "glu/quadric.hpp"

#include <new>

LEGACY_GL_API GLUquadric* LEGACY_GL_APIENTRY lgluNewQuadric(void) {
  return new (std::nothrow) GLUquadric;
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluDeleteQuadric(GLUquadric* quadric) { delete quadric; }

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluQuadricNormals(GLUquadric* quadric, GLenum normals) {
  if (normals != GLU_NONE && normals != GLU_FLAT && normals != GLU_SMOOTH) {
    quadric->report(GLU_INVALID_ENUM);
    return;
  }
  quadric->normals = normals;
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluQuadricDrawStyle(GLUquadric* quadric, GLenum style) {
  if (style != GLU_FILL && style != GLU_LINE && style != GLU_SILHOUETTE && style != GLU_POINT) {
    quadric->report(GLU_INVALID_ENUM);
    return;
  }
  quadric->draw_style = style;
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluQuadricOrientation(GLUquadric* quadric,
                                                             GLenum orientation) {
  if (orientation != GLU_OUTSIDE && orientation != GLU_INSIDE) {
    quadric->report(GLU_INVALID_ENUM);
    return;
  }
  quadric->orientation = orientation;
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluQuadricTexture(GLUquadric* quadric, GLboolean texture) {
  quadric->has_texture = texture != GLU_FALSE;
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lgluQuadricCallback(GLUquadric* quadric, GLenum which,
                                                          _GLUfuncptr callback) {
  if (which != GLU_ERROR) {
    quadric->report(GLU_INVALID_ENUM);
    return;
  }
  quadric->error_callback = reinterpret_cast<GLUquadric::ErrorCallback>(callback);
}
