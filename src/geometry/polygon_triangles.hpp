#pragma once
#include <cstdint>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// Edges of a triangle a, b, c that are edges of the polygon too.
enum Edge : unsigned { kEdgeAB = 1, kEdgeBC = 2, kEdgeCA = 4, kAllEdges = 7 };

/// Calls visit(a, b, c, edges) for each triangle of a primitive's k-th vertices, the provoking
/// vertex last (GL 2.1 spec 2.14.7, table 2.12).
template <typename Visit>
void for_each_triangle(GLenum mode, std::uint32_t count, Visit visit) {
  switch (mode) {
    case GL_TRIANGLES:
      for (std::uint32_t i = 0; i + 2 < count; i += 3) visit(i, i + 1, i + 2, kAllEdges);
      break;
    case GL_TRIANGLE_STRIP:
      for (std::uint32_t i = 0; i + 2 < count; ++i)
        visit(i + i % 2, i + 1 - i % 2, i + 2, kAllEdges);
      break;
    case GL_TRIANGLE_FAN:
      for (std::uint32_t i = 1; i + 1 < count; ++i) visit(0, i, i + 1, kAllEdges);
      break;
    case GL_QUADS:
      for (std::uint32_t i = 0; i + 3 < count; i += 4) {
        visit(i, i + 1, i + 3, kEdgeAB | kEdgeCA);
        visit(i + 1, i + 2, i + 3, kEdgeAB | kEdgeBC);
      }
      break;
    case GL_QUAD_STRIP:
      for (std::uint32_t i = 0; i + 3 < count; i += 2) {
        visit(i + 2, i, i + 3, kEdgeAB | kEdgeCA);
        visit(i, i + 1, i + 3, kEdgeAB | kEdgeBC);
      }
      break;
    case GL_POLYGON:
      for (std::uint32_t i = 1; i + 1 < count; ++i)
        visit(i, i + 1, 0, kEdgeAB | (i == 1 ? kEdgeCA : 0u) | (i + 2 == count ? kEdgeBC : 0u));
      break;
    default: break;
  }
}

/// Edge flags matter to separate triangles, quads and polygons alone (GL 2.1 spec 2.6.2).
inline bool uses_edge_flags(GLenum mode) {
  return mode == GL_TRIANGLES || mode == GL_QUADS || mode == GL_POLYGON;
}

}  // namespace legacy_gl
