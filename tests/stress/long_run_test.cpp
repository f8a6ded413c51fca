// A long run in which little changes from draw to draw: what was uploaded once, thousands of draws
// ago, still holds when the buffers that carry the changes have been reused many times.
#include <gtest/gtest.h>

#include "oracle/sampler.hpp"
#include "oracle/single_vertex.hpp"

namespace oracle {
namespace {

using legacy_gl::test::CoreContext;
using legacy_gl::test::GlesContext;
using legacy_gl::test::PixelFormat;
using legacy_gl::test::RenderContext;

// More than 16 MB of uniforms and 1 MB of vertices at the smallest.
constexpr int draws = 60000;

void expect_steady(RenderContext& context) {
  State state;
  Light light;
  light.position_specified = {0, 3, 4, 1};
  light.linear_attenuation = 0.25f;
  state.lights = {light};
  state.front.diffuse = {0.25f, 0.5f, 0.75f, 1};
  const GlFunctions& gl = context.gl;
  gl.ClearColor(0, 0, 0, 0);
  apply_state(gl, state, identity_matrix);
  gl.PointSize(8);
  int wrong = 0;
  for (int i = 0; i < draws; ++i) {
    state.front.emission[0] = float(i % 256) / 512;
    gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, state.front.emission.data());
    gl.Begin(GL_POINTS);
    gl.Normal3f(0, 0, 1);
    gl.Vertex4f(0, 0, 0, 1);
    gl.End();
    if (i % 97 != 0) continue;
    const auto picture = context.read_float();
    const Color color{picture.floats[0], picture.floats[1], picture.floats[2], picture.floats[3]};
    if (difference_steps(color, expected_color(state, {})) > 0.02) ++wrong;
    gl.Clear(GL_COLOR_BUFFER_BIT);
  }
  EXPECT_EQ(wrong, 0);
}

TEST(LongRun, CoreProfile) {
  CoreContext context(2, 2, PixelFormat::rgba32f);
  expect_steady(context);
}

TEST(LongRun, Gles) {
  GlesContext context(2, 2, PixelFormat::rgba32f);
  expect_steady(context);
}

}  // namespace
}  // namespace oracle
