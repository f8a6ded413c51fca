// GL 2.1 spec 6.1.3, 6.1.4: glGetTexParameter, glGetTexLevelParameter, glGetTexImage.
#include <algorithm>
#include <array>
#include <cstring>

#include "api/texture_image_rules.hpp"
#include "dlist/dispatch.hpp"
#include "execute/queries.hpp"
#include "record/pending.hpp"
#include "texture/compressed_format.hpp"
#include "texture/pixel_format.hpp"

using namespace legacy_gl;

namespace {

bool read_parameter(const TextureParameters& p, GLenum name, QueryValues& v) {
  v.kind = ValueKind::kInteger;
  const auto real = [&v](float value) {
    v.kind = ValueKind::kFloat;
    v.put(static_cast<double>(value));
  };
  switch (name) {
    case GL_TEXTURE_MIN_FILTER: v.put(p.min_filter); return true;
    case GL_TEXTURE_MAG_FILTER: v.put(p.mag_filter); return true;
    case GL_TEXTURE_WRAP_S: v.put(p.wrap[0]); return true;
    case GL_TEXTURE_WRAP_T: v.put(p.wrap[1]); return true;
    case GL_TEXTURE_WRAP_R: v.put(p.wrap[2]); return true;
    case GL_TEXTURE_BORDER_COLOR:
      v.kind = ValueKind::kNormalised;
      v.put(p.border_color);
      return true;
    case GL_TEXTURE_PRIORITY:
      v.kind = ValueKind::kNormalised;
      v.put(static_cast<double>(p.priority));
      return true;
    case GL_TEXTURE_RESIDENT: v.put(1); return true;
    case GL_TEXTURE_MIN_LOD: real(p.min_lod); return true;
    case GL_TEXTURE_MAX_LOD: real(p.max_lod); return true;
    case GL_TEXTURE_LOD_BIAS: real(p.lod_bias); return true;
    case GL_TEXTURE_BASE_LEVEL: v.put(p.base_level); return true;
    case GL_TEXTURE_MAX_LEVEL: v.put(p.max_level); return true;
    case GL_GENERATE_MIPMAP: v.put(p.generate_mipmap); return true;
    case GL_DEPTH_TEXTURE_MODE: v.put(p.depth_mode); return true;
    case GL_TEXTURE_COMPARE_MODE: v.put(p.compare_mode); return true;
    case GL_TEXTURE_COMPARE_FUNC: v.put(p.compare_function); return true;
    default: return false;
  }
}

bool is_size_name(GLenum name) {
  switch (name) {
    case GL_TEXTURE_RED_SIZE:
    case GL_TEXTURE_GREEN_SIZE:
    case GL_TEXTURE_BLUE_SIZE:
    case GL_TEXTURE_ALPHA_SIZE:
    case GL_TEXTURE_LUMINANCE_SIZE:
    case GL_TEXTURE_INTENSITY_SIZE:
    case GL_TEXTURE_DEPTH_SIZE: return true;
    default: return false;
  }
}

/// A proxy has no texels that the driver could be asked about: the bits that such a texture gets.
GLint size_of(Context& c, const ImageTarget& target, GLint level, const TextureImage& image,
              GLenum name) {
  const int channel = image.exists() ? stored_channel(image.format.base, name) : -1;
  if (channel < 0) return 0;
  const auto index = static_cast<unsigned>(channel);
  if (target.proxy) return es_channel_bits(image.format.es)[index];
  return c.driver->textures.channel_bits({bound_texture(c, target.target), target.face, level},
                                         index);
}

GLenum read_level(Context& c, const ImageTarget& target, GLint level, GLenum name, GLint& value) {
  const TextureImages& images =
      target.proxy ? c.texture.proxies[target.target] : bound_texture(c, target.target).images;
  const TextureImage& image = images.at(target.face, level);
  switch (name) {
    case GL_TEXTURE_WIDTH: value = image.width; break;
    case GL_TEXTURE_HEIGHT: value = image.height; break;
    case GL_TEXTURE_DEPTH: value = image.depth; break;
    case GL_TEXTURE_INTERNAL_FORMAT: value = image.internal_format; break;
    case GL_TEXTURE_BORDER: value = 0; break;
    case GL_TEXTURE_COMPRESSED: value = bytes_of_block(image.internal_format) != 0; break;
    case GL_TEXTURE_COMPRESSED_IMAGE_SIZE:
      if (target.proxy || !bytes_of_block(image.internal_format)) return GL_INVALID_OPERATION;
      value = static_cast<GLint>(compressed_size(image.internal_format, image.width, image.height));
      break;
    default:
      if (!is_size_name(name)) return GL_INVALID_ENUM;
      value = size_of(c, target, level, image, name);
  }
  return GL_NO_ERROR;
}

template <typename T>
void get_tex_parameter(Context& c, GLenum target_name, GLenum name, T* results) {
  if (refused_inside(c)) return;
  const std::optional<TextureTarget> target = texture_target(target_name);
  QueryValues values;
  if (!target || !read_parameter(bound_texture(c, *target).parameters, name, values))
    return raise_error(c, GL_INVALID_ENUM);
  for (unsigned i = 0; results && i < values.count; ++i) {
    if constexpr (std::is_same_v<T, GLint>) results[i] = as_integer(values.kind, values.values[i]);
    else results[i] = static_cast<T>(values.values[i]);
  }
}

template <typename T>
void get_tex_level_parameter(Context& c, GLenum target_name, GLint level, GLenum name, T* result) {
  if (refused_inside(c)) return;
  const std::optional<ImageTarget> target = image_target(target_name, 0);
  if (!target) return raise_error(c, GL_INVALID_ENUM);
  if (const GLenum error = level_error(c, *target, level)) return raise_error(c, error);
  GLint value = 0;
  if (const GLenum error = read_level(c, *target, level, name, value)) return raise_error(c, error);
  if (result) *result = static_cast<T>(value);
}

void pack_image(const PixelStore& store, const ImageSize& size, GLenum format, GLenum type,
                const std::vector<float>& colors, std::byte* pixels) {
  const ImageRows rows = image_rows(store, size, format, type);
  const auto width = static_cast<std::size_t>(size.width);
  const float* from = colors.data();
  for (std::size_t image = 0; image < static_cast<std::size_t>(size.depth); ++image)
    for (std::size_t row = 0; row < static_cast<std::size_t>(size.height); ++row, from += width * 4)
      pack_colors(from, width, format, type, store.swap_bytes, pixels + rows(image, row));
}

void pack_words(const PixelStore& store, const ImageSize& size, const std::vector<GLuint>& words,
                std::byte* pixels) {
  const ImageRows rows = image_rows(store, size, kDepthStencil, kUnsignedInt24_8);
  const auto width = static_cast<std::size_t>(size.width);
  const GLuint* from = words.data();
  for (std::size_t row = 0; row < static_cast<std::size_t>(size.height); ++row)
    for (std::size_t x = 0; x < width; ++x, ++from) {
      std::array<std::byte, sizeof(GLuint)> bytes;
      std::memcpy(bytes.data(), from, bytes.size());
      if (store.swap_bytes) std::reverse(bytes.begin(), bytes.end());
      std::memcpy(pixels + rows(0, row) + x * bytes.size(), bytes.data(), bytes.size());
    }
}

void get_tex_image(Context& c, GLenum target_name, GLint level, GLenum format, GLenum type,
                   void* pixels) {
  if (refused_inside(c)) return;
  const std::optional<ImageTarget> target = image_target(target_name, 0);
  if (!target || target->proxy) return raise_error(c, GL_INVALID_ENUM);
  if (const GLenum error = level_error(c, *target, level)) return raise_error(c, error);
  if (format == GL_STENCIL_INDEX) return raise_error(c, GL_INVALID_ENUM);
  if (const GLenum error = pixel_rectangle_error(format, type)) return raise_error(c, error);
  const ImagePlace place{bound_texture(c, target->target), target->face, level};
  const TextureImage& image = place.texture.images.at(place.face, place.level);
  if (!image.exists()) return;
  const bool depth = image.format.base == BaseFormat::kDepth;
  const bool words = format == kDepthStencil;
  if (words && image.format.core != kDepth24Stencil8) return raise_error(c, GL_INVALID_OPERATION);
  if (format == GL_COLOR_INDEX || depth != (words || format == GL_DEPTH_COMPONENT))
    return raise_error(c, GL_INVALID_OPERATION);
  if (depth && c.driver->functions.is_es()) {
    diagnose(c, "glGetTexImage: this driver (OpenGL ES) reads colours alone");
    return raise_error(c, GL_INVALID_OPERATION);
  }
  if (!pixels || refuses_texels(c, image)) return;
  PixelStore store = c.pack;
  if (target->target != kTexture3D) store.skip_images = store.image_height = 0;
  flush_pending(c);
  const ImageSize size{image.width, image.height, image.depth};
  if (words)
    return pack_words(store, size, c.driver->textures.read_depth_stencil(place),
                      static_cast<std::byte*>(pixels));
  std::vector<float> colors = c.driver->textures.read(place);
  // Luminance is the red component here, and not a sum as glReadPixels has it.
  if (format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA)
    for (std::size_t i = 0; i < colors.size(); i += 4) colors[i + 1] = colors[i + 2] = 0;
  pack_image(store, size, format, type, colors, static_cast<std::byte*>(pixels));
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetTexParameterfv(GLenum target, GLenum pname,
                                                           GLfloat* params) {
  execute_now<get_tex_parameter<GLfloat>>(target, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetTexParameteriv(GLenum target, GLenum pname,
                                                           GLint* params) {
  execute_now<get_tex_parameter<GLint>>(target, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetTexLevelParameterfv(GLenum target, GLint level,
                                                                GLenum pname, GLfloat* params) {
  execute_now<get_tex_level_parameter<GLfloat>>(target, level, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetTexLevelParameteriv(GLenum target, GLint level,
                                                                GLenum pname, GLint* params) {
  execute_now<get_tex_level_parameter<GLint>>(target, level, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetTexImage(GLenum target, GLint level, GLenum format,
                                                     GLenum type, void* pixels) {
  execute_now<get_tex_image>(target, level, format, type, pixels);
}
