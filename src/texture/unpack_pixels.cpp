#include "texture/unpack_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "texture/pixel_format.hpp"
#include "texture/pixel_transfer.hpp"
#include "texture/recorded_pixels.hpp"

namespace legacy_gl {

namespace {

template <typename T>
T load(const std::byte* at, bool swap_bytes) {
  std::array<std::byte, sizeof(T)> bytes;
  std::memcpy(bytes.data(), at, sizeof(T));
  if (swap_bytes) std::reverse(bytes.begin(), bytes.end());
  T value;
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

/// GL 2.1 spec table 2.9.
template <typename T>
float normalised_unsigned(T value) {
  return static_cast<float>(static_cast<double>(value) /
                            static_cast<double>(std::numeric_limits<T>::max()));
}
template <typename T>
float normalised_signed(T value) {
  const double range = 2.0 * static_cast<double>(std::numeric_limits<T>::max()) + 1;
  return static_cast<float>((2 * static_cast<double>(value) + 1) / range);
}

float load_element(const std::byte* at, GLenum type, bool swap_bytes) {
  switch (type) {
    case GL_UNSIGNED_BYTE: return normalised_unsigned(load<GLubyte>(at, false));
    case GL_BYTE: return normalised_signed(load<GLbyte>(at, false));
    case GL_UNSIGNED_SHORT: return normalised_unsigned(load<GLushort>(at, swap_bytes));
    case GL_SHORT: return normalised_signed(load<GLshort>(at, swap_bytes));
    case GL_UNSIGNED_INT: return normalised_unsigned(load<GLuint>(at, swap_bytes));
    case GL_INT: return normalised_signed(load<GLint>(at, swap_bytes));
    default: return load<GLfloat>(at, swap_bytes);
  }
}

void load_packed(const std::byte* at, const PackedType& type, bool swap_bytes, float* components) {
  std::uint32_t pixel = 0;
  switch (type.bytes) {
    case 1: pixel = load<GLubyte>(at, false); break;
    case 2: pixel = load<GLushort>(at, swap_bytes); break;
    default: pixel = load<GLuint>(at, swap_bytes);
  }
  unsigned shift = type.reversed ? 0 : type.bytes * 8;
  for (unsigned i = 0; i < type.count(); ++i) {
    if (!type.reversed) shift -= type.bits[i];
    const std::uint32_t largest = (1u << type.bits[i]) - 1;
    components[i] = static_cast<float>(pixel >> shift & largest) / static_cast<float>(largest);
    if (type.reversed) shift += type.bits[i];
  }
}

/// The colour's component of each stored channel, as an index into red, green, blue, alpha.
std::array<unsigned, 4> stored_from(BaseFormat base) {
  switch (base) {
    case BaseFormat::kAlpha: return {3, 0, 0, 0};
    case BaseFormat::kLuminanceAlpha: return {0, 3, 0, 0};
    default: return {0, 1, 2, 3};
  }
}

GLubyte to_byte(float value) {
  return static_cast<GLubyte>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f));
}

GLuint to_depth(float value) {
  const double clamped = std::clamp(static_cast<double>(value), 0.0, 1.0);
  return static_cast<GLuint>(std::llround(clamped * 4294967295.0));
}

template <typename T>
void append(std::vector<std::byte>& data, std::size_t& at, T value) {
  std::memcpy(data.data() + at, &value, sizeof value);
  at += sizeof value;
}

std::size_t element_size(Texels::Type type) { return type == Texels::Type::kBytes ? 1 : 4; }

Texels make_texels(BaseFormat base, Texels::Type type, std::size_t count) {
  Texels texels;
  texels.components = stored_components(base);
  texels.type = type;
  texels.data.resize(count * texels.components * element_size(type));
  return texels;
}

void store_colors(const float* rgba, std::size_t count, BaseFormat base, Texels& texels,
                  std::size_t& at) {
  const std::array<unsigned, 4> from = stored_from(base);
  for (; count > 0; --count, rgba += 4)
    for (unsigned i = 0; i < texels.components; ++i) {
      const float value = std::isnan(rgba[from[i]]) ? 0 : rgba[from[i]];
      switch (texels.type) {
        case Texels::Type::kBytes: append(texels.data, at, to_byte(value)); break;
        case Texels::Type::kFloats: append(texels.data, at, std::clamp(value, 0.0f, 1.0f)); break;
        case Texels::Type::kDepths: append(texels.data, at, to_depth(value)); break;
      }
    }
}

/// Bytes of colours go to bytes of texels without a detour: for each stored channel, which byte of
/// the pixel has it, or -1 for 0, -2 for 255.
std::array<int, 4> byte_sources(GLenum format, BaseFormat base) {
  const ColorFormat colors = color_format(format);
  std::array<int, 4> of_color{-1, -1, -1, -2};
  for (unsigned i = 0; i < colors.count; ++i) {
    if (colors.channels[i] == PixelChannel::kLuminance)
      of_color[0] = of_color[1] = of_color[2] = static_cast<int>(i);
    else of_color[static_cast<unsigned>(colors.channels[i])] = static_cast<int>(i);
  }
  const std::array<unsigned, 4> from = stored_from(base);
  return {of_color[from[0]], of_color[from[1]], of_color[from[2]], of_color[from[3]]};
}

void copy_bytes(const std::byte* pixels, std::size_t count, unsigned pixel_size,
                const std::array<int, 4>& sources, unsigned components, std::byte* to) {
  bool same = pixel_size == components;
  for (unsigned i = 0; i < components; ++i) same = same && sources[i] == static_cast<int>(i);
  if (same) {
    std::memcpy(to, pixels, count * components);
    return;
  }
  for (; count > 0; --count, pixels += pixel_size)
    for (unsigned i = 0; i < components; ++i) {
      const int source = sources[i];
      *to++ = source >= 0 ? pixels[source] : source == -1 ? std::byte{0} : std::byte{255};
    }
}

}  // namespace

ImageRows image_rows(const PixelStore& store, const ImageSize& size, GLenum format, GLenum type) {
  const ImageLayout layout = image_layout(store, size.width, format, type);
  const auto rows =
      static_cast<std::size_t>(store.image_height > 0 ? store.image_height : size.height);
  const std::size_t image_stride = layout.stride * rows;
  const std::size_t skipped = image_stride * static_cast<std::size_t>(store.skip_images);
  return {layout.first + skipped, layout.stride, image_stride};
}

void unpack_colors(const std::byte* pixels, std::size_t count, GLenum format, GLenum type,
                   bool swap_bytes, float* rgba) {
  const ColorFormat colors = color_format(format);
  const PackedType packed = packed_type(type);
  const std::size_t element = bytes_per_element(type);
  const bool is_depth = format == GL_DEPTH_COMPONENT;
  for (; count > 0; --count, rgba += 4) {
    std::array<float, 4> components{};
    const unsigned given = is_depth ? 1 : colors.count;
    if (packed.bytes) {
      load_packed(pixels, packed, swap_bytes, components.data());
      pixels += element;
    } else {
      for (unsigned i = 0; i < given; ++i, pixels += element)
        components[i] = load_element(pixels, type, swap_bytes);
    }
    rgba[0] = rgba[1] = rgba[2] = 0;
    rgba[3] = 1;
    if (is_depth) rgba[0] = components[0];
    for (unsigned i = 0; i < colors.count; ++i) {
      if (colors.channels[i] == PixelChannel::kLuminance)
        rgba[0] = rgba[1] = rgba[2] = components[i];
      else rgba[static_cast<unsigned>(colors.channels[i])] = components[i];
    }
  }
}

namespace {

GLuint load_index(const std::byte* at, GLenum type, bool swap_bytes) {
  switch (type) {
    case GL_UNSIGNED_BYTE: return load<GLubyte>(at, false);
    case GL_BYTE: return static_cast<GLuint>(load<GLbyte>(at, false));
    case GL_UNSIGNED_SHORT: return load<GLushort>(at, swap_bytes);
    case GL_SHORT: return static_cast<GLuint>(load<GLshort>(at, swap_bytes));
    case GL_UNSIGNED_INT:
    case GL_INT: return load<GLuint>(at, swap_bytes);
    default: break;
  }
  const float value = load<GLfloat>(at, swap_bytes);
  return std::abs(value) < 2147483648.0f ? static_cast<GLuint>(static_cast<GLint>(value)) : 0u;
}

/// Calls `row(from)` for each row of the image, the bottom one first.
template <typename Row>
void for_each_row(const PixelStore& store, const void* pixels, const ImageSize& size, GLenum format,
                  GLenum type, Row row) {
  const ImageRows rows = image_rows(store, size, format, type);
  const auto* const bytes = static_cast<const std::byte*>(pixels);
  for (std::size_t image = 0; image < static_cast<std::size_t>(size.depth); ++image)
    for (std::size_t y = 0; y < static_cast<std::size_t>(size.height); ++y)
      row(bytes + rows(image, y));
}

/// A row as colours after pixel transfer, or its depths in red.
void unpack_transferred(const std::byte* from, std::size_t width, GLenum format, GLenum type,
                        bool swap_bytes, const PixelState& transfer, std::vector<GLuint>& indices,
                        float* rgba) {
  if (format == GL_COLOR_INDEX) {
    indices.resize(width);
    unpack_indices(from, width, type, swap_bytes, indices.data());
    return transfer_indices(transfer, indices.data(), width, rgba);
  }
  unpack_colors(from, width, format, type, swap_bytes, rgba);
  if (format != GL_DEPTH_COMPONENT) return transfer_colors(transfer, rgba, width);
  if (!transfer.changes_depths()) return;
  for (std::size_t i = 0; i < width; ++i) transfer_depths(transfer, rgba + 4 * i, 1);
}

}  // namespace

void unpack_indices(const std::byte* pixels, std::size_t count, GLenum type, bool swap_bytes,
                    GLuint* indices) {
  const std::size_t element = bytes_per_element(type);
  for (; count > 0; --count, pixels += element, ++indices)
    *indices = load_index(pixels, type, swap_bytes);
}

Texels unpack_texels(const PixelStore& store, const void* pixels, const ImageSize& size,
                     GLenum format, GLenum type, BaseFormat base, bool bytes_only,
                     const PixelState& transfer) {
  if (type == GL_BITMAP) {
    const RecordedPixels indices = record_pixels(store, pixels, size, format, type);
    return unpack_texels(indices.store, indices.bytes.data(), size, format, indices.type, base,
                         bytes_only, transfer);
  }
  const bool bytes =
      type == GL_UNSIGNED_BYTE && format != GL_COLOR_INDEX && !transfer.changes_colors();
  Texels::Type target = bytes || bytes_only ? Texels::Type::kBytes : Texels::Type::kFloats;
  if (base == BaseFormat::kDepth) target = Texels::Type::kDepths;
  Texels texels = make_texels(base, target, size.texels());
  const auto width = static_cast<std::size_t>(size.width);
  const std::size_t row_bytes = width * texels.components * element_size(target);
  const std::array<int, 4> sources = byte_sources(format, base);
  std::vector<float> colors;
  std::vector<GLuint> indices;
  std::size_t at = 0;
  for_each_row(store, pixels, size, format, type, [&](const std::byte* from) {
    if (bytes && target == Texels::Type::kBytes) {
      copy_bytes(from, width, bytes_per_pixel(format, type), sources, texels.components,
                 texels.data.data() + at);
      at += row_bytes;
      return;
    }
    colors.resize(width * 4);
    unpack_transferred(from, width, format, type, store.swap_bytes, transfer, indices,
                       colors.data());
    store_colors(colors.data(), width, base, texels, at);
  });
  return texels;
}

Texels unpack_depths(const PixelStore& store, const void* pixels, const ImageSize& size,
                     GLenum type, const PixelState& transfer) {
  Texels texels = make_texels(BaseFormat::kLuminance, Texels::Type::kFloats, size.texels());
  const std::size_t element = bytes_per_element(type);
  const auto width = static_cast<std::size_t>(size.width);
  std::vector<float> depths(width);
  std::size_t at = 0;
  for_each_row(store, pixels, size, GL_DEPTH_COMPONENT, type, [&](const std::byte* from) {
    for (std::size_t i = 0; i < width; ++i)
      depths[i] = load_element(from + i * element, type, store.swap_bytes);
    transfer_depths(transfer, depths.data(), width);
    for (const float depth : depths) append(texels.data, at, depth);
  });
  return texels;
}

Texels unpack_stencil(const PixelStore& store, const void* pixels, const ImageSize& size,
                      GLenum type, const PixelState& transfer) {
  if (type == GL_BITMAP) {
    const RecordedPixels indices = record_pixels(store, pixels, size, GL_STENCIL_INDEX, type);
    return unpack_stencil(indices.store, indices.bytes.data(), size, indices.type, transfer);
  }
  Texels texels = make_texels(BaseFormat::kLuminance, Texels::Type::kBytes, size.texels());
  const auto width = static_cast<std::size_t>(size.width);
  std::vector<GLuint> indices(width);
  std::size_t at = 0;
  for_each_row(store, pixels, size, GL_STENCIL_INDEX, type, [&](const std::byte* from) {
    unpack_indices(from, width, type, store.swap_bytes, indices.data());
    transfer_stencil(transfer, indices.data(), width);
    for (const GLuint index : indices) append(texels.data, at, static_cast<GLubyte>(index & 0xff));
  });
  return texels;
}

DepthStencilTexels unpack_depth_stencil(const PixelStore& store, const void* pixels,
                                        const ImageSize& size, const PixelState& transfer) {
  std::vector<GLuint> depths, indices;
  const auto width = static_cast<std::size_t>(size.width);
  for_each_row(store, pixels, size, kDepthStencil, kUnsignedInt24_8, [&](const std::byte* from) {
    for (std::size_t i = 0; i < width; ++i, from += sizeof(GLuint)) {
      const auto word = load<GLuint>(from, store.swap_bytes);
      depths.push_back((word & 0xffffff00u) | word >> 24);  // the same share of 32 bits
      indices.push_back(word & 0xffu);
    }
  });
  const PixelStore tight{.alignment = 1};
  return {unpack_depths(tight, depths.data(), size, GL_UNSIGNED_INT, transfer),
          unpack_stencil(tight, indices.data(), size, GL_UNSIGNED_INT, transfer)};
}

Texels texels_of_colors(std::span<const float> rgba, BaseFormat base, bool bytes_only) {
  Texels::Type type = bytes_only ? Texels::Type::kBytes : Texels::Type::kFloats;
  if (base == BaseFormat::kDepth) type = Texels::Type::kDepths;
  Texels texels = make_texels(base, type, rgba.size() / 4);
  std::size_t at = 0;
  store_colors(rgba.data(), rgba.size() / 4, base, texels, at);
  return texels;
}

void expand_texels(const float* stored, std::size_t count, BaseFormat base, float* rgba) {
  const unsigned components = stored_components(base);
  const std::array<unsigned, 4> from = stored_from(base);
  for (; count > 0; --count, rgba += 4, stored += components) {
    rgba[0] = rgba[1] = rgba[2] = 0;
    rgba[3] = 1;
    for (unsigned i = 0; i < components; ++i) rgba[from[i]] = stored[i];
  }
}

}  // namespace legacy_gl
