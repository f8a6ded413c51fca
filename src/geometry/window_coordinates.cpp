#include "geometry/window_coordinates.hpp"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

namespace legacy_gl {

glm::vec3 to_window(const ViewportState& viewport, const glm::vec4& clip) {
  const glm::vec3 device = glm::vec3(clip) * (clip.w == 0 ? 1.0f : 1.0f / clip.w);
  const auto& box = viewport.box;
  const float half_width = 0.5f * static_cast<float>(box[2]);
  const float half_height = 0.5f * static_cast<float>(box[3]);
  const auto depth_scale = static_cast<float>(0.5 * (viewport.depth_far - viewport.depth_near));
  const auto depth_middle = static_cast<float>(0.5 * (viewport.depth_far + viewport.depth_near));
  return {device.x * half_width + (half_width + static_cast<float>(box[0])),
          device.y * half_height + (half_height + static_cast<float>(box[1])),
          device.z * depth_scale + depth_middle};
}

double signed_area(const ViewportState& viewport, const glm::vec4& a, const glm::vec4& b,
                   const glm::vec4& c) {
  if (!(a.w > 0 && b.w > 0 && c.w > 0))
    return glm::determinant(glm::dmat3(a.x, a.y, a.w, b.x, b.y, b.w, c.x, c.y, c.w));
  const std::array<GLint, 4>& box = viewport.box;
  const glm::vec2 half = glm::vec2(static_cast<float>(box[2]), static_cast<float>(box[3])) / 2.0f;
  const glm::vec2 center = half + glm::vec2(static_cast<float>(box[0]), static_cast<float>(box[1]));
  const auto window = [&](const glm::vec4& clip) {
    return glm::vec2(clip) * (1 / clip.w) * half + center;
  };
  const glm::vec2 e = window(a) - window(c), f = window(b) - window(c);
  return static_cast<double>(e.x * f.y - e.y * f.x);
}

}  // namespace legacy_gl
