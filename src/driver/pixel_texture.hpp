#pragma once
#include "driver/driver.hpp"
#include "texture/unpack_pixels.hpp"

namespace legacy_gl {

/// An image of pixels on its way to the framebuffer.
struct PixelImage {
  PixelSource source = PixelSource::kColors;
  GLsizei width = 0, height = 0;
  Texels texels;              ///< four components of colours, or one
  bool written_only = false;  ///< depths that pass no test but the scissor, and touch no colour
};

/// A part of an image, in its pixels.
struct PixelTile {
  GLsizei x = 0, y = 0, width = 0, height = 0;
};

/// The driver's texture that pixel rectangles are drawn from.
class PixelTexture {
 public:
  explicit PixelTexture(const Driver& driver) : driver_(driver) {}
  ~PixelTexture();
  PixelTexture(const PixelTexture&) = delete;
  PixelTexture& operator=(const PixelTexture&) = delete;

  /// No side of a tile is longer.
  static constexpr GLsizei kMaxSide = 2048;

  /// Brings a part of the image to the texture and binds that to the unit that is active.
  void load(const PixelImage& image, const PixelTile& tile);

 private:
  const Driver& driver_;
  GLuint texture_ = 0;
  GLint format_ = 0;  ///< of what the texture has room for
  GLsizei width_ = 0, height_ = 0;
};

}  // namespace legacy_gl
