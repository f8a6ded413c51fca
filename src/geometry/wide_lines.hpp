#pragma once
// Lines wider than one pixel (GL 2.1 spec 3.4.2), for drivers that draw none: a forward-compatible
// core context refuses them.
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "geometry/vertex_layout.hpp"
#include "state/raster.hpp"

namespace legacy_gl {

struct WideLineState {
  glm::mat4 modelview_projection{1.0f};
  ViewportState viewport;
  unsigned width = 1;  ///< in whole pixels
};

constexpr bool is_line(GLenum mode) {
  return mode == GL_LINES || mode == GL_LINE_LOOP || mode == GL_LINE_STRIP;
}

/// `layout` with the offsets in window coordinates that thin lines side by side need.
VertexLayout widened_layout(const VertexLayout& layout);

/// Appends GL_LINES of widened_layout(layout): each segment as `width` lines of one pixel, side by
/// side along the minor axis. A segment that cannot be seen is left out.
void widen_lines(const VertexLayout& layout, const float* vertices, GLenum mode,
                 std::span<const std::uint32_t> indices, const WideLineState& state,
                 std::vector<float>& widened);

}  // namespace legacy_gl
