#include "immediate/clip_test.hpp"

#include <cmath>
#include <glm/vec4.hpp>

namespace legacy_gl {

bool any_outside(const glm::mat4& m, const float* positions, std::uint32_t count, unsigned stride,
                 bool has_w) {
  for (std::uint32_t i = 0; i < count; ++i, positions += stride) {
    const float w = has_w ? positions[3] : 1.0f;
    const glm::vec4 clip =
        m[0] * positions[0] + m[1] * positions[1] + m[2] * positions[2] + m[3] * w;
    if (std::abs(clip.x) > clip.w || std::abs(clip.y) > clip.w || std::abs(clip.z) > clip.w)
      return true;
  }
  return false;
}

}  // namespace legacy_gl
