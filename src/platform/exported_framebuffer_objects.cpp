// The driver's framebuffer objects, to which textures of ours are attached by the driver's names.
#define LEGACY_GL_NO_NAMES
#include <GL/gl.h>
#include <GL/glext.h>
#include <legacy_gl/context.h>
#include <legacy_gl/framebuffer_objects.h>

#include "platform/beside_ours.hpp"
#include "platform/export.hpp"

using legacy_gl::platform::BesideOurs;
using legacy_gl::platform::find_gl;

namespace {

GLuint driver_name(GLuint texture) {
  return texture && legacy_gl_get_current() ? legacy_gl_driver_texture(texture) : texture;
}

GLenum driver_target(GLenum target) {
  return legacy_gl_get_current() && target == GL_TEXTURE_1D ? GLenum{GL_TEXTURE_2D} : target;
}

}  // namespace

LEGACY_GL_EXPORT void APIENTRY glFramebufferTexture2D(GLenum target, GLenum attachment,
                                                      GLenum textarget, GLuint texture,
                                                      GLint level) {
  const GLuint name = driver_name(texture);
  const BesideOurs beside;
  LEGACY_GL_CALL_DRIVER(find_gl, void, glFramebufferTexture2D,
                        (target, attachment, driver_target(textarget), name, level));
}

LEGACY_GL_EXPORT void APIENTRY glFramebufferTexture1D(GLenum target, GLenum attachment,
                                                      GLenum textarget, GLuint texture,
                                                      GLint level) {
  if (legacy_gl_get_current())
    return glFramebufferTexture2D(target, attachment, textarget, texture, level);
  LEGACY_GL_CALL_DRIVER(find_gl, void, glFramebufferTexture1D,
                        (target, attachment, textarget, texture, level));
}

LEGACY_GL_EXPORT void APIENTRY glFramebufferTexture3D(GLenum target, GLenum attachment,
                                                      GLenum textarget, GLuint texture, GLint level,
                                                      GLint zoffset) {
  const GLuint name = driver_name(texture);
  const BesideOurs beside;
  LEGACY_GL_CALL_DRIVER(find_gl, void, glFramebufferTexture3D,
                        (target, attachment, textarget, name, level, zoffset));
}

LEGACY_GL_EXPORT void APIENTRY glFramebufferTextureLayer(GLenum target, GLenum attachment,
                                                         GLuint texture, GLint level, GLint layer) {
  const GLuint name = driver_name(texture);
  const BesideOurs beside;
  LEGACY_GL_CALL_DRIVER(find_gl, void, glFramebufferTextureLayer,
                        (target, attachment, name, level, layer));
}

LEGACY_GL_EXPORT void APIENTRY glGenerateMipmap(GLenum target) {
  if (legacy_gl_get_current()) return legacy_gl_generate_mipmap(target);
  LEGACY_GL_CALL_DRIVER(find_gl, void, glGenerateMipmap, (target));
}
