#include "driver/textures.hpp"

#include <cstring>

#include "driver/debug_labels.hpp"

namespace legacy_gl {

namespace {

GLenum driver_target(TextureTarget target) {
  switch (target) {
    case kTexture1D:
    case kTexture2D: return GL_TEXTURE_2D;
    case kTexture3D: return GL_TEXTURE_3D;
    case kTextureCube: return GL_TEXTURE_CUBE_MAP;
  }
  return GL_TEXTURE_2D;
}

/// GL 2.1 spec 3.8.1: where the border's colour lies in the stored channels.
glm::vec4 stored_border(const glm::vec4& color, BaseFormat base) {
  switch (base) {
    case BaseFormat::kAlpha: return {color.a, 0, 0, 0};
    case BaseFormat::kLuminanceAlpha: return {color.r, color.a, 0, 0};
    default: return color;
  }
}

}  // namespace

Textures::Textures(const Driver& driver)
    : driver_(driver), offers_s3tc_(has_extension(driver, "GL_EXT_texture_compression_s3tc")) {
  if (!driver.is_es()) return;
  const auto* const extensions = reinterpret_cast<const char*>(driver.GetString(GL_EXTENSIONS));
  has_border_color_ = extensions && (std::strstr(extensions, "texture_border_clamp") ||
                                     (driver.major == 3 && driver.minor >= 2));
}

void Textures::forget_bindings() {
  bound_ = {};
  active_unit_ = ~0u;
  samplers_unbound_ = false;
}

void Textures::select_unit(unsigned unit) {
  if (active_unit_ != unit) driver_.ActiveTexture(GL_TEXTURE0 + unit);
  active_unit_ = unit;
}

void Textures::bind_unit(unsigned unit, TextureObject& texture) {
  select_unit(unit);
  bool is_new = false;
  const GLuint name = texture.driver_name.get_or_make([this, &is_new] {
    GLuint made = 0;
    driver_.GenTextures(1, &made);
    is_new = true;
    return made;
  });
  driver_.BindTexture(driver_target(texture.target), name);
  if (is_new && driver_.ObjectLabel)
    label(driver_, GL_TEXTURE, name, "texture " + std::to_string(texture.name));
  bound_[unit] = texture.serial;
}

/// Changes go through unit 0.
void Textures::bind_to_change(TextureObject& texture) {
  if (bound_[0] != texture.serial || active_unit_ != 0) bind_unit(0, texture);
}

void Textures::bind(const ActiveTextures& active) {
  for (unsigned unit = 0; unit < active.count; ++unit) {
    TextureObject* const texture = active.textures[unit];
    if (!texture) continue;
    if (bound_[unit] != texture->serial) bind_unit(unit, *texture);
    if (!texture->parameters_stale.load(std::memory_order_relaxed)) continue;
    if (active_unit_ != unit) bind_unit(unit, *texture);
    apply_parameters(*texture);
  }
  if (samplers_unbound_) return;
  samplers_unbound_ = true;
  for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit) driver_.BindSampler(unit, 0);
}

void Textures::apply_parameters(TextureObject& texture) {
  texture.parameters_stale = false;
  const GLenum target = driver_target(texture.target);
  const TextureParameters& parameters = texture.parameters;
  const auto set = [&](GLenum name, GLenum value) {
    driver_.TexParameteri(target, name, static_cast<GLint>(value));
  };
  const auto wrap = [&](unsigned coordinate) -> GLenum {
    const GLenum mode = parameters.wrap[coordinate];
    const bool clamp = mode == GL_CLAMP;
    if (clamp && !filters_linearly(parameters)) return GL_CLAMP_TO_EDGE;
    if (!clamp && mode != GL_CLAMP_TO_BORDER) return mode;
    return has_border_color_ ? GL_CLAMP_TO_BORDER : GL_CLAMP_TO_EDGE;
  };
  set(GL_TEXTURE_MIN_FILTER, parameters.min_filter);
  set(GL_TEXTURE_MAG_FILTER, parameters.mag_filter);
  set(GL_TEXTURE_WRAP_S, wrap(0));
  set(GL_TEXTURE_WRAP_T, texture.target == kTexture1D ? GL_CLAMP_TO_EDGE : wrap(1));
  set(GL_TEXTURE_WRAP_R, wrap(2));
  set(GL_TEXTURE_BASE_LEVEL, static_cast<GLenum>(parameters.base_level));
  set(GL_TEXTURE_MAX_LEVEL, static_cast<GLenum>(parameters.max_level));
  driver_.TexParameterf(target, GL_TEXTURE_MIN_LOD, parameters.min_lod);
  driver_.TexParameterf(target, GL_TEXTURE_MAX_LOD, parameters.max_lod);
  const bool depth = texture.base() == BaseFormat::kDepth;
  set(GL_TEXTURE_COMPARE_MODE, depth ? parameters.compare_mode : GLenum{GL_NONE});
  set(GL_TEXTURE_COMPARE_FUNC, parameters.compare_function);
  if (!has_border_color_) return;
  const glm::vec4 border = stored_border(parameters.border_color, texture.base());
  driver_.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, &border[0]);
}

GLuint Textures::driver_name(TextureObject& texture) {
  bind_to_change(texture);
  if (texture.parameters_stale && texture.complete()) apply_parameters(texture);
  return texture.driver_name.get();
}

GLint Textures::largest_size(TextureTarget target) const {
  GLint size = 0;
  const GLenum name = target == kTexture3D     ? GL_MAX_3D_TEXTURE_SIZE
                      : target == kTextureCube ? GL_MAX_CUBE_MAP_TEXTURE_SIZE
                                               : GL_MAX_TEXTURE_SIZE;
  driver_.GetIntegerv(name, &size);
  return size;
}

bool Textures::fits(TextureTarget target, GLint level, const ImageSize& size) const {
  const GLint largest = largest_size(target) >> level;
  const GLint side = largest > 0 ? largest : 1;
  return size.width <= side && size.height <= side && size.depth <= side;
}

}  // namespace legacy_gl
