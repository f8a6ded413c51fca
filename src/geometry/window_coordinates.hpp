#pragma once
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "state/raster.hpp"

namespace legacy_gl {

/// GL 2.1 spec 2.11.1, in single precision as fixed-function drivers compute.
glm::vec3 to_window(const ViewportState& viewport, const glm::vec4& clip);

/// Twice a triangle's area with its sign: positive when its corners turn counterclockwise (GL 2.1
/// spec 2.14.1). In single precision and window coordinates, so that what the window cannot show
/// has no area; the homogeneous form serves vertices behind the eye.
double signed_area(const ViewportState& viewport, const glm::vec4& a, const glm::vec4& b,
                   const glm::vec4& c);

}  // namespace legacy_gl
