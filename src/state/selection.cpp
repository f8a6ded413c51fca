#include "state/selection.hpp"

#include <algorithm>

namespace legacy_gl {

namespace {

/// GL 2.1 spec 5.2: depths times 2^32 - 1.
GLuint as_unsigned(float depth) {
  return static_cast<GLuint>(std::clamp(static_cast<double>(depth), 0.0, 1.0) * 4294967295.0);
}

}  // namespace

void SelectionState::add_hit(float window_depth) {
  hit = true;
  nearest = std::min(nearest, window_depth);
  farthest = std::max(farthest, window_depth);
}

void SelectionState::write_hit() {
  if (!hit) return;
  const auto put = [this](GLuint value) {
    if (written < buffer_size) buffer[written] = value;
    ++written;
  };
  put(name_count);
  put(as_unsigned(nearest));
  put(as_unsigned(farthest));
  std::for_each_n(names.begin(), name_count, put);
  ++hits;
  hit = false;
  nearest = 1;
  farthest = 0;
}

GLint SelectionState::finish() {
  write_hit();
  const GLint result = written > buffer_size ? -1 : hits;
  written = 0;
  hits = 0;
  name_count = 0;
  return result;
}

}  // namespace legacy_gl
