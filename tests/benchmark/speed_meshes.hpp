// The figures of the speed scenes, computed once.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "support/gl_functions.hpp"

namespace legacy_gl::test {

struct SpeedVertex {
  std::array<GLfloat, 3> normal;
  std::array<GLfloat, 3> position;
};

// A bumpy sphere of radius 1 as triangle strips of equal length.
struct StripMesh {
  std::vector<SpeedVertex> vertices;
  std::size_t strip_length = 0;
  // The same triangles one by one, over vertices that strips share.
  std::vector<SpeedVertex> shared_vertices;
  std::vector<GLuint> triangle_indices;
};

// About `vertices` vertices in strips.
const StripMesh& strip_mesh(std::size_t vertices);

// `gl` is the table of an implementation, or a type whose members are the entry points themselves.
template <typename Gl>
void draw_strips(const Gl& gl, const StripMesh& mesh) {
  for (std::size_t first = 0; first < mesh.vertices.size(); first += mesh.strip_length) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (std::size_t i = first; i < first + mesh.strip_length; ++i) {
      const SpeedVertex& v = mesh.vertices[i];
      gl.Normal3f(v.normal[0], v.normal[1], v.normal[2]);
      gl.Vertex3f(v.position[0], v.position[1], v.position[2]);
    }
    gl.End();
  }
}

// A sphere around the y axis, in strips.
void draw_ball(const GlFunctions& gl, float radius, int slices, int stacks);

}  // namespace legacy_gl::test
