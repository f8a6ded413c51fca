#pragma once
#include "backend/driver.hpp"
#include "state/raster.hpp"

namespace legacy_gl {

/// A rectangle of the framebuffer, in window coordinates.
struct PixelRectangle {
  GLint x = 0, y = 0;
  GLsizei width = 0, height = 0;
};

/// False when no way of the driver's leads to this format: OpenGL ES reads no depth and no stencil.
bool can_read_pixels(const Driver& driver, GLenum format);

/// Reads into the application's memory as `store` says. The format and the type fit each other.
void read_pixels(const Driver& driver, const PixelRectangle& rectangle, const PixelStore& store,
                 GLenum format, GLenum type, std::byte* pixels);

}  // namespace legacy_gl
