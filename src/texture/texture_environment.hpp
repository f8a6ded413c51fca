#pragma once
#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// GL 2.1 spec tables 3.24, 3.25: one half, RGB or alpha, of the combine environment.
struct CombineState {
  GLenum function = GL_MODULATE;
  std::array<GLenum, 3> sources{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT};
  std::array<GLenum, 3> operands{GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA};
  float scale = 1;
  bool operator==(const CombineState&) const = default;
};

/// GL 2.1 spec 3.8.13, table 6.20: what glTexEnv sets.
struct TextureEnvironment {
  GLenum mode = GL_MODULATE;
  glm::vec4 color{0};
  float lod_bias = 0;  ///< of the unit; a texture has one of its own
  CombineState rgb{.operands = {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA}};
  CombineState alpha;
  bool operator==(const TextureEnvironment&) const = default;
};

/// GL 2.1 spec 2.11.4: how one coordinate is generated.
struct TexgenCoordinate {
  bool enabled = false;
  GLenum mode = GL_EYE_LINEAR;
  glm::vec4 object_plane{0};
  glm::dvec4 eye_plane{0};  ///< in eye coordinates since it was set
  bool operator==(const TexgenCoordinate&) const = default;
};

struct TexgenState {
  std::array<TexgenCoordinate, 4> coordinates;  ///< s, t, r, q
  TexgenState() {
    coordinates[0].object_plane = {1, 0, 0, 0};
    coordinates[0].eye_plane = {1, 0, 0, 0};
    coordinates[1].object_plane = {0, 1, 0, 0};
    coordinates[1].eye_plane = {0, 1, 0, 0};
  }
  bool operator==(const TexgenState&) const = default;
};

}  // namespace legacy_gl
