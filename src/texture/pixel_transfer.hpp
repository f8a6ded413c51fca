#pragma once
// Pixel transfer operations (GL 2.1 spec 3.6.5): scale and bias, then the maps.
#include <cstddef>

#include "state/pixel_state.hpp"

namespace legacy_gl {

/// `count` colours, four floats each.
void transfer_colors(const PixelState& state, float* rgba, std::size_t count);
/// Clamped to [0, 1].
void transfer_depths(const PixelState& state, float* depths, std::size_t count);
/// Colour indices to colours, four floats each.
void transfer_indices(const PixelState& state, const GLuint* indices, std::size_t count,
                      float* rgba);
void transfer_stencil(const PixelState& state, GLuint* indices, std::size_t count);

}  // namespace legacy_gl
