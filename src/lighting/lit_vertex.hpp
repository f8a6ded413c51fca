#pragma once
// One vertex lit on the processor, in double: the raster position, and feedback.
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

struct legacy_gl_context;

namespace legacy_gl {

struct LitColor {
  glm::vec4 primary;
  glm::vec3 secondary;
};

/// GL 2.1 spec 2.14.1 for the front or back face, clamped (2.14.6). Position and normal in object
/// coordinates. The tracked materials follow the current colour.
LitColor light_vertex(legacy_gl_context& context, const glm::vec4& position,
                      const glm::vec3& normal, unsigned face);

}  // namespace legacy_gl
