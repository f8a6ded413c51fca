#pragma once
#include <glm/vec4.hpp>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// GL 2.1 spec 3.10, table 6.8.
struct FogState {
  bool enabled = false;
  GLenum mode = GL_EXP;
  float density = 1;
  float start = 0, end = 1;  ///< distances in eye coordinates
  glm::vec4 color{0};
  float index = 0;
  GLenum coordinate_source = GL_FRAGMENT_DEPTH;
  bool operator==(const FogState&) const = default;
};

}  // namespace legacy_gl
