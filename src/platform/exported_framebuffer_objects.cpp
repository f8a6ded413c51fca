// The driver's framebuffer objects, to which textures of ours are attached by the driver's names.
#define GL_GLEXT_PROTOTYPES
#define LEGACY_GL_NO_NAMES
#include <GL/gl.h>
#include <GL/glext.h>
#include <legacy_gl/context.h>
#include <legacy_gl/framebuffer_objects.h>

#include <array>
#include <map>
#include <mutex>
#include <set>

#include "platform/beside_ours.hpp"
#include "platform/export.hpp"

using legacy_gl::platform::BesideOurs;
using legacy_gl::platform::find_gl;

namespace {

/// The driver's names of textures that were attached and cannot be drawn into.
std::mutex names_mutex;
std::set<GLuint>& unrenderable() {
  static auto& names = *new std::set<GLuint>;  // never destroyed: a program may call until its end
  return names;
}

/// Textures that were attached, by the driver's names.
std::map<GLuint, GLuint>& attached() {
  static auto& names = *new std::map<GLuint, GLuint>;
  return names;
}

GLuint driver_name(GLuint texture) {
  if (!texture || !legacy_gl_get_current()) return texture;
  const GLuint name = legacy_gl_driver_texture(texture);
  const std::lock_guard lock(names_mutex);
  attached()[name] = texture;
  if (legacy_gl_is_renderable(texture)) unrenderable().erase(name);
  else unrenderable().insert(name);
  return name;
}

/// Of the framebuffer object that the driver has bound.
bool has_unrenderable_texture(GLenum target) {
  const std::lock_guard lock(names_mutex);
  if (unrenderable().empty()) return false;
  const auto ask = reinterpret_cast<decltype(&glGetFramebufferAttachmentParameteriv)>(
      find_gl("glGetFramebufferAttachmentParameteriv"));
  GLint attachments = 0;
  glGetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &attachments);
  for (GLint i = 0; i < attachments; ++i) {
    const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
    GLint type = GL_NONE, name = 0;
    ask(target, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
    if (type != GL_TEXTURE) continue;
    ask(target, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
    if (unrenderable().contains(static_cast<GLuint>(name))) return true;
  }
  return false;
}

GLenum framebuffer_status(GLenum target) {
  const BesideOurs beside;
  LEGACY_GL_CALL_DRIVER(find_gl, GLenum, glCheckFramebufferStatus, (target));
}

GLenum driver_target(GLenum target) {
  return legacy_gl_get_current() && target == GL_TEXTURE_1D ? GLenum{GL_TEXTURE_2D} : target;
}

struct Names {
  GLenum binding;  ///< what glGetIntegerv calls the one that is bound
  void(APIENTRY* bind)(GLenum, GLuint);
  void(APIENTRY* generate)(GLsizei, GLuint*);
  void(APIENTRY* remove)(GLsizei, const GLuint*);
};

bool is_bound(const Names& names, GLuint name) {
  GLint bound = 0;
  glGetIntegerv(names.binding, &bound);
  return static_cast<GLuint>(bound) == name;
}

/// EXT_framebuffer_object binds names that nobody generated, which the core profile refuses: they
/// are generated then. Drivers give the lowest names that are free, so a small one comes soon; what
/// does not come stays refused.
void bind_any_name(const Names& names, GLenum target, GLuint name) {
  names.bind(target, name);
  if (!name || !legacy_gl_get_current() || is_bound(names, name)) return;
  std::array<GLuint, 256> others{};
  GLsizei count = 0;
  GLuint generated = 0;
  while (generated != name && count < static_cast<GLsizei>(others.size())) {
    names.generate(1, &generated);
    if (generated == 0) break;
    if (generated != name) others[static_cast<unsigned>(count++)] = generated;
  }
  names.remove(count, others.data());
  if (generated != name) return;
  glGetError();  // of the first attempt
  names.bind(target, name);
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

LEGACY_GL_EXPORT GLenum APIENTRY glCheckFramebufferStatus(GLenum target) {
  const GLenum status = framebuffer_status(target);
  return status == GL_FRAMEBUFFER_COMPLETE && legacy_gl_get_current() &&
                 has_unrenderable_texture(target)
             ? GLenum{GL_FRAMEBUFFER_UNSUPPORTED}
             : status;
}

LEGACY_GL_EXPORT void APIENTRY glGetFramebufferAttachmentParameteriv(GLenum target,
                                                                     GLenum attachment, GLenum name,
                                                                     GLint* values) {
  const auto ask = reinterpret_cast<decltype(&glGetFramebufferAttachmentParameteriv)>(
      find_gl("glGetFramebufferAttachmentParameteriv"));
  if (!ask) return;
  const BesideOurs beside;
  ask(target, attachment, name, values);
  if (name != GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME || !values || !legacy_gl_get_current()) return;
  GLint type = GL_NONE;
  ask(target, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
  if (type != GL_TEXTURE) return;
  const std::lock_guard lock(names_mutex);
  if (const auto own = attached().find(static_cast<GLuint>(*values)); own != attached().end())
    *values = static_cast<GLint>(own->second);
}

LEGACY_GL_EXPORT void APIENTRY glGenerateMipmap(GLenum target) {
  if (legacy_gl_get_current()) return legacy_gl_generate_mipmap(target);
  LEGACY_GL_CALL_DRIVER(find_gl, void, glGenerateMipmap, (target));
}

// EXT_framebuffer_object, EXT_framebuffer_blit, EXT_framebuffer_multisample: the core profile has
// them under their later names alone.
LEGACY_GL_EXPORT void APIENTRY glBindFramebufferEXT(GLenum target, GLuint framebuffer) {
  const GLenum binding =
      target == GL_READ_FRAMEBUFFER ? GL_READ_FRAMEBUFFER_BINDING : GL_DRAW_FRAMEBUFFER_BINDING;
  bind_any_name({binding, &glBindFramebuffer, &glGenFramebuffers, &glDeleteFramebuffers}, target,
                framebuffer);
}

LEGACY_GL_EXPORT void APIENTRY glBindRenderbufferEXT(GLenum target, GLuint renderbuffer) {
  bind_any_name(
      {GL_RENDERBUFFER_BINDING, &glBindRenderbuffer, &glGenRenderbuffers, &glDeleteRenderbuffers},
      target, renderbuffer);
}

#define LEGACY_GL_ALSO_EXT(result, name, parameters, arguments) \
  LEGACY_GL_EXPORT result APIENTRY name##EXT parameters { return name arguments; }
LEGACY_GL_ALSO_EXT(GLboolean, glIsRenderbuffer, (GLuint renderbuffer), (renderbuffer))
LEGACY_GL_ALSO_EXT(GLboolean, glIsFramebuffer, (GLuint framebuffer), (framebuffer))
LEGACY_GL_ALSO_EXT(void, glDeleteRenderbuffers, (GLsizei n, const GLuint* names), (n, names))
LEGACY_GL_ALSO_EXT(void, glDeleteFramebuffers, (GLsizei n, const GLuint* names), (n, names))
LEGACY_GL_ALSO_EXT(void, glGenRenderbuffers, (GLsizei n, GLuint* names), (n, names))
LEGACY_GL_ALSO_EXT(void, glGenFramebuffers, (GLsizei n, GLuint* names), (n, names))
LEGACY_GL_ALSO_EXT(void, glRenderbufferStorage,
                   (GLenum target, GLenum format, GLsizei width, GLsizei height),
                   (target, format, width, height))
LEGACY_GL_ALSO_EXT(void, glRenderbufferStorageMultisample,
                   (GLenum target, GLsizei samples, GLenum format, GLsizei width, GLsizei height),
                   (target, samples, format, width, height))
LEGACY_GL_ALSO_EXT(void, glGetRenderbufferParameteriv, (GLenum target, GLenum name, GLint* values),
                   (target, name, values))
LEGACY_GL_ALSO_EXT(GLenum, glCheckFramebufferStatus, (GLenum target), (target))
LEGACY_GL_ALSO_EXT(void, glFramebufferTexture1D,
                   (GLenum target, GLenum attachment, GLenum textarget, GLuint texture,
                    GLint level),
                   (target, attachment, textarget, texture, level))
LEGACY_GL_ALSO_EXT(void, glFramebufferTexture2D,
                   (GLenum target, GLenum attachment, GLenum textarget, GLuint texture,
                    GLint level),
                   (target, attachment, textarget, texture, level))
LEGACY_GL_ALSO_EXT(void, glFramebufferTexture3D,
                   (GLenum target, GLenum attachment, GLenum textarget, GLuint texture, GLint level,
                    GLint zoffset),
                   (target, attachment, textarget, texture, level, zoffset))
LEGACY_GL_ALSO_EXT(void, glFramebufferRenderbuffer,
                   (GLenum target, GLenum attachment, GLenum renderbuffertarget,
                    GLuint renderbuffer),
                   (target, attachment, renderbuffertarget, renderbuffer))
LEGACY_GL_ALSO_EXT(void, glGetFramebufferAttachmentParameteriv,
                   (GLenum target, GLenum attachment, GLenum name, GLint* values),
                   (target, attachment, name, values))
LEGACY_GL_ALSO_EXT(void, glGenerateMipmap, (GLenum target), (target))
LEGACY_GL_ALSO_EXT(void, glBlitFramebuffer,
                   (GLint x0, GLint y0, GLint x1, GLint y1, GLint to_x0, GLint to_y0, GLint to_x1,
                    GLint to_y1, GLbitfield mask, GLenum filter),
                   (x0, y0, x1, y1, to_x0, to_y0, to_x1, to_y1, mask, filter))
