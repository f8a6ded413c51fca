#include "texture/bitmap_image.hpp"

#include <algorithm>

namespace legacy_gl {

namespace {

void clear_rest(BitmapImage& image) {
  const unsigned used = static_cast<unsigned>(image.width) % 8;
  if (!used) return;
  const auto mask = static_cast<unsigned char>(0xff00u >> used);
  for (std::size_t end = image.row_bytes(); end <= image.bits.size(); end += image.row_bytes())
    image.bits[end - 1] = static_cast<char>(static_cast<unsigned char>(image.bits[end - 1]) & mask);
}

}  // namespace

BitmapImage BitmapImage::part(GLsizei x, GLsizei y, GLsizei part_width, GLsizei part_height) const {
  BitmapImage image{part_width, part_height, {}};
  for (GLsizei row = y; row < y + part_height; ++row)
    image.bits.append(bits,
                      static_cast<std::size_t>(row) * row_bytes() + static_cast<std::size_t>(x) / 8,
                      image.row_bytes());
  clear_rest(image);
  return image;
}

std::size_t bitmap_stride(const PixelStore& store, GLsizei width) {
  const auto bits = static_cast<std::size_t>(store.row_length > 0 ? store.row_length : width);
  const auto alignment = static_cast<std::size_t>(store.alignment);
  return (bits + 8 * alignment - 1) / (8 * alignment) * alignment;
}

void unpack_bitmap(const PixelStore& store, GLsizei width, GLsizei height, const GLubyte* pixels,
                   BitmapImage& image) {
  image.width = width;
  image.height = height;
  const auto size = [](GLint value) { return static_cast<std::size_t>(value); };
  const std::size_t stride = bitmap_stride(store, width);
  image.bits.assign(image.row_bytes() * size(height), 0);
  for (std::size_t y = 0; y < size(height); ++y) {
    const GLubyte* const row = pixels + (size(store.skip_rows) + y) * stride;
    for (std::size_t x = 0; x < size(width); ++x) {
      const std::size_t at = size(store.skip_pixels) + x;
      const unsigned shift = static_cast<unsigned>(store.lsb_first ? at % 8 : 7 - at % 8);
      if (!(row[at / 8] >> shift & 1)) continue;
      char& byte = image.bits[y * image.row_bytes() + x / 8];
      byte = static_cast<char>(static_cast<unsigned char>(byte) | 0x80u >> (x % 8));
    }
  }
}

}  // namespace legacy_gl
