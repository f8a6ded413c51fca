#pragma once
#include "state/gl_types.hpp"

namespace legacy_gl {

/// GL 2.1 spec table 6.33, display lists.
struct ListModes {
  static constexpr unsigned kMaxNesting = 64;

  bool compiling = false;
  GLenum mode = 0;
  GLuint compiling_name = 0;
  GLuint base = 0;
  unsigned nesting = 0;
};

}  // namespace legacy_gl
