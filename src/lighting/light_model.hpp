#pragma once
#include <glm/vec4.hpp>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// GL 2.1 spec 2.14.1, table 2.11, and the shade model of 2.14.7.
struct LightModel {
  glm::vec4 ambient{0.2f, 0.2f, 0.2f, 1};
  bool local_viewer = false;
  bool two_side = false;
  GLenum color_control = GL_SINGLE_COLOR;
  bool operator==(const LightModel&) const = default;
};

/// GL 2.1 spec 2.14.3.
struct ColorMaterial {
  bool enabled = false;
  GLenum face = GL_FRONT_AND_BACK;
  GLenum mode = GL_AMBIENT_AND_DIFFUSE;
  bool operator==(const ColorMaterial&) const = default;
};

}  // namespace legacy_gl
