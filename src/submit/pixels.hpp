#pragma once
#include <vector>

#include "context/context.hpp"
#include "driver/pixel_texture.hpp"
#include "driver/read_pixels.hpp"

namespace legacy_gl {

/// Draws the image at the current raster position, zoomed (GL 2.1 spec 3.6.4). Nothing waits.
void draw_pixels(Context& context, const PixelImage& image);

/// Writes colours, four floats a pixel, to the area of the framebuffer. Only the scissor, the
/// colour mask and dithering concern what glAccum(GL_RETURN) returns (GL 2.1 spec 4.2.4).
void write_colors(Context& context, const PixelRectangle& area, const std::vector<float>& colors);

}  // namespace legacy_gl
