#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "state/pixel_state.hpp"
#include "state/raster.hpp"
#include "texture/texture_format.hpp"

namespace legacy_gl {

/// Width, height, depth in texels.
struct ImageSize {
  GLsizei width = 0, height = 1, depth = 1;
  std::size_t texels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
           static_cast<std::size_t>(depth);
  }
};

/// Texels as the driver takes them: the stored components of a base format, rows without gaps.
struct Texels {
  enum class Type { kBytes, kFloats, kDepths };  ///< kDepths: unsigned integers
  unsigned components = 4;
  Type type = Type::kBytes;
  std::vector<std::byte> data;
};

/// `count` pixels in the application's memory to colours, four floats each; a component that the
/// format lacks is 0, alpha 1; luminance goes to red, green and blue (GL 2.1 spec 3.6.4,
/// "Conversion to RGB"). The depth of GL_DEPTH_COMPONENT goes to red.
void unpack_colors(const std::byte* pixels, std::size_t count, GLenum format, GLenum type,
                   bool swap_bytes, float* rgba);

/// `count` colour or stencil indices of any type but GL_BITMAP; of floats the whole part.
void unpack_indices(const std::byte* pixels, std::size_t count, GLenum type, bool swap_bytes,
                    GLuint* indices);

/// The image that `pixels` holds under `store`, after the pixel transfer operations of `transfer`,
/// as texels of `base`. `bytes_only`: the driver takes colours in bytes alone.
Texels unpack_texels(const PixelStore& store, const void* pixels, const ImageSize& size,
                     GLenum format, GLenum type, BaseFormat base, bool bytes_only,
                     const PixelState& transfer);

/// Depths as floats, and stencil indices as bytes, as the driver takes them for pixel rectangles.
Texels unpack_depths(const PixelStore& store, const void* pixels, const ImageSize& size,
                     GLenum type, const PixelState& transfer);
Texels unpack_stencil(const PixelStore& store, const void* pixels, const ImageSize& size,
                      GLenum type, const PixelState& transfer);

/// The depths and the indices of GL_DEPTH_STENCIL in words of GL_UNSIGNED_INT_24_8.
struct DepthStencilTexels {
  Texels depths, stencil;
};
DepthStencilTexels unpack_depth_stencil(const PixelStore& store, const void* pixels,
                                        const ImageSize& size, const PixelState& transfer);

/// Colours, four floats each, as texels of `base`.
Texels texels_of_colors(std::span<const float> rgba, BaseFormat base, bool bytes_only);

/// Texels that were read back, as colours: a base format's component comes to where table 6.1 of
/// the GL 2.1 spec has it.
void expand_texels(const float* stored, std::size_t count, BaseFormat base, float* rgba);

/// Where each row of an image is in the application's memory, in bytes. GL_UNPACK_SKIP_IMAGES and
/// GL_UNPACK_IMAGE_HEIGHT count: for images of fewer than three dimensions they have to be 0.
struct ImageRows {
  std::size_t first, stride, image_stride;
  std::size_t operator()(std::size_t image, std::size_t row) const {
    return first + image * image_stride + row * stride;
  }
};
ImageRows image_rows(const PixelStore& store, const ImageSize& size, GLenum format, GLenum type);

}  // namespace legacy_gl
