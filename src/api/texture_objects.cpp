// GL 2.1 spec 3.8.12: texture objects.
#include "api/texture_targets.hpp"
#include "dlist/dispatch.hpp"
#include "driver/driver_objects.hpp"
#include "record/pending.hpp"
#include "submit/prepare.hpp"

using namespace legacy_gl;

namespace {

void bind_to_unit(Context& c, TextureUnit& unit, const TexturePointer& texture) {
  TexturePointer& bound = unit.bound[texture->target];
  // What another context changed shows after binding (GL 2.1 spec D.3).
  const bool shared = c.texture.shared.use_count() > 1;
  if (bound == texture && !shared) return;
  if (unit.enabled[texture->target]) before_texture_change(c);
  bound = texture;
}

void gen_textures(Context& c, GLsizei n, GLuint* names) {
  if (refused_inside(c)) return;
  if (n < 0) return raise_error(c, GL_INVALID_VALUE);
  for (GLsizei i = 0; names && i < n; ++i) names[i] = c.texture.shared->names.generate(1, nullptr);
}

TexturePointer find_or_create(SharedTextures& textures, GLuint name, TextureTarget target) {
  return textures.names.find_or_create(
      name, [&](bool) { return std::make_shared<TextureObject>(name, target, textures.deleted); });
}

void bind_texture(Context& c, GLenum name_of_target, GLuint name) {
  if (refused_inside(c)) return;
  const std::optional<TextureTarget> target = texture_target(name_of_target);
  if (!target) return raise_error(c, GL_INVALID_ENUM);
  const TexturePointer texture =
      name ? find_or_create(*c.texture.shared, name, *target) : c.texture.defaults[*target];
  if (texture->target != *target) return raise_error(c, GL_INVALID_OPERATION);
  bind_to_unit(c, active_unit(c), texture);
}

void delete_textures(Context& c, GLsizei n, const GLuint* names) {
  if (refused_inside(c)) return;
  if (n < 0) return raise_error(c, GL_INVALID_VALUE);
  for (GLsizei i = 0; names && i < n; ++i) {
    if (const TexturePointer texture = c.texture.shared->names.find(names[i]))
      for (TextureUnit& unit : c.texture.units)
        if (unit.bound[texture->target] == texture)
          bind_to_unit(c, unit, c.texture.defaults[texture->target]);
    if (names[i]) c.texture.shared->names.erase(names[i], 1);
  }
  free_deleted(c);
}

GLboolean is_texture(Context& c, GLuint name) {
  if (refused_inside(c)) return GL_FALSE;
  return c.texture.shared->names.find(name) ? GL_TRUE : GL_FALSE;
}

/// All textures are where the driver keeps them; `residences` is then left alone.
GLboolean are_textures_resident(Context& c, GLsizei n, const GLuint* names) {
  if (refused_inside(c)) return GL_FALSE;
  bool valid = n >= 0;
  for (GLsizei i = 0; valid && names && i < n; ++i)
    valid = c.texture.shared->names.find(names[i]) != nullptr;
  if (valid) return GL_TRUE;
  raise_error(c, GL_INVALID_VALUE);
  return GL_FALSE;
}

void check_count(Context& c, GLsizei n) {
  if (refused_inside(c)) return;
  if (n < 0) raise_error(c, GL_INVALID_VALUE);
}

void prioritize(Context& c, GLuint name, float priority) {
  if (c.recorder.inside_begin_end()) return;  // check_count has said it
  if (const TexturePointer texture = c.texture.shared->names.find(name))
    texture->parameters.priority = std::clamp(priority, 0.0f, 1.0f);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglGenTextures(GLsizei n, GLuint* textures) {
  execute_now<gen_textures>(n, textures);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglBindTexture(GLenum target, GLuint texture) {
  dispatch<bind_texture>(target, texture);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDeleteTextures(GLsizei n, const GLuint* textures) {
  execute_now<delete_textures>(n, textures);
}
LEGACY_GL_API GLboolean LEGACY_GL_APIENTRY lglIsTexture(GLuint texture) {
  return execute_now<is_texture>(texture);
}
LEGACY_GL_API GLboolean LEGACY_GL_APIENTRY lglAreTexturesResident(GLsizei n, const GLuint* textures,
                                                                  GLboolean*) {
  return execute_now<are_textures_resident>(n, textures);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPrioritizeTextures(GLsizei n, const GLuint* textures,
                                                            const GLfloat* priorities) {
  dispatch<check_count>(n);
  for (GLsizei i = 0; textures && priorities && i < n; ++i)
    dispatch<prioritize>(textures[i], priorities[i]);
}
