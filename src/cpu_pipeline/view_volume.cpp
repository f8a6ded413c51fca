#include "cpu_pipeline/view_volume.hpp"

#include <glm/matrix.hpp>

#include "context/context.hpp"

namespace legacy_gl {

std::vector<glm::vec4> clipping_planes(const Context& context) {
  std::vector<glm::vec4> planes{{-1, 0, 0, 1}, {1, 0, 0, 1}, {0, -1, 0, 1},
                                {0, 1, 0, 1},  {0, 0, 1, 1}, {0, 0, -1, 1}};
  const ClipPlanes& clip = context.transform.clip;
  if (!clip.enabled) return planes;
  const glm::dmat4 to_eye = glm::inverse(glm::dmat4(context.transform.projection.top().exact));
  for (unsigned i = 0; i < kMaxClipPlanes; ++i)
    if (clip.enabled >> i & 1) planes.emplace_back(clip.planes_eye[i] * to_eye);
  return planes;
}

}  // namespace legacy_gl
