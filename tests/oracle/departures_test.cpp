// Where Mesa's fixed function departs from the specification (docs/deviations.md, rows M1 to M9).
// Each test shows Mesa's departure, so that a Mesa that mends it is noticed, and asks this library
// for what the oracle says.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "oracle/sampler.hpp"
#include "oracle/single_vertex.hpp"

namespace oracle {
namespace {

using legacy_gl::test::CoreContext;
using legacy_gl::test::GlesContext;
using legacy_gl::test::MesaContext;
using legacy_gl::test::PixelFormat;
using legacy_gl::test::RenderContext;

constexpr int size = 4;

// Two roundings of a half-range float colour per term and a few terms, well below a visible step.
constexpr double our_tolerance_steps = 0.02;

using Draw = std::function<Color(RenderContext&)>;

// Draws on a fresh context of each kind.
void expect_departure(const Draw& draw, const std::array<double, 4>& expected,
                      double mesa_at_least_steps) {
  {
    MesaContext mesa(size, size, PixelFormat::rgba32f);
    const double error = difference_steps(draw(mesa), expected);
    EXPECT_GT(error, mesa_at_least_steps) << "Mesa no longer departs";
  }
  {
    CoreContext core(size, size, PixelFormat::rgba32f);
    EXPECT_LT(difference_steps(draw(core), expected), our_tolerance_steps) << "core profile";
  }
  {
    GlesContext gles(size, size, PixelFormat::rgba32f);
    EXPECT_LT(difference_steps(draw(gles), expected), our_tolerance_steps) << "GLES";
  }
}

void expect_departure(const State& state, const Vertex& vertex, double mesa_at_least_steps,
                      Facing facing = Facing::front) {
  ASSERT_TRUE(evaluate(state, vertex).defined);
  expect_departure(
      [&](RenderContext& context) { return draw_lit_vertex(context, state, vertex, facing); },
      expected_color(state, vertex, facing), mesa_at_least_steps);
}

State one_light(std::array<float, 4> position) {
  State state;
  Light light;
  light.position_specified = position;
  state.lights = {light};
  state.light_model.ambient = {0, 0, 0, 1};
  state.front.ambient = state.front.diffuse = {0, 0, 0, 1};
  state.back = state.front;
  return state;
}

TEST(MesaDeparts, M1ShininessZeroWithASpotOrAttenuatedLight) {
  // n.L = 1/2, specular product 1/2: 1/2 is right, Mesa gives (1/2)^(1/2) of it.
  State state = one_light({0, std::sqrt(3.f), 1, 1});
  state.front.specular = {0.5f, 0.5f, 0.5f, 1};
  state.lights[0].spot_direction_specified = {0, -std::sqrt(3.f), -1};
  state.lights[0].spot_cutoff_degrees = 60;
  EXPECT_NEAR(expected_color(state, {})[0], 0.5, 1e-12);
  expect_departure(state, {}, 30);
  state.lights[0].spot_cutoff_degrees = 180;
  state.lights[0].constant_attenuation = 2;
  EXPECT_NEAR(expected_color(state, {})[0], 0.25, 1e-12);
  expect_departure(state, {}, 15);
}

State spot_on_diffuse(std::array<float, 4> position, float cutoff_degrees) {
  State state = one_light(position);
  state.front.diffuse = {0.75f, 0.75f, 0.75f, 1};
  state.lights[0].spot_cutoff_degrees = cutoff_degrees;
  return state;
}

TEST(MesaDeparts, M2SpotVertexExactlyOnTheCone) {
  expect_departure(spot_on_diffuse({0, 1, 1, 1}, 45), {}, 100);
}

TEST(MesaDeparts, M2SpotCutoffZero) { expect_departure(spot_on_diffuse({0, 0, 1, 1}, 0), {}, 150); }

TEST(MesaDeparts, M2SpotCutoffBelowAHundredthOfADegree) {
  // Half way out in a cone of .01 degrees.
  Vertex vertex;
  vertex.position_object[0] = 8.7e-5f;
  expect_departure(spot_on_diffuse({0, 0, 1, 1}, 0.01f), vertex, 150);
}

TEST(MesaDeparts, M3VertexWOtherThanOne) {
  State state = one_light({0, 0, 1, 1});
  state.front.diffuse = {0.75f, 0.75f, 0.75f, 1};
  Vertex vertex;
  vertex.position_object = {1, 0, 0, 2};
  expect_departure(state, vertex, 25);
}

TEST(MesaDeparts, M3PerspectiveRowInTheModelview) {
  State state = one_light({0, 0, 1, 1});
  state.front.diffuse = {0.75f, 0.75f, 0.75f, 1};
  state.modelview[3] = 1;  // w = 1 + x
  Vertex vertex;
  vertex.position_object = {1, 0, 0, 1};
  expect_departure(state, vertex, 25);
}

TEST(MesaDeparts, M4TwoSidedWithShininessZeroOnOneFace) {
  // n.L = .6, n.h = -.2 / sqrt 2: with shininess 0 the specular factor is 0^0 = 1.
  State state = one_light({0, 1, 0, 0});
  state.light_model.two_side = true;
  state.front.specular = {0.3125f, 0.3125f, 0.3125f, 1};
  state.back.shininess = 10;
  Vertex vertex;
  vertex.normal_object = {0, 0.6f, -0.8f};
  EXPECT_EQ(expected_color(state, vertex)[0], 0.3125);
  expect_departure(state, vertex, 75);
}

TEST(MesaDeparts, M5TrackingBeginsWithTheCurrentColor) {
  State state = one_light({0, 0, 1, 0});
  state.front.diffuse = state.back.diffuse = {0, 0.5f, 0, 1};
  const auto draw = [&](RenderContext& context) {
    State before = state;
    before.front.diffuse = before.back.diffuse = {1, 0, 0, 1};
    apply_state(context.gl, before, identity_matrix);
    context.gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, before.front.diffuse.data());
    context.gl.Color4fv(state.front.diffuse.data());
    context.gl.ColorMaterial(GL_FRONT_AND_BACK, GL_DIFFUSE);
    context.gl.Enable(GL_COLOR_MATERIAL);
    return draw_vertex(context, state.modelview, {});
  };
  expect_departure(draw, expected_color(state, {}), 100);
}

TEST(MesaDeparts, M6TrackingTheBackFaceAlone) {
  State state = one_light({0, 3, -4, 0});
  state.light_model.two_side = true;
  state.light_model.ambient = {0.25f, 0.25f, 0.25f, 1};
  state.front.ambient = state.back.ambient = {0.5f, 0.5f, 0.5f, 1};
  state.color_material = {true, ColorMaterial::Face::back, ColorMaterial::Mode::diffuse};
  Vertex vertex;
  vertex.color = {0.25f, 0.5f, 0.75f, 1};
  expect_departure(state, vertex, 30, Facing::back);
}

TEST(MesaDeparts, M7RescaleUnderALargeScale) {
  State state = one_light({0, 3, 4, 0});
  state.front.diffuse = {0.875f, 0.875f, 0.875f, 1};
  state.rescale_normal = true;
  state.modelview = {1e7, 0, 0, 0, 0, 1e7, 0, 0, 0, 0, 1e7, 0, 0, 0, 0, 1};
  expect_departure(state, {}, 150);
}

TEST(MesaDeparts, M8LightExactlyAtTheVertex) {
  // The specification has no answer; white is no good one. The lost direction counts as zero, and
  // what needs none (emission, ambient) stays.
  State state = one_light({1, 2, 3, 1});
  state.front.diffuse = state.front.ambient = {0.5f, 0.5f, 0.5f, 1};
  state.front.emission = {0.125f, 0, 0, 1};
  state.lights[0].ambient = {0.25f, 0.25f, 0.25f, 1};
  state.lights[0].linear_attenuation = 1;
  Vertex vertex;
  vertex.position_object = {1, 2, 3, 1};
  EXPECT_EQ(expected_color(state, vertex)[0], 0.25);
  expect_departure([&](RenderContext& context) { return draw_lit_vertex(context, state, vertex); },
                   expected_color(state, vertex), 100);
}

TEST(MesaDeparts, M9PoppingLightsAndMaterialsChangedTogether) {
  // Mesa loses the pop of a glMaterial after which nothing was drawn.
  State state = one_light({0, 0, 1, 0});
  state.front.diffuse = {0.25f, 0.5f, 0.75f, 1};
  const Color other_material{0.75f, 0.25f, 0.5f, 1}, other_light{0.5f, 0.5f, 0.5f, 1};
  const auto draw = [&](RenderContext& context) {
    apply_state(context.gl, state, identity_matrix);
    draw_vertex(context, state.modelview, {});
    context.gl.PushAttrib(GL_LIGHTING_BIT);
    context.gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, other_light.data());
    context.gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, other_material.data());
    context.gl.PopAttrib();
    return draw_vertex(context, state.modelview, {});
  };
  expect_departure(draw, expected_color(state, {}), 40);
}

}  // namespace
}  // namespace oracle
