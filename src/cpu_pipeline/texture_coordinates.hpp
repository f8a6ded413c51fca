#pragma once
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

struct legacy_gl_context;

namespace legacy_gl {

/// A vertex's texture coordinates as its unit uses them: generated where that is enabled (GL 2.1
/// spec 2.11.4), and through the texture matrix. Position and normal are in object coordinates.
glm::vec4 transformed_texture_coordinates(const legacy_gl_context& context, unsigned unit,
                                          const glm::vec4& position, const glm::vec3& normal,
                                          const glm::vec4& given);

}  // namespace legacy_gl
