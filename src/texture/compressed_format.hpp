#pragma once
#include <cstddef>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// EXT_texture_compression_s3tc: blocks of 4 by 4 texels.
inline constexpr GLenum kRgbDxt1 = 0x83F0, kRgbaDxt1 = 0x83F1, kRgbaDxt3 = 0x83F2,
                        kRgbaDxt5 = 0x83F3;
inline constexpr GLint kBlockEdge = 4;

/// 0 for what is not a compressed format.
constexpr unsigned bytes_of_block(GLint internal_format) {
  switch (static_cast<GLenum>(internal_format)) {
    case kRgbDxt1:
    case kRgbaDxt1: return 8;
    case kRgbaDxt3:
    case kRgbaDxt5: return 16;
    default: return 0;
  }
}

constexpr std::size_t compressed_size(GLint internal_format, GLsizei width, GLsizei height) {
  const auto blocks = [](GLsizei texels) {
    return (static_cast<std::size_t>(texels) + kBlockEdge - 1) / kBlockEdge;
  };
  return blocks(width) * blocks(height) * bytes_of_block(internal_format);
}

}  // namespace legacy_gl
