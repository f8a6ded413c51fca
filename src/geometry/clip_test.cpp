#include "geometry/clip_test.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace legacy_gl {

bool any_outside(const glm::mat4& m, std::span<const glm::vec4> planes, const float* positions,
                 std::uint32_t count, unsigned stride, bool has_w) {
  for (std::uint32_t i = 0; i < count; ++i, positions += stride) {
    const float w = has_w ? positions[3] : 1.0f;
    const glm::vec4 clip =
        m[0] * positions[0] + m[1] * positions[1] + m[2] * positions[2] + m[3] * w;
    if (std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w || std::abs(clip.z) > clip.w)
      return true;
    for (const glm::vec4& plane : planes)
      if (glm::dot(plane, clip) < 0) return true;
  }
  return false;
}

namespace {

/// What is below this part of the terms' sum may be rounding.
constexpr float kRounding = 1e-5f;

}  // namespace

bool all_beyond_one_plane(const glm::mat4& m, const float* positions, std::uint32_t count,
                          unsigned stride, bool has_w) {
  const auto row = [&m](int i) { return glm::vec4(m[0][i], m[1][i], m[2][i], m[3][i]); };
  const auto beyond = [has_w](const glm::vec4& plane, const float* p) {
    const float w = has_w ? p[3] : 1.0f;
    const float x = plane.x * p[0], y = plane.y * p[1], z = plane.z * p[2], rest = plane.w * w;
    const float size = std::abs(x) + std::abs(y) + std::abs(z) + std::abs(rest);
    return (x + y) + (z + rest) < -kRounding * size;  // false where one is not a number
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int side = -1; side <= 1; side += 2) {
      const glm::vec4 plane = row(3) + static_cast<float>(side) * row(axis);
      std::uint32_t i = 0;
      while (i < count && beyond(plane, positions + std::size_t{i} * stride)) ++i;
      if (i == count) return true;
    }
  return false;
}

std::optional<VisiblePart> visible_part(const glm::vec4& a, const glm::vec4& b,
                                        std::span<const glm::vec4> planes) {
  VisiblePart part;
  const auto cut = [&part](float from, float to) {
    if (from < 0) part.begin = std::max(part.begin, from / (from - to));
    if (to < 0) part.end = std::min(part.end, from / (from - to));
    return from >= 0 || to >= 0;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f})
      if (!cut(a.w + side * a[axis], b.w + side * b[axis])) return {};
  for (const glm::vec4& plane : planes)
    if (!cut(glm::dot(plane, a), glm::dot(plane, b))) return {};
  if (!(part.begin <= part.end)) return {};
  return part;
}

}  // namespace legacy_gl
