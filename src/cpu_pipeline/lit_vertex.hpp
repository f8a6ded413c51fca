#pragma once
// One vertex lit on the processor, in double: the raster position, and feedback.
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "lighting/material.hpp"

struct legacy_gl_context;

namespace legacy_gl {

struct LitColor {
  glm::vec4 primary;
  glm::vec3 secondary;
};

/// A normal given in object coordinates, in eye coordinates (GL 2.1 spec 2.11.3).
glm::dvec3 eye_normal(const legacy_gl_context& context, const glm::vec3& normal);

/// GL 2.1 spec 2.14.1 for the front or back face, clamped (2.14.6). Position and normal in object
/// coordinates. `materials` follow the current colour already where it is tracked.
LitColor light_vertex(const legacy_gl_context& context, const Materials& materials,
                      const glm::vec4& position, const glm::vec3& normal, unsigned face);

}  // namespace legacy_gl
