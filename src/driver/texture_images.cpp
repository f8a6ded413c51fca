// Images of textures: to the driver, from the framebuffer, and back.
#include <algorithm>

#include "driver/textures.hpp"
#include "texture/pixel_format.hpp"

namespace legacy_gl {

namespace {

GLenum image_target(const ImagePlace& place) {
  switch (place.texture.target) {
    case kTexture3D: return GL_TEXTURE_3D;
    case kTextureCube: return GL_TEXTURE_CUBE_MAP_POSITIVE_X + place.face;
    default: return GL_TEXTURE_2D;
  }
}

GLenum texture_target(TextureTarget target) {
  if (target == kTexture3D) return GL_TEXTURE_3D;
  return target == kTextureCube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
}

GLenum transfer_format(BaseFormat base) {
  if (base == BaseFormat::kDepth) return GL_DEPTH_COMPONENT;
  switch (stored_components(base)) {
    case 1: return GL_RED;
    case 2: return GL_RG;
    case 3: return GL_RGB;
    default: return GL_RGBA;
  }
}

GLenum transfer_type(Texels::Type type) {
  switch (type) {
    case Texels::Type::kBytes: return GL_UNSIGNED_BYTE;
    case Texels::Type::kFloats: return GL_FLOAT;
    case Texels::Type::kDepths: return GL_UNSIGNED_INT;
  }
  return GL_UNSIGNED_BYTE;
}

GLenum storage_format(const Driver& driver, const TextureFormat& format) {
  return driver.is_es() ? format.es : format.core;
}

/// The driver's framebuffer has what the texture stores, in the same channels.
bool driver_copies(const Driver& driver, BaseFormat base) {
  switch (base) {
    case BaseFormat::kAlpha:
    case BaseFormat::kLuminanceAlpha: return false;
    case BaseFormat::kDepth: return true;
    default: return !driver.is_es();  // OpenGL ES refuses formats that do not fit
  }
}

/// GL_DEPTH_COMPONENT has the depth in all bits of the word, GL_DEPTH_STENCIL in the upper 24.
bool has_stencil(const TextureFormat& format) { return format.core == GL_DEPTH24_STENCIL8; }

struct Transfer {
  GLenum format, type;
};
Transfer transfer_of(const TextureFormat& format, Texels::Type type) {
  if (has_stencil(format)) return {GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8};
  return {transfer_format(format.base), transfer_type(type)};
}

/// Depths as the red of colours.
std::vector<float> spread_depths(const std::vector<float>& depths) {
  std::vector<float> colors(depths.size() * 4);
  for (std::size_t i = 0; i < depths.size(); ++i) colors[i * 4] = depths[i];
  return colors;
}

}  // namespace

void set_unpack_modes(const Driver& driver) {
  driver.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  driver.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  driver.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  driver.PixelStorei(GL_UNPACK_SKIP_ROWS, 0);
  driver.PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
  driver.PixelStorei(GL_UNPACK_IMAGE_HEIGHT, 0);
  driver.PixelStorei(GL_UNPACK_SKIP_IMAGES, 0);
}

bool Textures::define(const ImagePlace& place, const TextureImage& image, const Texels* texels) {
  bind_to_change(place.texture);
  set_unpack_modes(driver_);
  place.texture.images.at(place.face, place.level) = image;
  place.texture.parameters_stale = true;
  const auto storage = static_cast<GLint>(storage_format(driver_, image.format));
  Texels::Type type = Texels::Type::kBytes;
  if (image.format.base == BaseFormat::kDepth) type = Texels::Type::kDepths;
  if (texels) type = texels->type;
  const void* const data = texels ? texels->data.data() : nullptr;
  forget_errors(driver_);
  const Transfer transfer = transfer_of(image.format, type);
  if (place.texture.target == kTexture3D)
    driver_.TexImage3D(GL_TEXTURE_3D, place.level, storage, image.width, image.height, image.depth,
                       0, transfer.format, transfer.type, data);
  else
    driver_.TexImage2D(image_target(place), place.level, storage, image.width, image.height, 0,
                       transfer.format, transfer.type, data);
  if (driver_.GetError() == GL_NO_ERROR) return true;
  place.texture.images.at(place.face, place.level) = {};
  return false;
}

bool Textures::define_compressed(const ImagePlace& place, const TextureImage& image,
                                 const void* data, GLsizei bytes) {
  bind_to_change(place.texture);
  set_unpack_modes(driver_);
  place.texture.images.at(place.face, place.level) = image;
  place.texture.parameters_stale = true;
  const std::vector<std::byte> blank(data ? 0 : static_cast<std::size_t>(bytes));
  forget_errors(driver_);
  driver_.CompressedTexImage2D(image_target(place), place.level,
                               static_cast<GLenum>(image.internal_format), image.width,
                               image.height, 0, bytes, data ? data : blank.data());
  if (driver_.GetError() == GL_NO_ERROR) return true;
  place.texture.images.at(place.face, place.level) = {};
  return false;
}

void Textures::replace_compressed(const ImagePlace& place, const ImageOffset& offset,
                                  const ImageSize& size, const void* data, GLsizei bytes) {
  bind_to_change(place.texture);
  set_unpack_modes(driver_);
  const GLint format = place.texture.images.at(place.face, place.level).internal_format;
  driver_.CompressedTexSubImage2D(image_target(place), place.level, offset.x, offset.y, size.width,
                                  size.height, static_cast<GLenum>(format), bytes, data);
}

void Textures::read_compressed(const ImagePlace& place, void* data) {
  bind_to_change(place.texture);
  driver_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  driver_.GetCompressedTexImage(image_target(place), place.level, data);
}

void Textures::replace(const ImagePlace& place, const ImageOffset& offset, const ImageSize& size,
                       const Texels& texels) {
  bind_to_change(place.texture);
  set_unpack_modes(driver_);
  const auto [format, type] =
      transfer_of(place.texture.images.at(place.face, place.level).format, texels.type);
  if (place.texture.target == kTexture3D)
    driver_.TexSubImage3D(GL_TEXTURE_3D, place.level, offset.x, offset.y, offset.z, size.width,
                          size.height, size.depth, format, type, texels.data.data());
  else
    driver_.TexSubImage2D(image_target(place), place.level, offset.x, offset.y, size.width,
                          size.height, format, type, texels.data.data());
}

void Textures::copy(const ImagePlace& place, const ImageOffset& offset, const PixelRectangle& from,
                    const PixelState& transfer) {
  const BaseFormat base = place.texture.images.at(place.face, place.level).format.base;
  const bool depth = base == BaseFormat::kDepth;
  const bool changes = depth ? transfer.changes_depths() : transfer.changes_colors();
  if (changes || !driver_copies(driver_, base)) {
    driver_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    std::vector<float> colors =
        depth ? read_depths(driver_, from, transfer) : read_colors(driver_, from, transfer);
    if (depth) colors = spread_depths(colors);
    replace(place, offset, {from.width, from.height, 1},
            texels_of_colors(colors, base, takes_bytes_only()));
    return;
  }
  bind_to_change(place.texture);
  if (place.texture.target == kTexture3D)
    driver_.CopyTexSubImage3D(GL_TEXTURE_3D, place.level, offset.x, offset.y, offset.z, from.x,
                              from.y, from.width, from.height);
  else
    driver_.CopyTexSubImage2D(image_target(place), place.level, offset.x, offset.y, from.x, from.y,
                              from.width, from.height);
}

std::vector<float> Textures::read(const ImagePlace& place) {
  const TextureImage& image = place.texture.images.at(place.face, place.level);
  const std::size_t count = ImageSize{image.width, image.height, image.depth}.texels();
  const BaseFormat base = image.format.base;
  std::vector<float> colors(count * 4);
  if (driver_.is_es()) return read_from_framebuffer(place, image);
  std::vector<float> stored(count * stored_components(base));
  bind_to_change(place.texture);
  driver_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  driver_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  driver_.GetTexImage(image_target(place), place.level, transfer_format(base), GL_FLOAT,
                      stored.data());
  driver_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  expand_texels(stored.data(), count, base, colors.data());
  return colors;
}

std::vector<GLuint> Textures::read_depth_stencil(const ImagePlace& place) {
  const TextureImage& image = place.texture.images.at(place.face, place.level);
  std::vector<GLuint> words(ImageSize{image.width, image.height, image.depth}.texels());
  bind_to_change(place.texture);
  driver_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  driver_.GetTexImage(image_target(place), place.level, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                      words.data());
  return words;
}

/// OpenGL ES reads no textures, but framebuffers that they are attached to; of a depth texture
/// nothing.
std::vector<float> Textures::read_from_framebuffer(const ImagePlace& place,
                                                   const TextureImage& image) {
  const std::size_t slice =
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  std::vector<float> colors(slice * static_cast<std::size_t>(image.depth) * 4);
  if (image.format.base == BaseFormat::kDepth) return colors;
  GLint before = 0;
  driver_.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &before);
  GLuint framebuffer = 0;
  driver_.GenFramebuffers(1, &framebuffer);
  driver_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  driver_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  std::vector<GLubyte> bytes(slice * 4);
  const unsigned components = stored_components(image.format.base);
  std::vector<float> stored(slice * components);
  for (GLint z = 0; z < image.depth; ++z) {
    if (place.texture.target == kTexture3D)
      driver_.FramebufferTextureLayer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                      place.texture.driver_name.get(), place.level, z);
    else
      driver_.FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, image_target(place),
                                   place.texture.driver_name.get(), place.level);
    driver_.ReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    for (std::size_t i = 0; i < slice; ++i)
      for (unsigned c = 0; c < components; ++c)
        stored[i * components + c] = static_cast<float>(bytes[i * 4 + c]) / 255.0f;
    expand_texels(stored.data(), slice, image.format.base,
                  colors.data() + static_cast<std::size_t>(z) * slice * 4);
  }
  driver_.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(before));
  driver_.DeleteFramebuffers(1, &framebuffer);
  return colors;
}

void Textures::generate_mipmap(TextureObject& texture) {
  const GLint base = texture.base_level();
  const GLint last = texture.images.last_level(texture.parameters);
  if (!texture.images.at(0, base).exists() || last <= base) return;
  bind_to_change(texture);
  const GLenum target = texture_target(texture.target);
  driver_.TexParameteri(target, GL_TEXTURE_BASE_LEVEL, base);
  driver_.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, texture.parameters.max_level);
  driver_.GenerateMipmap(target);
  for (unsigned face = 0; face < texture.images.faces(); ++face) {
    TextureImage image = texture.images.at(face, base);
    for (GLint level = base + 1; level <= last; ++level) {
      image.width = std::max(image.width / 2, 1);
      image.height = std::max(image.height / 2, 1);
      image.depth = std::max(image.depth / 2, 1);
      texture.images.at(face, level) = image;
    }
  }
}

GLint Textures::channel_bits(const ImagePlace& place, unsigned channel) {
  const TextureImage& image = place.texture.images.at(place.face, place.level);
  if (driver_.is_es()) return es_channel_bits(image.format.es)[channel];
  static constexpr GLenum kNames[] = {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE,
                                      GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE};
  bind_to_change(place.texture);
  GLint bits = 0;
  const bool depth = image.format.base == BaseFormat::kDepth;
  driver_.GetTexLevelParameteriv(image_target(place), place.level,
                                 depth ? GLenum{GL_TEXTURE_DEPTH_SIZE} : kNames[channel], &bits);
  return bits;
}

}  // namespace legacy_gl
