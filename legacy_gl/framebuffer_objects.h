#ifndef LEGACY_GL_FRAMEBUFFER_OBJECTS_H
#define LEGACY_GL_FRAMEBUFFER_OBJECTS_H
/** Framebuffer objects of the driver, with textures of ours.
 *
 * glGenFramebuffers and its like are the driver's own functions: legacy_gl_flush before them and
 * legacy_gl_reset_driver_state after them (context.h). Textures have names of ours, and the driver
 * has others for them. */
#include <legacy_gl/gl.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What the driver calls the texture of the current context, to be given to
 * glFramebufferTexture2D. A one-dimensional texture is two-dimensional there. 0 for a name that is
 * no texture. */
LEGACY_GL_API GLuint LEGACY_GL_APIENTRY legacy_gl_driver_texture(GLuint texture);

/** Whether the texture can be drawn into: not one with an alpha of its own beside or without
 * luminance, which the driver stores in other channels than a fragment's. EXT_framebuffer_object
 * asks for RGB, RGBA and depths alone. */
LEGACY_GL_API GLboolean LEGACY_GL_APIENTRY legacy_gl_is_renderable(GLuint texture);

/** glGenerateMipmap of the texture that is bound to `target` in the active unit. */
LEGACY_GL_API void LEGACY_GL_APIENTRY legacy_gl_generate_mipmap(GLenum target);

/** Names that glGetString(GL_EXTENSIONS) gives besides, where the driver has them: for those who
 * offer the driver's functions beside ours. Separated by blanks; `NAME=OTHER` is a name that is
 * given where the driver has the other. The text is copied. */
LEGACY_GL_API void LEGACY_GL_APIENTRY legacy_gl_offer_extensions(const char* names);

#ifdef __cplusplus
}
#endif

#endif
