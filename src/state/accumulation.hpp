#pragma once
#include <glm/vec4.hpp>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// GL 2.1 spec 4.2.4. The group of GL_ACCUM_BUFFER_BIT.
struct AccumulationState {
  glm::vec4 clear_value{0};
};

/// What glGet answers: no component of the accumulation buffer has fewer bits.
inline constexpr GLint kAccumulationBits = 16;

}  // namespace legacy_gl
