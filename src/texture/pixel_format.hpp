#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "state/gl_types.hpp"
#include "state/raster.hpp"

namespace legacy_gl {

/// Which of red, green, blue, alpha stand in a pixel, in its order; kLuminance is their sum when
/// read.
enum class PixelChannel : std::uint8_t { kRed, kGreen, kBlue, kAlpha, kLuminance };

/// A format of colours in the application's memory (GL 2.1 spec table 3.6).
struct ColorFormat {
  unsigned count = 0;  ///< 0: no format of colours
  std::array<PixelChannel, 4> channels{};
};
ColorFormat color_format(GLenum format);

/// A type that holds a whole pixel (GL 2.1 spec tables 3.8 to 3.11).
struct PackedType {
  unsigned bytes = 0;              ///< 0: each component has a place of its own
  std::array<unsigned, 4> bits{};  ///< of each component, in the order of the format; 0: none
  bool reversed = false;           ///< the first component has the lowest bits
  unsigned count() const { return bits[3] ? 4 : 3; }
};
PackedType packed_type(GLenum type);

/// The error that the two make together, or GL_NO_ERROR (GL 2.1 spec 3.6.4, table 3.5).
GLenum pixel_format_error(GLenum format, GLenum type);

/// Of glDrawPixels and glReadPixels, which take depth and stencil in one word as well
/// (EXT_packed_depth_stencil).
GLenum pixel_rectangle_error(GLenum format, GLenum type);

unsigned bytes_per_pixel(GLenum format, GLenum type);
/// What GL_PACK_SWAP_BYTES turns around.
unsigned bytes_per_element(GLenum type);

/// Where rows are in the application's memory (GL 2.1 spec 3.6.4, 4.3.2). In bytes.
struct ImageLayout {
  std::size_t first = 0;
  std::size_t stride = 0;
};
ImageLayout image_layout(const PixelStore& store, GLsizei width, GLenum format, GLenum type);

/// `count` colours, four floats each, to the application's format and type (GL 2.1 spec 4.3.2,
/// table 4.9).
void pack_colors(const float* rgba, std::size_t count, GLenum format, GLenum type, bool swap_bytes,
                 std::byte* pixels);

/// Stencil indices to a type other than GL_BITMAP, as many bits as it has (GL 2.1 spec 4.3.2, table
/// 4.8); to GL_BITMAP the lowest bit.
void pack_indices(const GLuint* indices, std::size_t count, GLenum type, bool swap_bytes,
                  std::byte* pixels);
void pack_bits(const PixelStore& store, const GLuint* indices, GLsizei width, GLsizei height,
               std::byte* pixels);

}  // namespace legacy_gl
