/* The one switch between the two builds of scene.c and shapes.c. */
#ifndef OLD_GL_H
#define OLD_GL_H

#ifdef LIGHTING_WITH_LEGACY_GL
#include <legacy_gl/gl.h>
#include <legacy_gl/glu.h>
#define OLD_GL_NAME(name) name##_by_legacy_gl
#else
#include <GL/gl.h>
#include <GL/glu.h>
#define OLD_GL_NAME(name) name##_by_mesa
#endif

/* Both builds are linked into one program, so each gets names of its own. */
#define draw_scene OLD_GL_NAME(draw_scene)
#define draw_sphere OLD_GL_NAME(draw_sphere)
#define draw_cube OLD_GL_NAME(draw_cube)
#define draw_torus OLD_GL_NAME(draw_torus)
#define draw_floor OLD_GL_NAME(draw_floor)

#endif
