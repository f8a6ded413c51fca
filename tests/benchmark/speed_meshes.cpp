#include "benchmark/speed_meshes.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace legacy_gl::test {

namespace {

SpeedVertex bumpy_sphere(double u, double v) {
  const double longitude = 2 * std::numbers::pi * u, latitude = std::numbers::pi * (v - 0.5);
  const auto point = [](double a, double b) {
    const double radius = 1 + 0.05 * std::sin(9 * a) * std::sin(6 * b);  // the poles are points
    return std::array<double, 3>{radius * std::cos(b) * std::cos(a), radius * std::sin(b),
                                 radius * std::cos(b) * std::sin(a)};
  };
  constexpr double kStep = 1e-5;
  const auto p = point(longitude, latitude);
  const auto along = point(longitude + kStep, latitude), up = point(longitude, latitude + kStep);
  std::array<double, 3> a{}, b{};
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = along[i] - p[i];
    b[i] = up[i] - p[i];
  }
  std::array<double, 3> n{b[1] * a[2] - b[2] * a[1], b[2] * a[0] - b[0] * a[2],
                          b[0] * a[1] - b[1] * a[0]};
  double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (length < 1e-16) {  // a pole
    n = p;
    length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  }
  SpeedVertex vertex{};
  for (std::size_t i = 0; i < 3; ++i) {
    vertex.position[i] = static_cast<float>(p[i]);
    vertex.normal[i] = static_cast<float>(n[i] / length);
  }
  return vertex;
}

StripMesh make_mesh(std::size_t wanted) {
  const auto rows =
      static_cast<std::size_t>(std::max(4.0, std::sqrt(static_cast<double>(wanted) / 2)));
  const std::size_t columns = std::max<std::size_t>(4, wanted / (2 * rows));
  StripMesh mesh;
  mesh.strip_length = 2 * columns;
  const auto at = [&](std::size_t row, std::size_t column) {
    return bumpy_sphere(static_cast<double>(column) / static_cast<double>(columns - 1),
                        static_cast<double>(row) / static_cast<double>(rows));
  };
  for (std::size_t row = 0; row <= rows; ++row)
    for (std::size_t column = 0; column < columns; ++column)
      mesh.shared_vertices.push_back(at(row, column));
  const auto shared = [columns](std::size_t row, std::size_t column) {
    return static_cast<GLuint>(row * columns + column);
  };
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      mesh.vertices.push_back(mesh.shared_vertices[shared(row + 1, column)]);
      mesh.vertices.push_back(mesh.shared_vertices[shared(row, column)]);
    }
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const GLuint a = shared(row, column), b = shared(row, column + 1);
      const GLuint c = shared(row + 1, column), d = shared(row + 1, column + 1);
      mesh.triangle_indices.insert(mesh.triangle_indices.end(), {c, a, d, d, a, b});
    }
  }
  return mesh;
}

}  // namespace

const StripMesh& strip_mesh(std::size_t vertices) {
  static std::map<std::size_t, StripMesh> meshes;
  const auto at = meshes.find(vertices);
  return at != meshes.end() ? at->second
                            : meshes.emplace(vertices, make_mesh(vertices)).first->second;
}

void draw_ball(const GlFunctions& gl, float radius, int slices, int stacks) {
  constexpr float kPi = 3.14159265F;
  for (int stack = 0; stack < stacks; ++stack) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int slice = 0; slice <= slices; ++slice)
      for (const int row : {stack + 1, stack}) {
        const float b = kPi * (static_cast<float>(row) / static_cast<float>(stacks) - 0.5F);
        const float a = 2 * kPi * static_cast<float>(slice) / static_cast<float>(slices);
        const std::array n{std::cos(b) * std::cos(a), std::sin(b), std::cos(b) * std::sin(a)};
        gl.Normal3fv(n.data());
        gl.Vertex3f(radius * n[0], radius * n[1], radius * n[2]);
      }
    gl.End();
  }
}

}  // namespace legacy_gl::test
