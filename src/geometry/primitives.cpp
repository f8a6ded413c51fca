#include "geometry/primitives.hpp"

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

bool joins_in_one_draw(GLenum mode) {
  return mode == GL_POINTS || mode == GL_LINES || mode == GL_TRIANGLES;
}

namespace {

/// `vertex(k)` is the index of the run's k-th vertex.
template <typename Vertex>
void append(GLenum mode, std::uint32_t count, bool pipeline_split,
            std::vector<std::uint32_t>& indices, Vertex vertex) {
  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    indices.push_back(vertex(a));
    indices.push_back(vertex(b));
    indices.push_back(vertex(c));
  };
  switch (mode) {
    case GL_QUADS:
      for (std::uint32_t i = 0; i + 3 < count; i += 4) {
        triangle(i, i + 1, pipeline_split ? i + 3 : i + 2);
        triangle(pipeline_split ? i + 1 : i, i + 2, i + 3);
      }
      break;
    case GL_QUAD_STRIP:
      for (std::uint32_t i = 0; i + 3 < count; i += 2) {
        triangle(i, i + 1, i + 3);
        triangle(i + 2, i, i + 3);
      }
      break;
    case GL_POLYGON:
      for (std::uint32_t i = 1; i + 1 < count; ++i) triangle(i, i + 1, 0);
      break;
    default: {
      const std::size_t at = indices.size();
      indices.resize(at + count);
      for (std::uint32_t i = 0; i < count; ++i) indices[at + i] = vertex(i);
    }
  }
}

}  // namespace

void append_indices(const PrimitiveRun& run, const std::vector<std::uint32_t>& elements,
                    std::uint32_t base_vertex, bool pipeline_split,
                    std::vector<std::uint32_t>& indices) {
  if (run.indexed) {
    const std::uint32_t* const element = elements.data() + run.first;
    append(run.mode, run.count, true, indices,
           [=](std::uint32_t i) { return element[i] + base_vertex; });
  } else {
    append(run.mode, run.count, pipeline_split, indices,
           [=](std::uint32_t i) { return run.first + base_vertex + i; });
  }
}

bool append_triangles(const PrimitiveRun& run, const std::vector<std::uint32_t>& elements,
                      std::vector<std::uint32_t>& triangles) {
  const auto vertex = [&](std::uint32_t i) {
    return run.indexed ? elements[run.first + i] : run.first + i;
  };
  switch (run.mode) {
    case GL_TRIANGLE_STRIP:
      for (std::uint32_t i = 0; i + 2 < run.count; ++i)
        triangles.insert(triangles.end(),
                         {vertex(i + i % 2), vertex(i + 1 - i % 2), vertex(i + 2)});
      return true;
    case GL_TRIANGLE_FAN:
      for (std::uint32_t i = 1; i + 1 < run.count; ++i)
        triangles.insert(triangles.end(), {vertex(0), vertex(i), vertex(i + 1)});
      return true;
    case GL_TRIANGLES:
    case GL_QUADS:
    case GL_QUAD_STRIP:
    case GL_POLYGON: append_indices(run, elements, 0, true, triangles); return true;
    default: return false;
  }
}

}  // namespace legacy_gl
