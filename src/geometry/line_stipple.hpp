#pragma once
// Lines with a pattern (GL 2.1 spec 3.4.2). Neither the core profile nor OpenGL ES has it: lines
// are cut into the parts that are drawn, as the reference's primitive pipeline cuts them.
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "geometry/unfilled.hpp"
#include "state/raster.hpp"

namespace legacy_gl {

struct LineStippleState {
  LineState line;
  glm::mat4 modelview_projection{1.0f};
  ViewportState viewport;
  std::span<const glm::vec4> clip_planes;  ///< in clip coordinates
  bool flat = false;                       ///< a line takes the colour of its second vertex
  bool lit = false;                        ///< colours are materials, which nothing clamps
};

/// Cuts the lines of the batch, which has its own vertices: all groups of lines become GL_LINES.
void stipple_lines(const LineStippleState& state, ExpandedBatch& batch);

}  // namespace legacy_gl
