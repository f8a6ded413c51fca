#include "texture/recorded_pixels.hpp"

#include <cstring>

#include "texture/bitmap_image.hpp"
#include "texture/pixel_format.hpp"

namespace legacy_gl {

namespace {

void record_bits(const PixelStore& store, const void* pixels, const ImageSize& size,
                 RecordedPixels& recorded) {
  const GLsizei height = size.height * size.depth;
  BitmapImage image;
  unpack_bitmap(store, size.width, height, static_cast<const GLubyte*>(pixels), image);
  recorded.bytes.resize(size.texels());
  const auto width = static_cast<std::size_t>(size.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const auto byte = static_cast<unsigned char>(image.bits[y * image.row_bytes() + x / 8]);
      recorded.bytes[y * width + x] = static_cast<std::byte>(byte >> (7 - x % 8) & 1);
    }
}

}  // namespace

RecordedPixels record_pixels(const PixelStore& store, const void* pixels, const ImageSize& size,
                             GLenum format, GLenum type) {
  RecordedPixels recorded;
  if (type == GL_BITMAP) {
    record_bits(store, pixels, size, recorded);
    return recorded;
  }
  recorded.type = type;
  recorded.store.swap_bytes = store.swap_bytes;
  const std::size_t row = static_cast<std::size_t>(size.width) * bytes_per_pixel(format, type);
  const auto height = static_cast<std::size_t>(size.height);
  const std::size_t rows = height * static_cast<std::size_t>(size.depth);
  recorded.bytes.resize(row * rows);
  const ImageRows at = image_rows(store, size, format, type);
  for (std::size_t i = 0; i < rows && row; ++i)
    std::memcpy(recorded.bytes.data() + i * row,
                static_cast<const std::byte*>(pixels) + at(i / height, i % height), row);
  return recorded;
}

}  // namespace legacy_gl
