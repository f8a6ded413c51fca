// Lighting in every fragment against the oracle, pixel by pixel: the quality, and
// glShadeModel(GL_PHONG_WIN) of GL_WIN_phong_shading.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "oracle/random.hpp"
#include "oracle/sampler.hpp"
#include "oracle/single_vertex.hpp"
#include "support/contexts.hpp"

namespace oracle {
namespace {

using legacy_gl::test::CoreContext;
using legacy_gl::test::GlesContext;
using legacy_gl::test::PixelFormat;
using legacy_gl::test::RenderContext;

constexpr int size = 32;
// What the rounding of interpolated normals leaves, which shininess amplifies: as much as Mesa's
// fixed function has at vertices.
constexpr double bound_steps = 5e-3;
// As far as an interpolated cosine can be on the wrong side of a jump.
constexpr double jump_tolerance = 1e-4;

glm::dvec3 vec(const std::array<float, 3>& v) { return {double(v[0]), double(v[1]), double(v[2])}; }

// A triangle over the whole viewport, of which the normals turn by some 70 degrees.
std::array<Vertex, 3> triangle(Random& random, float radius) {
  constexpr std::array<std::array<float, 2>, 3> corners{{{-1, -1}, {3, -1}, {-1, 3}}};
  const auto main = random.unit_vector();
  std::array<Vertex, 3> vertices;
  for (std::size_t i = 0; i < 3; ++i) {
    vertices[i].position_object = {radius * corners[i][0], radius * corners[i][1],
                                   radius * random.uniform(-1, 1), 1};
    const auto aside = random.unit_vector();
    for (std::size_t c = 0; c < 3; ++c) vertices[i].normal_object[c] = main[c] + 0.6f * aside[c];
    const float length = std::hypot(vertices[i].normal_object[0], vertices[i].normal_object[1],
                                    vertices[i].normal_object[2]);
    for (float& c : vertices[i].normal_object) c /= length;
    vertices[i].color = random.color(1, random.unit());
  }
  return vertices;
}

// What Phong interpolation gives a pixel: the direction of the normal in eye coordinates and its
// length are interpolated each, position and colour linearly.
Vertex interpolated(const State& state, const std::array<Vertex, 3>& vertices,
                    const std::array<double, 3>& weights) {
  const glm::dmat3 modelview(glm::make_mat4(state.modelview.data()));
  const glm::dmat3 to_eye = glm::transpose(glm::inverse(modelview));
  glm::dvec3 direction(0);
  double length = 0;
  std::array<double, 4> position{}, color{};
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 n = to_eye * vec(vertices[i].normal_object);
    direction += weights[i] * glm::normalize(n);
    length += weights[i] * glm::length(n);
    for (std::size_t c = 0; c < 4; ++c) {
      position[c] += weights[i] * double(vertices[i].position_object[c]);
      color[c] += weights[i] * double(vertices[i].color[c]);
    }
  }
  const glm::dvec3 normal = glm::transpose(modelview) * (length * glm::normalize(direction));
  Vertex vertex;
  for (std::size_t c = 0; c < 4; ++c) {
    vertex.position_object[c] = float(position[c]);
    vertex.color[c] = float(color[c]);
  }
  for (int c = 0; c < 3; ++c) vertex.normal_object[std::size_t(c)] = float(normal[c]);
  return vertex;
}

void draw(const GlFunctions& gl, const std::array<Vertex, 3>& vertices, bool back) {
  gl.Begin(GL_TRIANGLES);
  for (const std::size_t i :
       back ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2}) {
    gl.Color4fv(vertices[i].color.data());
    gl.Normal3fv(vertices[i].normal_object.data());
    gl.Vertex4fv(vertices[i].position_object.data());
  }
  gl.End();
}

double largest_error(RenderContext& context, const LightingClass& lighting_class,
                     GLenum shade_model, std::uint32_t number) {
  Random random(3, number);
  const Batch batch = lighting_class.make(3, number);
  const auto vertices = triangle(random, batch.object_radius);
  const bool back = batch.state.light_model.two_side && number % 2 != 0;
  const GlFunctions& gl = context.gl;
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Disable(GL_DITHER);
  apply_state(gl, batch.state, placing_projection(batch.state.modelview, batch.object_radius));
  gl.ShadeModel(shade_model);
  draw(gl, vertices, back);
  const auto picture = context.read_float();
  double largest = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double right = (2 * (x + 0.5) / size) / 4, up = (2 * (y + 0.5) / size) / 4;
      const Vertex vertex = interpolated(batch.state, vertices, {1 - right - up, right, up});
      const Result result = evaluate(batch.state, vertex);
      if (!result.defined || result.distance_to_jump < jump_tolerance) continue;
      Color color;
      std::copy_n(picture.floats.begin() + 4 * (y * size + x), 4, color.begin());
      const Facing facing = back ? Facing::back : Facing::front;
      largest =
          std::max(largest, difference_steps(color, expected_color(batch.state, vertex, facing)));
    }
  return largest;
}

void expect_the_equation(RenderContext& context, GLenum shade_model) {
  context.make_current();
  for (const LightingClass& lighting_class : lighting_classes()) {
    double largest = 0;
    for (std::uint32_t number = 0; number < 2; ++number)
      largest = std::max(largest, largest_error(context, lighting_class, shade_model, number));
    std::printf("%-34s %.2e\n", lighting_class.name.c_str(), largest);
    EXPECT_LE(largest, bound_steps) << lighting_class.name;
  }
}

legacy_gl_options per_fragment() {
  legacy_gl_options options = {};
  options.quality = LEGACY_GL_QUALITY_PER_FRAGMENT;
  return options;
}

TEST(PerFragment, QualityOnTheCoreProfile) {
  CoreContext context(size, size, PixelFormat::rgba32f, per_fragment());
  expect_the_equation(context, GL_SMOOTH);
}

TEST(PerFragment, ShadeModelOnTheCoreProfile) {
  CoreContext context(size, size, PixelFormat::rgba32f);
  expect_the_equation(context, GL_PHONG_WIN);
}

TEST(PerFragment, ShadeModelOnGles) {
  GlesContext context(size, size, PixelFormat::rgba32f);
  expect_the_equation(context, GL_PHONG_WIN);
}

// Flat shading stays flat: the provoking vertex's colour.
TEST(PerFragment, FlatShadingIsOfVertices) {
  CoreContext context(size, size, PixelFormat::rgba32f, per_fragment());
  const Batch batch = lighting_classes()[3].make(3, 0);
  Random random(3, 0);
  const auto vertices = triangle(random, 1);
  apply_state(context.gl, batch.state, placing_projection(batch.state.modelview, 1));
  context.gl.ShadeModel(GL_FLAT);
  draw(context.gl, vertices, false);
  const auto picture = context.read_float();
  for (std::size_t i = 0; i < picture.floats.size(); i += 4) {
    Color color;
    std::copy_n(picture.floats.begin() + std::ptrdiff_t(i), 4, color.begin());
    ASSERT_LE(difference_steps(color, expected_color(batch.state, vertices[2])), 1e-3);
  }
}

TEST(PhongShading, ShadeModelHintAndQueries) {
  CoreContext context(4, 4);
  const GlFunctions& gl = context.gl;
  GLint value = 0;
  gl.GetIntegerv(GL_PHONG_HINT_WIN, &value);
  EXPECT_EQ(value, GL_DONT_CARE);
  gl.Hint(GL_PHONG_HINT_WIN, GL_NICEST);
  gl.GetIntegerv(GL_PHONG_HINT_WIN, &value);
  EXPECT_EQ(value, GL_NICEST);
  gl.ShadeModel(GL_PHONG_WIN);
  gl.GetIntegerv(GL_SHADE_MODEL, &value);
  EXPECT_EQ(value, GL_PHONG_WIN);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  const std::string extensions = reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS));
  EXPECT_NE(extensions.find("GL_WIN_phong_shading"), std::string::npos);
}

// Nothing lit, nothing changed: the same program and the same picture.
TEST(PhongShading, AnUnlitDrawIsSmooth) {
  CoreContext context(size, size, PixelFormat::rgba32f);
  const GlFunctions& gl = context.gl;
  Random random(3, 0);
  const auto vertices = triangle(random, 1);
  const auto picture_by = [&](GLenum shade_model) {
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.ShadeModel(shade_model);
    draw(gl, vertices, false);
    return context.read_float().floats;
  };
  const auto smooth = picture_by(GL_SMOOTH);
  EXPECT_EQ(picture_by(GL_PHONG_WIN), smooth);
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  EXPECT_EQ(statistics.programs_compiled, 1U);
}

}  // namespace
}  // namespace oracle
