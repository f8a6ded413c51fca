#include "software/hidden_winding.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "driver/driver_objects.hpp"

namespace legacy_gl {

namespace {

/// So many depth values lie between the box's nearest and its farthest corner at least. Where a
/// surface is less deep, its two sides have the same values and the one drawn first is seen.
constexpr double kDepthSteps = 4096;

/// The determinant, or 0 where it is so small, in parts of what it can be at most, that its sign
/// may be rounding.
double sure_determinant(const glm::mat4& matrix) {
  constexpr double kSingular = 1e-6;
  const glm::dmat4 rows = glm::transpose(glm::dmat4(matrix));
  double most_squared = 1;
  for (int i = 0; i < 4; ++i) most_squared *= glm::dot(rows[i], rows[i]);
  const double determinant = glm::determinant(rows);
  return determinant * determinant > kSingular * kSingular * most_squared ? determinant : 0;
}

}  // namespace

bool shows_nearest_alone(const Context& context) {
  const RasterState& raster = context.raster;
  if (!raster.depth.test_enabled || !raster.depth.write_mask) return false;
  if (raster.depth.function != GL_LESS && raster.depth.function != GL_LEQUAL) return false;
  if (!(raster.viewport.depth_near < raster.viewport.depth_far)) return false;
  if (raster.stencil.test_enabled || raster.multisample.alpha_to_coverage) return false;
  const ColorBufferState& color = raster.color_buffer;
  if (color.blend_enabled || color.logic_op_enabled || color.alpha_test_enabled) return false;
  PolygonState plain;
  plain.front_face = raster.polygon.front_face;
  plain.cull_face = raster.polygon.cull_face;
  plain.offset_factor = raster.polygon.offset_factor;
  plain.offset_units = raster.polygon.offset_units;
  if (raster.polygon != plain) return false;
  return !context.transform.clip.enabled && !context.driver->queries.active();
}

Surface::Winding inner_winding(Surface::Winding outer, const glm::mat4& modelview_projection) {
  using Winding = Surface::Winding;
  const double determinant = sure_determinant(modelview_projection);
  if (outer == Winding::kOpen || determinant == 0) return Winding::kOpen;
  // The usual projection mirrors: the eye looks along -z, depth grows along +z. Then an outer side
  // is seen wound as it is.
  const bool seen_counterclockwise = (outer == Winding::kCounterclockwise) == (determinant < 0);
  return seen_counterclockwise ? Winding::kClockwise : Winding::kCounterclockwise;
}

Surface::Winding hidden_winding(Surface::Winding outer, const ObjectBox& box,
                                const glm::mat4& modelview_projection,
                                const ViewportState& viewport, int depth_bits) {
  using Winding = Surface::Winding;
  if (outer == Winding::kOpen) return Winding::kOpen;
  double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
  for (unsigned corner = 0; corner < 8; ++corner) {
    glm::dvec4 position(0, 0, 0, 1);
    for (int axis = 0; axis < 3; ++axis)
      position[axis] = (corner >> axis & 1 ? box.highest : box.lowest)[axis];
    const glm::dvec4 clip = glm::dmat4(modelview_projection) * position;
    if (!(clip.w > 0) || !(clip.z > -clip.w)) return Winding::kOpen;
    nearest = std::min(nearest, clip.z / clip.w);
    farthest = std::max(farthest, clip.z / clip.w);
  }
  const double depth_range = (viewport.depth_far - viewport.depth_near) / 2;
  if (!((farthest - nearest) * depth_range * std::ldexp(1, depth_bits) >= kDepthSteps))
    return Winding::kOpen;
  return inner_winding(outer, modelview_projection);
}

}  // namespace legacy_gl
