#include "geometry/primitive_run.hpp"

namespace legacy_gl {

std::uint32_t whole_primitives(GLenum mode, std::uint32_t count) {
  switch (mode) {
    case GL_LINES: return count - count % 2;
    case GL_TRIANGLES: return count - count % 3;
    case GL_QUADS: return count - count % 4;
    case GL_LINE_STRIP:
    case GL_LINE_LOOP: return count < 2 ? 0 : count;
    case GL_TRIANGLE_STRIP:
    case GL_TRIANGLE_FAN:
    case GL_POLYGON: return count < 3 ? 0 : count;
    case GL_QUAD_STRIP: return count < 4 ? 0 : count - count % 2;
    default: return count;
  }
}

}  // namespace legacy_gl
