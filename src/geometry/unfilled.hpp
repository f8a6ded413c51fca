#pragma once
// Polygons as lines or points (GL 2.1 spec 3.5.4). The core profile has no edge flags and OpenGL ES
// no glPolygonMode, so that a batch is turned into lines and points before it is drawn.
#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "geometry/primitive_run.hpp"
#include "geometry/vertex_layout.hpp"
#include "state/raster.hpp"

namespace legacy_gl {

/// Vertices and the primitives that they make up.
struct VertexBatch {
  VertexLayout layout;
  const float* vertices = nullptr;
  std::uint32_t vertex_count = 0;
  const std::vector<PrimitiveRun>& runs;
  const std::vector<std::uint32_t>& elements;
};

/// The state that decides what becomes of a polygon.
struct UnfilledState {
  PolygonState polygon;
  ViewportState viewport;
  glm::mat4 modelview_projection{1.0f};
  bool two_side = false;           ///< lit back faces have colours of their own
  bool flat = false;               ///< all of a polygon takes its provoking vertex's colour
  bool lighting_position = false;  ///< and that depends on where the provoking vertex is
  /// The smallest difference of window depths that the depth buffer tells apart (GL 2.1 spec 3.5.5,
  /// "r").
  double depth_resolution = 0;
  bool line_stipple = false;  ///< where the pattern of lines begins anew matters
};

/// Indices first to first + count - 1, drawn as `mode`.
struct PrimitiveGroup {
  GLenum mode = GL_POINTS;
  bool back = false;  ///< lines or points that take the back colour
  std::uint32_t first = 0, count = 0;
  bool operator==(const PrimitiveGroup&) const = default;
};

/// The batch as it can be drawn, in the order in which it was given.
struct ExpandedBatch {
  bool own_vertices = false;  ///< else the indices are of the batch's vertices
  VertexLayout layout;        ///< of `vertices`
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<PrimitiveGroup> groups;
  /// With line stipple: the indices with which lines of GL_LINES begin where the pattern begins
  /// too.
  std::vector<std::uint32_t> restarts;
  std::vector<std::uint32_t> uncut;  ///< indices, while lines are cut
  std::vector<glm::vec4> clip;  ///< the batch's positions in clip coordinates, while it is expanded
};

/// Whether a primitive of this mode is made of polygons.
bool is_polygonal(GLenum mode);

void expand_unfilled(const VertexBatch& batch, const UnfilledState& state, ExpandedBatch& expanded);

}  // namespace legacy_gl
