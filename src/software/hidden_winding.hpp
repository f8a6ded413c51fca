#pragma once
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "context/context.hpp"
#include "geometry/surface.hpp"

namespace legacy_gl {

/// A box around what is drawn, in object coordinates.
struct ObjectBox {
  glm::vec3 lowest{0}, highest{0};
};

/// Of all fragments of one draw at a place the nearest alone decides what is seen there, and
/// nothing else is asked of the others: depth test and no blending, no stencil, no holes, no query.
bool shows_nearest_alone(const Context& context);

/// The winding in window coordinates of the inner sides of a closed surface; kOpen when the matrix
/// is nearly singular.
Surface::Winding inner_winding(Surface::Winding outer, const glm::mat4& modelview_projection);

/// The winding in window coordinates of those sides of a closed surface that lie behind others;
/// kOpen when some of them may be seen: the surface is cut by the near plane, it is flat in depth,
/// or the matrix is nearly singular.
Surface::Winding hidden_winding(Surface::Winding outer, const ObjectBox& box,
                                const glm::mat4& modelview_projection,
                                const ViewportState& viewport, int depth_bits);

}  // namespace legacy_gl
