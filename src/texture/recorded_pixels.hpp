#pragma once
#include <cstddef>
#include <vector>

#include "texture/unpack_pixels.hpp"

namespace legacy_gl {

/// An image taken out of the application's memory, as display lists keep it (GL 2.1 spec 5.4): rows
/// without gaps, as `store` says. The bits of GL_BITMAP become bytes.
struct RecordedPixels {
  std::vector<std::byte> bytes;
  GLenum type = GL_UNSIGNED_BYTE;
  PixelStore store{.alignment = 1};
};

RecordedPixels record_pixels(const PixelStore& store, const void* pixels, const ImageSize& size,
                             GLenum format, GLenum type);

}  // namespace legacy_gl
