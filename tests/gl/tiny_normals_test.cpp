// GL_NORMALIZE takes a normal's direction, however short it is (GL 2.1 spec 2.11.3), on every way
// that normals go: the picture is that of normals of ordinary length.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "support/contexts.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {
namespace {

/// Draws the scene with normals that were multiplied by this.
using Frame = std::function<void(const GlFunctions& gl, double factor)>;

constexpr int kSize = 64;
constexpr int kColumns = 40;  // more vertices than small objects have

struct Vertex {
  std::array<float, 3> position, normal;
  std::array<double, 3> normal_double;
};

Vertex vertex(double u, double v, double factor) {
  Vertex out;
  const std::array<double, 3> n{std::sin(3 * u - 1.5), v - 0.5, std::cos(4 * u)};
  out.position = {static_cast<float>(2 * u - 1), static_cast<float>(2 * v - 1), 0};
  for (std::size_t c = 0; c < 3; ++c) {
    out.normal[c] = static_cast<float>(n[c] * factor);
    out.normal_double[c] = n[c] * factor;
  }
  return out;
}

std::vector<Vertex> strip(int columns, double factor) {
  std::vector<Vertex> vertices;
  for (int i = 0; i <= columns; ++i)
    for (const double v : {0.0, 1.0}) vertices.push_back(vertex(double(i) / columns, v, factor));
  return vertices;
}

std::vector<Vertex> triangles(int columns, double factor) {
  const std::vector<Vertex> corners = strip(columns, factor);
  std::vector<Vertex> vertices;
  for (std::size_t i = 0; i + 2 < corners.size(); ++i)
    vertices.insert(vertices.end(), {corners[i], corners[i + 1], corners[i + 2]});
  return vertices;
}

void draw_strip(const GlFunctions& gl, int columns, double factor) {
  gl.Begin(GL_TRIANGLE_STRIP);
  for (const Vertex& v : strip(columns, factor)) {
    gl.Normal3fv(v.normal.data());
    gl.Vertex3fv(v.position.data());
  }
  gl.End();
}

void draw_quad(const GlFunctions& gl) {
  gl.Begin(GL_QUADS);
  for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) gl.Vertex2i(x, y);
  gl.End();
}

void draw_arrays(const GlFunctions& gl, const std::vector<Vertex>& vertices, GLenum type) {
  gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), vertices.front().position.data());
  const void* const normals = type == GL_DOUBLE
                                  ? static_cast<const void*>(vertices.front().normal_double.data())
                                  : vertices.front().normal.data();
  gl.NormalPointer(type, sizeof(Vertex), normals);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
}

void normal_of_quads(const GlFunctions& gl, double factor) {
  const Vertex v = vertex(0.25, 0.9, factor);
  gl.Normal3fv(v.normal.data());
}

void call_compiled(const GlFunctions& gl, const std::function<void()>& content) {
  gl.NewList(1, GL_COMPILE);
  content();
  gl.EndList();
  gl.CallList(1);
}

void expect_same_picture(const Frame& frame) {
  const auto picture = [&frame](legacy_gl_quality quality, double factor) {
    legacy_gl_options options = {};
    options.quality = quality;
    CoreContext context(kSize, kSize, PixelFormat::rgba8, options);
    const GlFunctions& gl = context.gl;
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_NORMALIZE);
    gl.Rotatef(20, 0, 0.3F, 1);
    gl.Scalef(0.8F, 0.7F, 0.9F);
    const std::array<float, 4> color{0.4F, 0.6F, 0.8F, 1}, position{0.3F, 0.5F, 1, 0};
    gl.Materialfv(GL_FRONT, GL_SPECULAR, color.data());
    gl.Materialf(GL_FRONT, GL_SHININESS, 20);
    gl.Lightfv(GL_LIGHT0, GL_POSITION, position.data());
    frame(gl, factor);
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
    return context.read_rgba8();
  };
  for (const legacy_gl_quality quality : {LEGACY_GL_QUALITY_DEFAULT, LEGACY_GL_QUALITY_PRECISE}) {
    const Image expected = picture(quality, 1);
    EXPECT_GT(covered_pixels(expected), kSize * kSize / 4);
    // A denormal number of this size has 17 bits. One step: of rounding.
    for (const double factor : {1e-40, 3e-39, 1e-36, 1e-30})
      EXPECT_TRUE(images_match(picture(quality, factor), expected, {.max_difference_steps = 1},
                               "tiny_normals"))
          << "times " << factor;
  }
}

TEST(TinyNormals, BetweenBeginAndEnd) {
  expect_same_picture([](const GlFunctions& gl, double factor) { draw_strip(gl, 20, factor); });
}

TEST(TinyNormals, CurrentForAWholePrimitive) {
  expect_same_picture([](const GlFunctions& gl, double factor) {
    normal_of_quads(gl, factor);
    draw_quad(gl);
  });
}

TEST(TinyNormals, OfSmallObjects) {
  expect_same_picture([](const GlFunctions& gl, double factor) {
    for (int i = 0; i < 6; ++i) {
      gl.Rotatef(15, 0, 0, 1);
      draw_strip(gl, 3, factor);
    }
  });
}

TEST(TinyNormals, InLists) {
  for (const int columns : {3, 2 * kColumns})
    expect_same_picture([columns](const GlFunctions& gl, double factor) {
      call_compiled(gl, [&] { draw_strip(gl, columns, factor); });
      gl.Rotatef(90, 0, 0, 1);
      gl.CallList(1);
    });
}

TEST(TinyNormals, CurrentWhereAListHasNone) {
  expect_same_picture([](const GlFunctions& gl, double factor) {
    call_compiled(gl, [&] { draw_quad(gl); });
    normal_of_quads(gl, factor);
    for (int i = 0; i < 4; ++i) {
      gl.Rotatef(30, 0, 0, 1);
      gl.CallList(1);
    }
  });
}

TEST(TinyNormals, InClientArrays) {
  for (const GLenum type : {GLenum{GL_FLOAT}, GLenum{GL_DOUBLE}})
    for (const int columns : {kColumns, 800})  // the latter past the recorder, were they longer
      expect_same_picture([=](const GlFunctions& gl, double factor) {
        draw_arrays(gl, triangles(columns, factor), type);
      });
}

TEST(TinyNormals, CurrentForArraysInBuffers) {
  expect_same_picture([](const GlFunctions& gl, double factor) {
    const std::vector<Vertex> vertices = triangles(kColumns, 1);
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                  vertices.data(), GL_STATIC_DRAW);
    gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), nullptr);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    normal_of_quads(gl, factor);
    gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
  });
}

}  // namespace
}  // namespace legacy_gl::test
