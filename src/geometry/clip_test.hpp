#pragma once
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>

namespace legacy_gl {

/// True when one of `count` positions, `stride` floats apart, is outside the view volume (GL 2.1
/// spec 2.12), or behind one of the planes, which are in clip coordinates.
bool any_outside(const glm::mat4& modelview_projection, std::span<const glm::vec4> planes,
                 const float* positions, std::uint32_t count, unsigned stride, bool has_w);

/// True when all of them are beyond the same clip plane, farther than float32 rounds: nothing that
/// they make up is seen.
bool all_beyond_one_plane(const glm::mat4& modelview_projection, const float* positions,
                          std::uint32_t count, unsigned stride, bool has_w);

/// The part of a line that is in the view volume and before the planes, which are in clip
/// coordinates: from `begin` to `end` of the way from one end to the other.
struct VisiblePart {
  float begin = 0, end = 1;
};
std::optional<VisiblePart> visible_part(const glm::vec4& a, const glm::vec4& b,
                                        std::span<const glm::vec4> planes);

}  // namespace legacy_gl
