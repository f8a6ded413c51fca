#include "state/feedback.hpp"

#include <utility>

namespace legacy_gl {

void FeedbackState::put(float value) {
  if (written < buffer_size) buffer[written] = value;
  ++written;
}

void FeedbackState::put_vertex(const glm::vec4& window, const glm::vec4& color,
                               const glm::vec4& texture) {
  put(window.x);
  put(window.y);
  if (has_depth()) put(window.z);
  if (has_w()) put(window.w);
  if (has_color())
    for (int i = 0; i < 4; ++i) put(color[i]);
  if (has_texture())
    for (int i = 0; i < 4; ++i) put(texture[i]);
}

GLint FeedbackState::finish() {
  const std::size_t count = std::exchange(written, 0);
  return count > buffer_size ? -1 : static_cast<GLint>(count);
}

}  // namespace legacy_gl
