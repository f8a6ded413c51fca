#include <algorithm>
#include <cmath>
#include <cstring>

#include "texture/bitmap_image.hpp"
#include "texture/pixel_format.hpp"

namespace legacy_gl {

namespace {

float channel_value(const float* rgba, PixelChannel channel) {
  switch (channel) {
    case PixelChannel::kRed: return rgba[0];
    case PixelChannel::kGreen: return rgba[1];
    case PixelChannel::kBlue: return rgba[2];
    case PixelChannel::kAlpha: return rgba[3];
    case PixelChannel::kLuminance: break;
  }
  return std::min(rgba[0] + rgba[1] + rgba[2], 1.0f);
}

/// [0, 1] to [0, 2^bits - 1]
std::uint32_t unsigned_normalised(float value, unsigned bits) {
  const double largest = std::exp2(bits) - 1;
  return static_cast<std::uint32_t>(
      std::nearbyint(std::clamp(static_cast<double>(value), 0.0, 1.0) * largest));
}

/// [-1, 1] to [-(2^(bits-1) - 1), 2^(bits-1) - 1]: 0 stays 0, as in later versions of table 4.9.
std::int32_t signed_normalised(float value, unsigned bits) {
  const double largest = std::exp2(bits - 1) - 1;
  return static_cast<std::int32_t>(
      std::nearbyint(std::clamp(static_cast<double>(value), -1.0, 1.0) * largest));
}

template <typename T>
void store(T value, std::byte* at, bool swap_bytes) {
  std::memcpy(at, &value, sizeof value);
  if (swap_bytes) std::reverse(at, at + sizeof value);
}

void store_element(float value, GLenum type, bool swap_bytes, std::byte* at) {
  switch (type) {
    case GL_BYTE: return store(static_cast<GLbyte>(signed_normalised(value, 8)), at, false);
    case GL_UNSIGNED_BYTE:
      return store(static_cast<GLubyte>(unsigned_normalised(value, 8)), at, false);
    case GL_SHORT: return store(static_cast<GLshort>(signed_normalised(value, 16)), at, swap_bytes);
    case GL_UNSIGNED_SHORT:
      return store(static_cast<GLushort>(unsigned_normalised(value, 16)), at, swap_bytes);
    case GL_INT: return store(signed_normalised(value, 32), at, swap_bytes);
    case GL_UNSIGNED_INT: return store(unsigned_normalised(value, 32), at, swap_bytes);
    default: return store(value, at, swap_bytes);
  }
}

void store_packed(const float* components, const PackedType& type, bool swap_bytes, std::byte* at) {
  std::uint32_t pixel = 0;
  unsigned shift = type.reversed ? 0 : type.bytes * 8;
  for (unsigned i = 0; i < type.count(); ++i) {
    if (!type.reversed) shift -= type.bits[i];
    pixel |= unsigned_normalised(components[i], type.bits[i]) << shift;
    if (type.reversed) shift += type.bits[i];
  }
  switch (type.bytes) {
    case 1: return store(static_cast<GLubyte>(pixel), at, false);
    case 2: return store(static_cast<GLushort>(pixel), at, swap_bytes);
    default: return store(pixel, at, swap_bytes);
  }
}

}  // namespace

void pack_colors(const float* rgba, std::size_t count, GLenum format, GLenum type, bool swap_bytes,
                 std::byte* pixels) {
  const ColorFormat colors = color_format(format);
  const PackedType packed = packed_type(type);
  const std::size_t element = bytes_per_element(type);
  for (; count > 0; --count, rgba += 4) {
    std::array<float, 4> components{};
    for (unsigned i = 0; i < colors.count; ++i)
      components[i] = channel_value(rgba, colors.channels[i]);
    if (packed.bytes) {
      store_packed(components.data(), packed, swap_bytes, pixels);
      pixels += element;
      continue;
    }
    for (unsigned i = 0; i < colors.count; ++i, pixels += element)
      store_element(components[i], type, swap_bytes, pixels);
  }
}

namespace {

void store_index(GLuint index, GLenum type, bool swap_bytes, std::byte* at) {
  switch (type) {
    case GL_UNSIGNED_BYTE: return store(static_cast<GLubyte>(index), at, false);
    case GL_BYTE: return store(static_cast<GLbyte>(index & 0x7fu), at, false);
    case GL_UNSIGNED_SHORT: return store(static_cast<GLushort>(index), at, swap_bytes);
    case GL_SHORT: return store(static_cast<GLshort>(index & 0x7fffu), at, swap_bytes);
    case GL_UNSIGNED_INT: return store(index, at, swap_bytes);
    case GL_INT: return store(index & 0x7fffffffu, at, swap_bytes);
    default: return store(static_cast<float>(index), at, swap_bytes);
  }
}

}  // namespace

void pack_indices(const GLuint* indices, std::size_t count, GLenum type, bool swap_bytes,
                  std::byte* pixels) {
  const std::size_t element = bytes_per_element(type);
  for (; count > 0; --count, ++indices, pixels += element)
    store_index(*indices, type, swap_bytes, pixels);
}

void pack_bits(const PixelStore& store, const GLuint* indices, GLsizei width, GLsizei height,
               std::byte* pixels) {
  const std::size_t stride = bitmap_stride(store, width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x, ++indices) {
      const std::size_t at = static_cast<std::size_t>(store.skip_pixels) + x;
      const auto bit = static_cast<std::byte>(store.lsb_first ? 1u << at % 8 : 0x80u >> at % 8);
      std::byte& byte = pixels[(static_cast<std::size_t>(store.skip_rows) + y) * stride + at / 8];
      byte = *indices & 1u ? byte | bit : byte & ~bit;
    }
}

}  // namespace legacy_gl
