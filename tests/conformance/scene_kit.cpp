#include "conformance/scene_kit.hpp"

#include <numbers>
#include <utility>

namespace legacy_gl::test {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

void clear(const GlFunctions& gl) {
  gl.Viewport(0, 0, scene_size, scene_size);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
}

struct Point {
  float x, y, z;
};

using Surface = Point (*)(float u, float v, bool normal, float a, float b);

Point sphere_point(float u, float v, bool normal, float radius, float) {
  const float around = 2.0F * pi * u;
  const float up = pi * (v - 0.5F);
  const float scale = normal ? 1.0F : radius;
  return {scale * std::cos(up) * std::sin(around), scale * std::sin(up),
          scale * std::cos(up) * std::cos(around)};
}

Point torus_point(float u, float v, bool normal, float tube_radius, float ring_radius) {
  const float around = 2.0F * pi * u;
  const float along = 2.0F * pi * v;
  const float x = std::cos(around);
  const float y = std::sin(around);
  if (normal) return {x * std::cos(along), y * std::cos(along), std::sin(along)};
  const float ring = ring_radius + tube_radius * std::cos(along);
  return {x * ring, y * ring, tube_radius * std::sin(along)};
}

void emit(const GlFunctions& gl, Surface surface, float u, float v, float a, float b,
          bool colored) {
  const Point normal = surface(u, v, true, a, b);
  const Point position = surface(u, v, false, a, b);
  if (colored) color_by_position(gl, normal.x, normal.y, normal.z);
  gl.Normal3f(normal.x, normal.y, normal.z);
  gl.Vertex3f(position.x, position.y, position.z);
}

void draw_surface(const GlFunctions& gl, Surface surface, int columns, int rows, float a, float b,
                  bool colored) {
  gl.Begin(GL_TRIANGLES);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const float u0 = static_cast<float>(column) / static_cast<float>(columns);
      const float u1 = static_cast<float>(column + 1) / static_cast<float>(columns);
      const float v0 = static_cast<float>(row) / static_cast<float>(rows);
      const float v1 = static_cast<float>(row + 1) / static_cast<float>(rows);
      emit(gl, surface, u0, v0, a, b, colored);
      emit(gl, surface, u1, v0, a, b, colored);
      emit(gl, surface, u1, v1, a, b, colored);
      emit(gl, surface, u0, v0, a, b, colored);
      emit(gl, surface, u1, v1, a, b, colored);
      emit(gl, surface, u0, v1, a, b, colored);
    }
  }
  gl.End();
}

}  // namespace

void begin_scene(const GlFunctions& gl) {
  clear(gl);
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustum(-0.55, 0.55, -0.55, 0.55, 2.0, 10.0);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Translatef(0, 0, -4);
}

void begin_flat_scene(const GlFunctions& gl) {
  clear(gl);
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Ortho(-1, 1, -1, 1, -2, 2);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
}

void begin_lit_scene(const GlFunctions& gl) {
  begin_scene(gl);
  gl.Enable(GL_LIGHTING);
  use_directional_light(gl, GL_LIGHT0, vec(1, 1, 1));
  use_material(gl, GL_FRONT_AND_BACK, vec(0.1F, 0.15F, 0.3F), vec(0.3F, 0.5F, 0.7F),
               vec(0.6F, 0.5F, 0.4F), 20);
}

void use_directional_light(const GlFunctions& gl, GLenum light, Parameters color) {
  use_positional_light(gl, light, vec(0.5F, 0.8F, 1.0F, 0.0F), color);
}

void use_positional_light(const GlFunctions& gl, GLenum light, Parameters position,
                          Parameters color) {
  gl.Lightfv(light, GL_POSITION, position);
  gl.Lightfv(light, GL_DIFFUSE, color);
  gl.Lightfv(light, GL_SPECULAR, color);
  gl.Enable(light);
}

void use_material(const GlFunctions& gl, GLenum face, Parameters ambient, Parameters diffuse,
                  Parameters specular, float shininess) {
  gl.Materialfv(face, GL_AMBIENT, ambient);
  gl.Materialfv(face, GL_DIFFUSE, diffuse);
  gl.Materialfv(face, GL_SPECULAR, specular);
  gl.Materialf(face, GL_SHININESS, shininess);
}

void use_brass(const GlFunctions& gl, GLenum face) {
  use_material(gl, face, vec(0.329412F, 0.223529F, 0.027451F), vec(0.780392F, 0.568627F, 0.113725F),
               vec(0.992157F, 0.941176F, 0.807843F), 27.8974F);
}

void use_turquoise(const GlFunctions& gl, GLenum face) {
  use_material(gl, face, vec(0.1F, 0.18725F, 0.1745F), vec(0.396F, 0.74151F, 0.69102F),
               vec(0.297254F, 0.30829F, 0.306678F), 12.8F);
}

void use_black_plastic(const GlFunctions& gl, GLenum face) {
  use_material(gl, face, vec(0, 0, 0), vec(0.01F, 0.01F, 0.01F), vec(0.5F, 0.5F, 0.5F), 32);
}

void draw_sphere(const GlFunctions& gl, float radius, int slices, int stacks) {
  draw_surface(gl, sphere_point, slices, stacks, radius, 0, false);
}

void draw_colored_sphere(const GlFunctions& gl, float radius) {
  draw_surface(gl, sphere_point, 16, 10, radius, 0, true);
}

void draw_torus(const GlFunctions& gl, float tube_radius, float ring_radius) {
  draw_surface(gl, torus_point, 20, 10, tube_radius, ring_radius, false);
}

void draw_cube(const GlFunctions& gl, float half_edge) {
  gl.Begin(GL_TRIANGLES);
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0F, 1.0F}) {
      std::array<float, 3> normal{};
      normal[static_cast<std::size_t>(axis)] = sign;
      gl.Normal3fv(normal.data());
      // Counter-clockwise seen from outside.
      constexpr std::array<std::array<float, 2>, 6> corners = {
          {{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}};
      for (const auto& corner : corners) {
        std::array<float, 3> position{};
        position[static_cast<std::size_t>(axis)] = sign * half_edge;
        position[static_cast<std::size_t>((axis + 1) % 3)] = sign * corner[0] * half_edge;
        position[static_cast<std::size_t>((axis + 2) % 3)] = corner[1] * half_edge;
        gl.Vertex3fv(position.data());
      }
    }
  }
  gl.End();
}

void draw_patch(const GlFunctions& gl, int cells) {
  const auto coordinate = [cells](int i) {
    return -1.0F + 2.0F * static_cast<float>(i) / static_cast<float>(cells);
  };
  gl.Normal3f(0, 0, 1);
  gl.Begin(GL_TRIANGLES);
  for (int row = 0; row < cells; ++row) {
    for (int column = 0; column < cells; ++column) {
      const float x0 = coordinate(column);
      const float x1 = coordinate(column + 1);
      const float y0 = coordinate(row);
      const float y1 = coordinate(row + 1);
      gl.Vertex2f(x0, y0);
      gl.Vertex2f(x1, y0);
      gl.Vertex2f(x1, y1);
      gl.Vertex2f(x0, y0);
      gl.Vertex2f(x1, y1);
      gl.Vertex2f(x0, y1);
    }
  }
  gl.End();
}

void draw_half_tube(const GlFunctions& gl, float radius) {
  constexpr int segments = 12;
  gl.PushMatrix();
  // Half of the view shows the outside, half the inside.
  gl.Rotatef(25, 1, 0, 0);
  gl.Rotatef(-80, 0, 1, 0);
  for (int ring = 0; ring < 4; ++ring) {
    const float height = 0.4F * radius;
    const float y0 = height * (static_cast<float>(ring) - 2);
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int i = 0; i <= segments; ++i) {
      const float angle = 1.2F * pi * static_cast<float>(i) / segments - 0.4F;
      const float x = std::cos(angle);
      const float z = std::sin(angle);
      gl.Normal3f(x, 0, z);
      gl.Vertex3f(radius * x, y0, radius * z);
      gl.Vertex3f(radius * x, y0 + height, radius * z);
    }
    gl.End();
  }
  gl.PopMatrix();
}

void color_by_position(const GlFunctions& gl, float x, float y, float z) {
  gl.Color4f(0.5F + 0.5F * x, 0.5F + 0.5F * y, 0.5F - 0.5F * z, 0.75F + 0.25F * x);
}

void draw_ring(const GlFunctions& gl, GLenum mode, int count) {
  gl.Begin(mode);
  for (int i = 0; i < count; ++i) {
    const float f = static_cast<float>(i);
    const bool strip = mode == GL_TRIANGLE_STRIP || mode == GL_QUAD_STRIP;
    const float angle = 0.7854F * f + 0.1F;
    const float x = strip ? -0.9F + 0.25F * f : 0.9F * std::cos(angle);
    const float y = strip ? (i % 2 == 0 ? -0.7F : 0.7F) : 0.85F * std::sin(angle);
    color_by_position(gl, x, y, 0.1F * f);
    gl.Vertex2f(x, y);
  }
  gl.End();
}

Mesh sphere_mesh(int slices, int stacks) {
  const auto to_byte = [](float value) {
    return static_cast<GLubyte>(std::lround(127.5F + 127.5F * value));
  };
  Mesh mesh;
  for (int stack = 0; stack <= stacks; ++stack) {
    for (int slice = 0; slice <= slices; ++slice) {
      const Point n =
          sphere_point(static_cast<float>(slice) / static_cast<float>(slices),
                       static_cast<float>(stack) / static_cast<float>(stacks), true, 1.0F, 0.0F);
      mesh.vertices.push_back(
          {{n.x, n.y, n.z}, {n.x, n.y, n.z}, {to_byte(n.x), to_byte(n.y), to_byte(-n.z), 255}});
    }
  }
  for (int stack = 0; stack < stacks; ++stack) {
    for (int slice = 0; slice < slices; ++slice) {
      const int corner = stack * (slices + 1) + slice;
      for (const int offset : {0, 1, slices + 2, 0, slices + 2, slices + 1})
        mesh.triangle_indices.push_back(static_cast<GLushort>(corner + offset));
    }
  }
  return mesh;
}

void in_quarter(const GlFunctions& gl, int column, int row, const Draw& draw) {
  constexpr int half = scene_size / 2;
  gl.Viewport(column * half, row * half, half, half);
  draw(gl);
  gl.Viewport(0, 0, scene_size, scene_size);
}

Scene lit_sphere_scene(std::string name, Draw set) {
  return {std::move(name), [set = std::move(set)](const GlFunctions& gl) {
            begin_lit_scene(gl);
            set(gl);
            draw_sphere(gl);
          }};
}

}  // namespace legacy_gl::test
