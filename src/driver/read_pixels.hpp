#pragma once
#include <vector>

#include "driver/driver.hpp"
#include "state/pixel_state.hpp"
#include "state/raster.hpp"

namespace legacy_gl {

/// A rectangle of the framebuffer, in window coordinates.
struct PixelRectangle {
  GLint x = 0, y = 0;
  GLsizei width = 0, height = 0;
};

/// False when no way of the driver's leads to this format: OpenGL ES reads no depth and no stencil.
bool can_read_pixels(const Driver& driver, GLenum format);

/// The driver gives colours away as floats; otherwise the colour buffer has bytes alone.
bool reads_floats(const Driver& driver);

/// Reads into the application's memory as `store` says, after the pixel transfer operations of
/// `transfer`. The format and the type fit each other.
void read_pixels(const Driver& driver, const PixelRectangle& rectangle, const PixelStore& store,
                 GLenum format, GLenum type, const PixelState& transfer, std::byte* pixels);
/// Colours after pixel transfer, four floats each; not clamped where nothing was transferred.
std::vector<float> read_colors(const Driver& driver, const PixelRectangle& rectangle,
                               const PixelState& transfer);
std::vector<float> read_depths(const Driver& driver, const PixelRectangle& rectangle,
                               const PixelState& transfer);

}  // namespace legacy_gl
