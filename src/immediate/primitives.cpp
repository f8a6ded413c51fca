#include "immediate/primitives.hpp"

namespace legacy_gl {

GLenum core_mode(GLenum mode) {
  switch (mode) {
    case GL_QUADS:
    case GL_QUAD_STRIP:
    case GL_POLYGON: return GL_TRIANGLES;
    default: return mode;
  }
}

bool draws_without_indices(GLenum mode) { return core_mode(mode) == mode; }

void append_indices(const PrimitiveRun& run, std::vector<std::uint32_t>& indices) {
  const std::uint32_t first = run.first, end = run.first + run.count;
  const auto triangle = [&indices](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    indices.push_back(a);
    indices.push_back(b);
    indices.push_back(c);
  };
  switch (run.mode) {
    case GL_QUADS:
      for (std::uint32_t i = first; i + 3 < end; i += 4) {
        triangle(i, i + 1, i + 3);
        triangle(i + 1, i + 2, i + 3);
      }
      break;
    case GL_QUAD_STRIP:
      for (std::uint32_t i = first; i + 3 < end; i += 2) {
        triangle(i + 2, i, i + 3);
        triangle(i, i + 1, i + 3);
      }
      break;
    case GL_POLYGON:
      for (std::uint32_t i = first + 1; i + 1 < end; ++i) triangle(i, i + 1, first);
      break;
    default:
      for (std::uint32_t i = first; i < end; ++i) indices.push_back(i);
  }
}

}  // namespace legacy_gl
