#include "texture/pixel_transfer.hpp"

#include <algorithm>
#include <cmath>

namespace legacy_gl {

namespace {

GLuint shifted(const PixelTransfer& transfer, GLuint index) {
  const GLint shift = transfer.index_shift;
  if (shift >= 32 || shift <= -32) index = 0;
  else if (shift > 0) index <<= shift;
  else index >>= -shift;
  return index + static_cast<GLuint>(transfer.index_offset);
}

/// Maps from an index have sizes that are powers of two (GL 2.1 spec 3.6.3).
float mapped(const std::vector<float>& map, GLuint index) { return map[index & (map.size() - 1)]; }

float mapped(const std::vector<float>& map, float value) {
  const float last = static_cast<float>(map.size() - 1);
  const float clamped = value > 0 ? std::min(value, 1.0f) : 0.0f;  // NaN too is 0
  return map[static_cast<std::size_t>(std::lround(clamped * last))];
}

}  // namespace

void transfer_colors(const PixelState& state, float* rgba, std::size_t count) {
  if (!state.changes_colors()) return;
  const PixelTransfer& transfer = state.transfer;
  for (; count > 0; --count, rgba += 4)
    for (unsigned i = 0; i < 4; ++i) {
      rgba[i] = rgba[i] * transfer.scale[i] + transfer.bias[i];
      if (transfer.map_color) rgba[i] = mapped(state.maps[kMapRToR + i], rgba[i]);
    }
}

void transfer_depths(const PixelState& state, float* depths, std::size_t count) {
  const PixelTransfer& transfer = state.transfer;
  for (; count > 0; --count, ++depths) {
    const float depth = *depths * transfer.depth_scale + transfer.depth_bias;
    *depths = depth > 0 ? std::min(depth, 1.0f) : 0.0f;
  }
}

void transfer_indices(const PixelState& state, const GLuint* indices, std::size_t count,
                      float* rgba) {
  for (; count > 0; --count, ++indices, rgba += 4) {
    const GLuint index = shifted(state.transfer, *indices);
    for (unsigned i = 0; i < 4; ++i) rgba[i] = mapped(state.maps[kMapIToR + i], index);
  }
}

void transfer_stencil(const PixelState& state, GLuint* indices, std::size_t count) {
  if (!state.changes_stencil()) return;
  for (; count > 0; --count, ++indices) {
    *indices = shifted(state.transfer, *indices);
    if (state.transfer.map_stencil)
      *indices = static_cast<GLuint>(std::lround(mapped(state.maps[kMapSToS], *indices)));
  }
}

}  // namespace legacy_gl
