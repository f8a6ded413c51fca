#pragma once
// Quads in window coordinates, whose fragments go the way of all others (GL 2.1 spec 3.6.4, 3.7).
#include <vector>

#include "context/context.hpp"
#include "shadergen/program_key.hpp"
#include "state/raster_position.hpp"

namespace legacy_gl {

/// The raster state of pixel rectangles: neither viewport nor culling nor polygon offset concern
/// them.
RasterState pixel_raster(const RasterState& raster);

/// Draws triangles of append_pixel_vertex. `coordinates`: of the raster position, for textures;
/// nullptr: pixels go to the framebuffer past texturing, fog and their like, as stencil indices do.
void draw_pixel_quads(Context& context, PixelSource source, const std::vector<float>& vertices,
                      const RasterState& raster, const RasterTextureCoordinates* coordinates);

}  // namespace legacy_gl
