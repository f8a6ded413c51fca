// legacy_gl/framebuffer_objects.h: what the driver's framebuffer objects need to know of textures.
#include <legacy_gl/framebuffer_objects.h>

#include <sstream>

#include "api/extensions.hpp"
#include "api/texture_image_rules.hpp"
#include "dlist/dispatch.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

GLuint driver_texture(Context& c, GLuint name) {
  const TexturePointer texture = name ? c.texture.shared->names.find(name) : nullptr;
  if (!texture) return 0;
  flush_pending(c);
  return c.driver->textures.driver_name(*texture);
}

GLboolean is_renderable(Context& c, GLuint name) {
  const TexturePointer texture = name ? c.texture.shared->names.find(name) : nullptr;
  if (!texture) return GL_FALSE;
  const BaseFormat base = texture->base();
  return base != BaseFormat::kAlpha && base != BaseFormat::kLuminanceAlpha ? GL_TRUE : GL_FALSE;
}

void generate_mipmap(Context& c, GLenum target_name) {
  if (refused_inside(c)) return;
  const std::optional<TextureTarget> target = texture_target(target_name);
  if (!target) return raise_error(c, GL_INVALID_ENUM);
  TextureObject& texture = bound_texture(c, *target);
  TextureParameters base_only = texture.parameters;
  base_only.min_filter = GL_LINEAR;
  if (!texture.images.complete(base_only)) return raise_error(c, GL_INVALID_OPERATION);
  before_texture_change(c);
  c.driver->textures.generate_mipmap(texture);
}

void offer_extensions(Context& c, const char* names) {
  c.extensions = extension_names(c.driver->functions);
  std::istringstream words(names ? names : "");
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const std::string needed = equals == std::string::npos ? name : word.substr(equals + 1);
    if (driver_has_extension(c.driver->functions, needed)) c.extensions += ' ' + name;
  }
}

}  // namespace

LEGACY_GL_API GLuint LEGACY_GL_APIENTRY legacy_gl_driver_texture(GLuint texture) {
  return execute_now<driver_texture>(texture);
}
LEGACY_GL_API GLboolean LEGACY_GL_APIENTRY legacy_gl_is_renderable(GLuint texture) {
  return execute_now<is_renderable>(texture);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY legacy_gl_generate_mipmap(GLenum target) {
  execute_now<generate_mipmap>(target);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY legacy_gl_offer_extensions(const char* names) {
  execute_now<offer_extensions>(names);
}
