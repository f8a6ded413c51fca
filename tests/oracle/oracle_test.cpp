// The oracle against pencil and paper: one row of the lighting equation at a time, with numbers
// whose products and roots are exact, so that the expected value can be read off the comment.
#include "oracle/oracle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace oracle {
namespace {

// A few roundings of double.
constexpr double tolerance = 1e-14;

Material black() {
  Material m;
  m.ambient = m.diffuse = m.specular = m.emission = {0, 0, 0, 1};
  return m;
}

Light black_light() {
  Light light;
  light.ambient = light.diffuse = light.specular = {0, 0, 0, 1};
  return light;
}

// One light of which every colour is black, a black material, no global ambient: each test switches
// on what it looks at.
State one_light() {
  State state;
  state.front = state.back = black();
  state.light_model.ambient = {0, 0, 0, 1};
  state.lights = {black_light()};
  return state;
}

double red(const State& state, const Vertex& vertex = {}) {
  return evaluate(state, vertex).front.primary[0];
}

// A light of diffuse 1 on a diffuse-1 material.
State diffuse_light(std::array<float, 4> position) {
  State state = one_light();
  state.front.diffuse = state.back.diffuse = {1, 1, 1, 1};
  state.lights[0].diffuse = {1, 1, 1, 1};
  state.lights[0].position_specified = position;
  return state;
}

State specular_light(std::array<float, 4> position, float shininess) {
  State state = one_light();
  state.front.specular = state.back.specular = {1, 1, 1, 1};
  state.front.shininess = state.back.shininess = shininess;
  state.lights[0].specular = {1, 1, 1, 1};
  state.lights[0].position_specified = position;
  return state;
}

State ambient_light(std::array<float, 4> position) {
  State state = one_light();
  state.front.ambient = {1, 1, 1, 1};
  state.lights[0].ambient = {1, 1, 1, 1};
  state.lights[0].position_specified = position;
  return state;
}

TEST(Terms, EmissionPlusMaterialTimesGlobalAmbient) {
  State state = one_light();
  state.front.emission = {0.25f, 0, 0.5f, 1};
  state.front.ambient = {0.5f, 0.25f, 0, 1};
  state.light_model.ambient = {0.5f, 0.5f, 1, 1};
  const auto colors = evaluate(state, {}).front;
  EXPECT_EQ(colors.primary[0], 0.5);    // .25 + .5 * .5
  EXPECT_EQ(colors.primary[1], 0.125);  // 0 + .25 * .5
  EXPECT_EQ(colors.primary[2], 0.5);    // .5 + 0 * 1
}

TEST(Terms, AlphaIsTheDiffuseAlphaOfTheMaterial) {
  State state = one_light();
  state.front.diffuse[3] = 0.375f;
  state.front.emission[3] = 0.5f;
  state.lights[0].diffuse[3] = 0.5f;
  EXPECT_EQ(evaluate(state, {}).front.primary[3], 0.375);
}

TEST(Terms, DiffuseOfADirectionalLight) {
  // (0,3,4) has length 5: n.L = 4/5; times 1/2 * 1/4.
  State state = one_light();
  state.front.diffuse[0] = 0.5f;
  state.lights[0].diffuse[0] = 0.25f;
  state.lights[0].position_specified = {0, 3, 4, 0};
  EXPECT_NEAR(red(state), 0.1, tolerance);
}

TEST(Terms, DiffuseIsZeroBehindTheSurface) { EXPECT_EQ(red(diffuse_light({0, 3, -4, 0})), 0); }

TEST(Terms, DirectionToAPositionalLight) {
  // From (1,2,-3) to (1,5,1): (0,3,4), n.L = 4/5.
  State state = diffuse_light({1, 5, 1, 1});
  Vertex vertex;
  vertex.position_object = {1, 2, -3, 1};
  EXPECT_NEAR(red(state, vertex), 0.8, tolerance);
}

TEST(Terms, HomogeneousPositionsAreDividedFirst) {
  // Light (2,10,2,2) is (1,5,1); vertex (-3,-6,9,-3) is (1,2,-3): as above.
  State state = diffuse_light({2, 10, 2, 2});
  Vertex vertex;
  vertex.position_object = {-3, -6, 9, -3};
  EXPECT_NEAR(red(state, vertex), 0.8, tolerance);
}

TEST(Terms, NegativeLightWMirrorsThePosition) {
  // Light (0,0,2,-1) is (0,0,-2): behind the surface at the origin that faces +z.
  EXPECT_EQ(red(diffuse_light({0, 0, 2, -1})), 0);
  EXPECT_NEAR(red(diffuse_light({0, 0, -2, -1})), 1, tolerance);
}

TEST(Terms, VertexAtInfinityLooksBackAlongItsDirection) {
  // Vertex (0,-3,-4,0), light at a finite place: L is the negative of (0,-3,-4)/5, n.L = 4/5.
  State state = diffuse_light({7, 8, 9, 1});
  Vertex vertex;
  vertex.position_object = {0, -3, -4, 0};
  EXPECT_NEAR(red(state, vertex), 0.8, tolerance);
}

TEST(Terms, SpecularWithAnInfiniteViewer) {
  // L = (0,.96,.28): L + (0,0,1) = (0,.96,1.28), length 1.6, so h = (0,.6,.8); .8^2 = .64.
  EXPECT_NEAR(red(specular_light({0, 24, 7, 0}, 2)), 0.64, tolerance);
}

TEST(Terms, SpecularWithALocalViewer) {
  // Vertex (0,-4,-3): V to E is (0,.8,.6). L = (0,-.8,.6). The sum is (0,0,1.2): h = n.
  State state = specular_light({0, -4, 3, 0}, 50);
  state.light_model.local_viewer = true;
  Vertex vertex;
  vertex.position_object = {0, -4, -3, 1};
  EXPECT_NEAR(red(state, vertex), 1, tolerance);
  state.light_model.local_viewer = false;  // h = unit (0,-.8,1.6): n.h = 2/sqrt 5
  EXPECT_NEAR(red(state, vertex), std::pow(0.8, 25), tolerance);
}

TEST(Terms, NoSpecularWhereTheLightIsBehind) {
  // n.L = -.28 while n.h = .6 > 0: f_i is 0. From just in front f_i is 1.
  EXPECT_EQ(red(specular_light({0, 24, -7, 0}, 1)), 0);
  EXPECT_GT(red(specular_light({0, 24, 1e-6f, 0}, 1)), 0.7);
}

TEST(Terms, SpecularFactorIsZeroWhereLightIsExactlyAtTheHorizon) {
  EXPECT_EQ(red(specular_light({0, 1, 0, 0}, 1)), 0);
}

TEST(Terms, ZeroToTheZeroIsOne) {
  // Shininess 0: the specular term is full wherever the light reaches, n.h = 0 included. With a
  // local viewer at (0,0,0), vertex (0,-4,3): V to E = (0,.8,-.6), L = (0,-.8,.6+e) nearly
  // opposite; a plainer case: n = (0,0,1), L = (0,.6,.8), E-direction (0,.6,-.8)... h = (0,1,0):
  // n.h = 0.
  State state = specular_light({0, 3, 4, 0}, 0);
  state.light_model.local_viewer = true;
  Vertex vertex;
  vertex.position_object = {0, -3, 4, 1};
  EXPECT_EQ(red(state, vertex), 1);
  state.front.shininess = 1;
  EXPECT_NEAR(red(state, vertex), 0, tolerance);
}

TEST(Attenuation, ConstantLinearQuadratic) {
  // d = 5: 1 / (1 + .5 * 5 + .25 * 25) = 1 / 9.75; n.L = .8.
  State state = diffuse_light({0, 3, 4, 1});
  state.lights[0].linear_attenuation = 0.5f;
  state.lights[0].quadratic_attenuation = 0.25f;
  EXPECT_NEAR(red(state), 0.8 / 9.75, tolerance);
}

TEST(Attenuation, DirectionalLightHasNone) {
  State state = diffuse_light({0, 3, 4, 0});
  state.lights[0].constant_attenuation = 100;
  state.lights[0].linear_attenuation = 100;
  EXPECT_NEAR(red(state), 0.8, tolerance);
}

TEST(Attenuation, TakesTheLightsOwnAmbientToo) {
  State state = ambient_light({0, 0, 2, 1});
  state.lights[0].constant_attenuation = 0;
  state.lights[0].quadratic_attenuation = 1;
  EXPECT_EQ(red(state), 0.25);
}

TEST(Attenuation, DenominatorZeroIsTheLargestFloat) {
  State state = ambient_light({0, 0, 2, 1});
  state.lights[0].constant_attenuation = 0;
  const auto result = evaluate(state, {});
  EXPECT_FALSE(result.defined);
  EXPECT_EQ(result.front.primary[0], double(std::numeric_limits<float>::max()));
  EXPECT_EQ(result.front.primary_clamped[0], 1);
}

TEST(Attenuation, VertexAtInfinityGetsNothing) {
  State state = ambient_light({0, 0, 2, 1});
  state.lights[0].linear_attenuation = 1;
  Vertex vertex;
  vertex.position_object = {0, 0, -1, 0};
  EXPECT_EQ(red(state, vertex), 0);
  state.lights[0].linear_attenuation = 0;
  EXPECT_EQ(red(state, vertex), 1);
}

// A spot light at (0,3,4) of which the axis passes the origin at the angle with cosine .8.
State spot_light(float cutoff_degrees, float exponent) {
  State state = ambient_light({0, 3, 4, 1});
  state.lights[0].spot_direction_specified = {0, 0, -1};
  state.lights[0].spot_cutoff_degrees = cutoff_degrees;
  state.lights[0].spot_exponent = exponent;
  return state;
}

TEST(Spot, PowerOfTheCosineInsideTheCone) {
  EXPECT_NEAR(red(spot_light(60, 2)), 0.64, tolerance);
  EXPECT_EQ(red(spot_light(60, 0)), 1);
}

TEST(Spot, NothingOutsideTheCone) { EXPECT_EQ(red(spot_light(30, 2)), 0); }

TEST(Spot, OffAt180Degrees) { EXPECT_EQ(red(spot_light(180, 2)), 1); }

TEST(Spot, ExactlyOnTheConeIsLit) {
  // The direction to the vertex makes 45 degrees with the axis.
  State state = ambient_light({0, 1, 1, 1});
  state.lights[0].spot_cutoff_degrees = 45;
  EXPECT_EQ(red(state), 1);
  state.lights[0].spot_cutoff_degrees = 44.9999f;
  EXPECT_EQ(red(state), 0);
}

TEST(Spot, CutoffZeroLightsItsAxis) {
  State state = ambient_light({0, 0, 1, 1});
  state.lights[0].spot_cutoff_degrees = 0;
  EXPECT_EQ(red(state), 1);
  Vertex aside;
  aside.position_object = {1e-5f, 0, 0, 1};
  EXPECT_EQ(red(state, aside), 0);
}

TEST(Spot, CutoffNinetyIsTheHalfSpaceBefore) {
  State state = ambient_light({0, 0, 1, 1});
  state.lights[0].spot_cutoff_degrees = 90;
  Vertex beside, behind;
  beside.position_object = {5, 0, 1, 1};
  behind.position_object = {5, 0, 1.001f, 1};
  EXPECT_EQ(red(state, beside), 1);  // 0 >= cos 90, and 0^0 = 1
  EXPECT_EQ(red(state, behind), 0);
}

TEST(Spot, AnyLengthOfDirection) {
  State state = spot_light(60, 2);
  for (const float length : {1e-44f, 1e-20f, 17.f, 3e38f}) {
    state.lights[0].spot_direction_specified = {0, 0, -length};
    EXPECT_NEAR(red(state), 0.64, tolerance) << length;
  }
}

TEST(Space, LightUsesTheModelviewOfItsOwnMoment) {
  // Specified under translate(0,0,2) * scale(2): (0,0,1) becomes (0,0,4), whatever comes later.
  State state = ambient_light({0, 0, 1, 1});
  state.lights[0].position_modelview = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 2, 1};
  state.lights[0].constant_attenuation = 0;
  state.lights[0].linear_attenuation = 1;
  EXPECT_EQ(red(state), 0.25);
  state.modelview = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 3, 1};  // the vertex at (0,0,3)
  EXPECT_EQ(red(state), 1);
}

TEST(Space, SpotDirectionUsesTheUpperThreeByThree) {
  // A quarter turn about y takes (-1,0,0) to (0,0,1)... and (1,0,0) to (0,0,-1); translation is not
  // applied to it.
  State state = spot_light(60, 2);
  state.lights[0].spot_direction_specified = {1, 0, 0};
  state.lights[0].spot_direction_modelview = {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 9, 9, 9, 1};
  EXPECT_NEAR(red(state), 0.64, tolerance);
}

TEST(Normals, InverseTransposeUnderNonUniformScale) {
  // scale(1,1,4): the inverse transpose takes (0,0,1) to (0,0,1/4).
  State state = diffuse_light({0, 0, 1, 0});
  state.modelview = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 4, 0, 0, 0, 0, 1};
  EXPECT_EQ(red(state), 0.25);
  state.normalize = true;
  EXPECT_EQ(red(state), 1);
}

TEST(Normals, NormalizeAfterShear) {
  // x += z: inverse transpose takes (1,0,0) to (1,0,-1). Light from +x: n.L = 1/sqrt 2.
  State state = diffuse_light({1, 0, 0, 0});
  state.modelview = {1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1};
  state.normalize = true;
  Vertex vertex;
  vertex.normal_object = {1, 0, 0};
  EXPECT_NEAR(red(state, vertex), std::sqrt(0.5), tolerance);
}

TEST(Normals, MirroringKeepsTheirSide) {
  // scale(1,1,-1): the inverse transpose takes (0,0,1) to (0,0,-1).
  State state = diffuse_light({0, 0, -1, 0});
  state.modelview = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1};
  EXPECT_EQ(red(state), 1);
  state.rescale_normal = true;
  EXPECT_EQ(red(state), 1);
}

TEST(Normals, RescaleFactorOfAUniformScale) {
  // scale(4): (0,0,1) becomes (0,0,1/4); f = 4.
  State state = diffuse_light({0, 0, 1, 0});
  state.modelview = {4, 0, 0, 0, 0, 4, 0, 0, 0, 0, 4, 0, 0, 0, 0, 1};
  EXPECT_EQ(red(state), 0.25);
  state.rescale_normal = true;
  EXPECT_EQ(red(state), 1);
}

TEST(Normals, RescaleFactorIsTheThirdRowOfTheInverse) {
  // scale(2,1,4): f = 4 (from z), so a normal along x of length 1 becomes 1/2 * 4 = 2: it is not
  // the same thing as GL_NORMALIZE.
  State state = diffuse_light({1, 0, 0, 0});
  state.modelview = {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 4, 0, 0, 0, 0, 1};
  state.rescale_normal = true;
  Vertex vertex;
  vertex.normal_object = {1, 0, 0};
  EXPECT_EQ(red(state, vertex), 2);
  state.normalize = true;
  EXPECT_EQ(red(state, vertex), 1);
}

TEST(Normals, LengthCountsWithoutNormalize) {
  State state = diffuse_light({0, 0, 1, 0});
  Vertex vertex;
  vertex.normal_object = {0, 0, 0.5f};
  EXPECT_EQ(red(state, vertex), 0.5);
}

TEST(Colors, ClampedAfterTheSum) {
  State state = one_light();
  state.front.emission = {2, -1, 0.5f, 1};
  const auto colors = evaluate(state, {}).front;
  EXPECT_EQ(colors.primary[0], 2);
  EXPECT_EQ(colors.primary[1], -1);
  EXPECT_EQ(colors.primary_clamped[0], 1);
  EXPECT_EQ(colors.primary_clamped[1], 0);
  EXPECT_EQ(colors.primary_clamped[2], 0.5);
}

TEST(Colors, SeparateSpecularGoesToTheSecondaryColor) {
  State state = specular_light({0, 24, 7, 0}, 2);
  state.front.emission = {0.125f, 0, 0, 1};
  state.light_model.separate_specular_color = true;
  const auto colors = evaluate(state, {}).front;
  EXPECT_EQ(colors.primary[0], 0.125);
  EXPECT_NEAR(colors.secondary[0], 0.64, tolerance);
  EXPECT_EQ(colors.secondary[3], 0);
}

TEST(Colors, LightsAreSummed) {
  State state = diffuse_light({0, 3, 4, 0});
  state.lights.push_back(state.lights[0]);
  state.lights[1].position_specified = {0, 4, 3, 0};
  EXPECT_NEAR(red(state), 1.4, tolerance);
}

TEST(TwoSided, BackIsLitWithTheNegativeNormalAndItsOwnMaterial) {
  State state = diffuse_light({0, 3, -4, 0});
  state.light_model.two_side = true;
  state.back.diffuse = {0.5f, 0.5f, 0.5f, 0.25f};
  const auto result = evaluate(state, {});
  EXPECT_EQ(result.front.primary[0], 0);
  EXPECT_NEAR(result.back.primary[0], 0.4, tolerance);
  EXPECT_EQ(result.back.primary[3], 0.25);
}

TEST(TwoSided, OffMeansTheFrontColorOnBothFaces) {
  State state = diffuse_light({0, 3, 4, 0});
  state.back = black();
  EXPECT_EQ(evaluate(state, {}).back.primary, evaluate(state, {}).front.primary);
}

TEST(Tracking, EachModeAndFace) {
  using Mode = ColorMaterial::Mode;
  using Face = ColorMaterial::Face;
  State state = one_light();
  state.light_model.two_side = true;
  state.light_model.ambient = {0.5f, 0, 0, 1};
  Vertex vertex;
  vertex.color = {0.5f, 0, 0, 0.25f};
  state.color_material = {true, Face::front, Mode::ambient};
  EXPECT_EQ(evaluate(state, vertex).front.primary[0], 0.25);
  EXPECT_EQ(evaluate(state, vertex).back.primary[0], 0);
  state.color_material = {true, Face::back, Mode::emission};
  EXPECT_EQ(evaluate(state, vertex).front.primary[0], 0);
  EXPECT_EQ(evaluate(state, vertex).back.primary[0], 0.5);
  state.color_material = {true, Face::front_and_back, Mode::diffuse};
  EXPECT_EQ(evaluate(state, vertex).front.primary[3], 0.25);
  EXPECT_EQ(evaluate(state, vertex).back.primary[3], 0.25);
  state.color_material = {true, Face::front_and_back, Mode::ambient_and_diffuse};
  EXPECT_EQ(evaluate(state, vertex).front.primary[0], 0.25);
  EXPECT_EQ(evaluate(state, vertex).front.primary[3], 0.25);
  state.color_material.enabled = false;
  EXPECT_EQ(evaluate(state, vertex).front.primary[0], 0);
}

TEST(Tracking, Specular) {
  State state = specular_light({0, 24, 7, 0}, 2);
  state.color_material = {true, ColorMaterial::Face::front, ColorMaterial::Mode::specular};
  Vertex vertex;
  vertex.color = {0.5f, 0, 0, 1};
  EXPECT_NEAR(red(state, vertex), 0.32, tolerance);
}

// ---- where the law is silent: finite, the lost term counts as zero ------------------------------

void expect_undefined_and(double expected, const State& state, const Vertex& vertex = {}) {
  const auto result = evaluate(state, vertex);
  EXPECT_FALSE(result.defined);
  EXPECT_EQ(result.front.primary[0], expected);
}

TEST(Silent, ZeroNormalUnderNormalize) {
  State state = diffuse_light({0, 0, 1, 0});
  state.front.emission[0] = 0.25f;
  state.normalize = true;
  Vertex vertex;
  vertex.normal_object = {0, 0, 0};
  expect_undefined_and(0.25, state, vertex);
}

TEST(Silent, SingularModelview) {
  State state = diffuse_light({0, 0, 1, 0});
  state.front.emission[0] = 0.25f;
  state.modelview = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 0, 0, 0, 1};
  expect_undefined_and(0.25, state);
  state.normalize = state.rescale_normal = true;
  expect_undefined_and(0.25, state);
}

TEST(Silent, LightAtTheVertexKeepsItsAmbient) {
  State state = diffuse_light({0, 0, 0, 1});
  state.front.ambient[0] = state.lights[0].ambient[0] = 0.5f;
  state.lights[0].linear_attenuation = 1;
  expect_undefined_and(0.25, state);
}

TEST(Silent, EyeAtTheVertexWithALocalViewer) {
  State state = specular_light({0, 3, 4, 0}, 2);
  state.light_model.local_viewer = true;
  const auto result = evaluate(state, {});
  EXPECT_FALSE(result.defined);
  EXPECT_NEAR(result.front.primary[0], 0.64, tolerance);  // h = L: .8^2
}

TEST(Silent, HalfVectorZero) {
  Vertex vertex;
  vertex.normal_object = {0, 0, -1};
  expect_undefined_and(0, specular_light({0, 0, -1, 0}, 1), vertex);
}

TEST(Silent, NotANumberClampsToZero) {
  State state = one_light();
  state.front.emission[0] = std::numeric_limits<float>::quiet_NaN();
  const auto result = evaluate(state, {});
  EXPECT_FALSE(result.defined);
  EXPECT_EQ(result.front.primary_clamped[0], 0);
}

TEST(Jumps, DistanceToTheConeAndToTheHorizon) {
  EXPECT_NEAR(evaluate(spot_light(60, 0), {}).distance_to_jump, 0.3, tolerance);
  EXPECT_NEAR(evaluate(specular_light({0, 24, 7, 0}, 2), {}).distance_to_jump, 0.28, tolerance);
  EXPECT_EQ(evaluate(diffuse_light({0, 1, 0, 0}), {}).distance_to_jump, 1);
}

}  // namespace
}  // namespace oracle
