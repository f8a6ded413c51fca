#pragma once
#include <string>

#include "state/raster.hpp"

namespace legacy_gl {

/// What glBitmap draws: one bit a pixel, the bottom row first, the leftmost pixel in the highest
/// bit, rows of whole bytes whose rest is 0.
struct BitmapImage {
  GLsizei width = 0, height = 0;
  std::string bits;

  std::size_t row_bytes() const { return (static_cast<std::size_t>(width) + 7) / 8; }
  /// The part of it whose left lower pixel is (x, y); x is a multiple of 8.
  BitmapImage part(GLsizei x, GLsizei y, GLsizei part_width, GLsizei part_height) const;
};

/// Bytes from one row of bits to the next in the application's memory.
std::size_t bitmap_stride(const PixelStore& store, GLsizei width);

/// From the application's memory (GL 2.1 spec 3.6.4, 3.7).
void unpack_bitmap(const PixelStore& store, GLsizei width, GLsizei height, const GLubyte* pixels,
                   BitmapImage& image);

}  // namespace legacy_gl
