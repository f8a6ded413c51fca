#pragma once
#include "context/context.hpp"

namespace legacy_gl {

/// Calls that give one value are to take names of several, as legacy_gl_options says.
inline bool takes_scalars_for_vectors() {
  return current_context && current_context->options.scalars_for_vectors;
}

/// The name for a call that gives one value: one that every setter refuses, where the name has
/// `count` values.
inline GLenum scalar_only(GLenum pname, unsigned count) {
  return count == 1 || (count && takes_scalars_for_vectors()) ? pname : GLenum{GL_NONE};
}

}  // namespace legacy_gl
