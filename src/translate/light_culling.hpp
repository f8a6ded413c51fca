#pragma once
// Which lights a draw can show: with many lights over many objects, each object has few.
#include <bitset>
#include <glm/vec3.hpp>

#include "context/context.hpp"
#include "geometry/list_mesh.hpp"
#include "matrix/lighting_space.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

using LightMask = std::bitset<kMaxLights>;

/// What is known of all vertices of a draw, in object coordinates.
struct DrawBounds {
  glm::vec3 lowest{0}, highest{0};
  float longest_normal = 0;
  float largest_color = 0;  ///< component of the colours, where they are materials
};

/// Whether lights are worth a look for each draw: more than eight are enabled, and the quality
/// allows an error of 1/1024 of a step.
bool culls_lights(const Context& context);

/// Of vertices that are recorded; false where their positions have a w.
bool find_bounds(const Context& context, const VertexLayout& layout, const float* vertices,
                 std::uint32_t count, DrawBounds& bounds);
/// Of a list's mesh. Attributes that it does not have are the current values.
DrawBounds bounds_of(const Context& context, const ListMesh& mesh);

/// All lights but those whose part in every vertex is below 1/1024 of a step of 8 bits, by their
/// distance or their cone. `modelview` is affine.
LightMask reached_lights(const Context& context, const glm::dmat4& modelview,
                         const LinearPart& linear, const VertexLayout& layout,
                         const DrawBounds& bounds);

}  // namespace legacy_gl
