// NaN and infinities in each parameter of each call that lighting reads: what is drawn is finite
// and in [0,1], and once the parameter is mended the picture is what it was before.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "oracle/sampler.hpp"
#include "oracle/single_vertex.hpp"

namespace oracle {
namespace {

using legacy_gl::test::CoreContext;
using legacy_gl::test::GlesContext;
using legacy_gl::test::PixelFormat;
using legacy_gl::test::RenderContext;

constexpr int size = 2;

constexpr std::array<float, 3> bad_values{std::numeric_limits<float>::quiet_NaN(),
                                          std::numeric_limits<float>::infinity(),
                                          -std::numeric_limits<float>::infinity()};

// Two lights with everything that a light can have, tracking off.
State everything() {
  State state;
  Light point;
  point.ambient = {0.1f, 0.1f, 0.1f, 1};
  point.position_specified = {1, 2, 3, 1};
  point.spot_direction_specified = {-1, -2, -3};
  point.spot_cutoff_degrees = 60;
  point.spot_exponent = 2;
  point.linear_attenuation = 0.25f;
  point.quadratic_attenuation = 0.125f;
  Light directional;
  directional.position_specified = {1, 0, 1, 0};
  state.lights = {point, directional};
  state.front.specular = {0.25f, 0.25f, 0.25f, 1};
  state.front.emission = {0.0625f, 0, 0, 1};
  state.front.shininess = 5;
  state.back = state.front;
  state.light_model.local_viewer = true;
  state.normalize = true;
  return state;
}

Vertex ordinary_vertex() {
  Vertex vertex;
  vertex.position_object = {0.25f, 0, -1, 1};
  return vertex;
}

// Calls `set` with a copy of `values` that has `bad` in one place, for each place.
void each_component(const std::vector<float>& values, float bad,
                    const std::function<void(const float*)>& set) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::vector<float> copy = values;
    copy[i] = bad;
    set(copy.data());
  }
}

struct Parameter {
  std::string name;
  std::vector<float> values;
  void (*set)(const GlFunctions& gl, const float* values);
};

// The calls that change state before a vertex. What does not fit one array is scalar.
const std::vector<Parameter>& parameters() {
  using Gl = const GlFunctions&;
  using Values = const float*;
  static const std::vector<Parameter> all{
      {"light ambient",
       {0, 0, 0, 1},
       [](Gl gl, Values v) { gl.Lightfv(GL_LIGHT0, GL_AMBIENT, v); }},
      {"light diffuse",
       {1, 1, 1, 1},
       [](Gl gl, Values v) { gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, v); }},
      {"light specular",
       {1, 1, 1, 1},
       [](Gl gl, Values v) { gl.Lightfv(GL_LIGHT0, GL_SPECULAR, v); }},
      {"light position",
       {1, 2, 3, 1},
       [](Gl gl, Values v) { gl.Lightfv(GL_LIGHT0, GL_POSITION, v); }},
      {"light direction",
       {1, 2, 3, 0},
       [](Gl gl, Values v) { gl.Lightfv(GL_LIGHT1, GL_POSITION, v); }},
      {"spot direction",
       {-1, -2, -3},
       [](Gl gl, Values v) { gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, v); }},
      {"spot exponent", {2}, [](Gl gl, Values v) { gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, v[0]); }},
      {"spot cutoff", {60}, [](Gl gl, Values v) { gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, v[0]); }},
      {"constant attenuation",
       {1},
       [](Gl gl, Values v) { gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, v[0]); }},
      {"linear attenuation",
       {1},
       [](Gl gl, Values v) { gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, v[0]); }},
      {"quadratic attenuation",
       {1},
       [](Gl gl, Values v) { gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, v[0]); }},
      {"light model ambient",
       {0, 0, 0, 1},
       [](Gl gl, Values v) { gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, v); }},
      {"material ambient",
       {0, 0, 0, 1},
       [](Gl gl, Values v) { gl.Materialfv(GL_FRONT, GL_AMBIENT, v); }},
      {"material diffuse",
       {0, 0, 0, 1},
       [](Gl gl, Values v) { gl.Materialfv(GL_FRONT, GL_DIFFUSE, v); }},
      {"material specular",
       {0, 0, 0, 1},
       [](Gl gl, Values v) { gl.Materialfv(GL_FRONT, GL_SPECULAR, v); }},
      {"material emission",
       {0, 0, 0, 1},
       [](Gl gl, Values v) { gl.Materialfv(GL_FRONT, GL_EMISSION, v); }},
      {"material shininess",
       {5},
       [](Gl gl, Values v) { gl.Materialf(GL_FRONT, GL_SHININESS, v[0]); }},
      {"tracked colour",
       {1, 0, 0, 1},
       [](Gl gl, Values v) {
         gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
         gl.Enable(GL_COLOR_MATERIAL);
         gl.Color4fv(v);
       }},
      {"light position under a modelview",
       {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
       [](Gl gl, Values v) {
         constexpr std::array<float, 4> position{1, 2, 3, 1};
         gl.MatrixMode(GL_MODELVIEW);
         gl.LoadMatrixf(v);
         gl.Lightfv(GL_LIGHT0, GL_POSITION, position.data());
         gl.LoadIdentity();
       }},
      {"spot direction under glRotate",
       {30, 0, 1, 0},
       [](Gl gl, Values v) {
         constexpr std::array<float, 3> direction{-1, -2, -3};
         gl.MatrixMode(GL_MODELVIEW);
         gl.LoadIdentity();
         gl.Rotatef(v[0], v[1], v[2], v[3]);
         gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction.data());
         gl.LoadIdentity();
       }},
  };
  return all;
}

bool is_presentable(const Color& color) {
  return std::all_of(color.begin(), color.end(),
                     [](float c) { return std::isfinite(c) && c >= 0 && c <= 1; });
}

void expect_no_poison(RenderContext& context) {
  const State calm = everything();
  const Vertex vertex = ordinary_vertex();
  const Color before = draw_lit_vertex(context, calm, vertex);
  ASSERT_LT(difference_steps(before, expected_color(calm, vertex)), 0.02);
  for (const float bad : bad_values) {
    for (const Parameter& parameter : parameters()) {
      each_component(parameter.values, bad, [&](const float* values) {
        apply_state(context.gl, calm, identity_matrix);
        parameter.set(context.gl, values);
        const Color color = draw_vertex(context, calm.modelview, vertex);
        EXPECT_TRUE(is_presentable(color)) << parameter.name << " " << bad << ": " << color[0]
                                           << " " << color[1] << " " << color[2] << " " << color[3];
        context.gl.Color4f(1, 1, 1, 1);
        while (context.gl.GetError() != GL_NO_ERROR) {
        }
        EXPECT_EQ(draw_lit_vertex(context, calm, vertex), before) << "after " << parameter.name;
      });
    }
  }
}

void expect_no_poison_by_vertices(RenderContext& context) {
  const State calm = everything();
  const Vertex vertex = ordinary_vertex();
  const Color before = draw_lit_vertex(context, calm, vertex);
  const auto expect_calm_after = [&](const State& state, const Vertex& bad, const char* what) {
    EXPECT_TRUE(is_presentable(draw_lit_vertex(context, state, bad))) << what;
    EXPECT_EQ(draw_lit_vertex(context, calm, vertex), before) << "after " << what;
  };
  for (const float bad : bad_values) {
    for (std::size_t i = 0; i < 4; ++i) {
      Vertex position = vertex, normal = vertex, color = vertex;
      position.position_object[i] = bad;
      expect_calm_after(calm, position, "position");
      if (i < 3) {
        normal.normal_object[i] = bad;
        expect_calm_after(calm, normal, "normal");
        State as_given = calm;
        as_given.normalize = false;
        expect_calm_after(as_given, normal, "normal, not normalized");
      }
      color.color[i] = bad;
      State tracking = calm;
      tracking.color_material.enabled = true;
      expect_calm_after(tracking, color, "colour");
    }
    for (std::size_t i = 0; i < 16; ++i) {
      State state = calm;
      state.modelview[i] = double(bad);
      expect_calm_after(state, vertex, "modelview");
    }
  }
}

TEST(NotFinite, StateOnTheCoreProfile) {
  CoreContext context(size, size, PixelFormat::rgba32f);
  expect_no_poison(context);
}

TEST(NotFinite, StateOnGles) {
  GlesContext context(size, size, PixelFormat::rgba32f);
  expect_no_poison(context);
}

TEST(NotFinite, VerticesOnTheCoreProfile) {
  CoreContext context(size, size, PixelFormat::rgba32f);
  expect_no_poison_by_vertices(context);
}

TEST(NotFinite, VerticesOnGles) {
  GlesContext context(size, size, PixelFormat::rgba32f);
  expect_no_poison_by_vertices(context);
}

}  // namespace
}  // namespace oracle
