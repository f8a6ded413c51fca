// The lighting equation is written twice: as GLSL (shadergen/emit_lighting.cpp) and for the CPU
// (software/vertex_lighting.cpp). Both light the same vertices from the same key and uniform values
// here, term by term: what one of them does otherwise shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>

#include "api/whole_context.hpp"
#include "oracle/random.hpp"
#include "oracle/sampler.hpp"
#include "software/vertex_lighting.hpp"
#include "support/contexts.hpp"
#include "support/shared_context.hpp"

namespace legacy_gl::test {
namespace {

using oracle::Random;

constexpr int kSide = oracle::batch_side;

enum class Terms { kScene, kAmbient, kDiffuse, kSpecular, kAll };
enum class Lamp { kDirectional, kPoint, kAttenuated, kSpot, kSpotExponent, kMixed };

struct Case {
  const char* name;
  Lamp lamp;
  Terms terms;
  float tolerance;
  float normal_length = 1;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

/// Both are float32 and take the same steps; compilers order sums differently, and square roots,
/// exp2 and log2 are each one's own. Of sums and products of terms near 1 that is some units in the
/// last place (6e-8 each).
constexpr float kSums = 1e-6f;
/// A shininess of 128 multiplies what n.h is off by: ten such units, where normals are not of unit
/// length. It is a fiftieth of a step of 8 bits.
constexpr float kPowers = 128 * 10 * 6e-8f;

constexpr Case kCases[] = {
    {"Scene", Lamp::kDirectional, Terms::kScene, kSums},
    {"DirectionalDiffuse", Lamp::kDirectional, Terms::kDiffuse, kSums},
    {"DirectionalSpecular", Lamp::kDirectional, Terms::kSpecular, kPowers},
    {"PointDiffuse", Lamp::kPoint, Terms::kDiffuse, kSums},
    {"PointSpecular", Lamp::kPoint, Terms::kSpecular, kPowers},
    {"AttenuatedAmbient", Lamp::kAttenuated, Terms::kAmbient, kSums},
    {"AttenuatedDiffuse", Lamp::kAttenuated, Terms::kDiffuse, kSums},
    {"AttenuatedSpecular", Lamp::kAttenuated, Terms::kSpecular, kPowers},
    {"SpotAmbient", Lamp::kSpot, Terms::kAmbient, kSums},
    {"SpotDiffuse", Lamp::kSpot, Terms::kDiffuse, kSums},
    {"SpotSpecular", Lamp::kSpot, Terms::kSpecular, kPowers},
    {"SpotExponentAmbient", Lamp::kSpotExponent, Terms::kAmbient, kSums},
    {"SpotExponentDiffuse", Lamp::kSpotExponent, Terms::kDiffuse, kSums},
    {"SpotExponentSpecular", Lamp::kSpotExponent, Terms::kSpecular, kPowers},
    // The power of n.h may be 1e20 here, and the spot's as small.
    {"SpotExponentSpecularOfLongNormals", Lamp::kSpotExponent, Terms::kSpecular, kPowers, 1.5f},
    {"EightLights", Lamp::kMixed, Terms::kAll, kPowers},
};

oracle::Light lamp(Random& random, Lamp kind, Terms terms, float intensity) {
  oracle::Light light;
  const auto color = [&](Terms term) {
    return terms == term || terms == Terms::kAll ? random.color(intensity)
                                                 : oracle::Color{0, 0, 0, 1};
  };
  light.ambient = color(Terms::kAmbient);
  light.diffuse = color(Terms::kDiffuse);
  light.specular = color(Terms::kSpecular);
  if (kind == Lamp::kDirectional) {
    const auto d = random.unit_vector();
    light.position_specified = {d[0], d[1], d[2], 0};
    return light;
  }
  light.position_specified = {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-9, 2),
                              1};
  if (kind == Lamp::kPoint) return light;
  if (kind == Lamp::kAttenuated || random.coin()) {
    light.constant_attenuation = random.uniform(0.8f, 1);
    light.linear_attenuation = random.uniform(0.01f, 0.3f);
    light.quadratic_attenuation = random.uniform(0, 0.1f);
  }
  if (kind == Lamp::kAttenuated) return light;
  for (std::size_t c = 0; c < 3; ++c)  // aimed near the objects
    light.spot_direction_specified[c] =
        (c == 2 ? -5.0f : 0.0f) + random.uniform(-1, 1) - light.position_specified[c];
  light.spot_cutoff_degrees = random.uniform(20, 90);
  if (kind == Lamp::kSpotExponent)
    light.spot_exponent =
        random.coin() ? static_cast<float>(1 + random.below(128)) : random.uniform(0.5f, 128);
  return light;
}

/// What a modelview and the treatment of normals can be, each in its turn.
void place(oracle::State& state, Random& random, std::uint32_t number) {
  const std::array<float, 3> translation{random.uniform(-1, 1), random.uniform(-1, 1),
                                         random.uniform(-8, -3)};
  const oracle::Mat3 turn = random.rotation();
  const double one = static_cast<double>(random.uniform(1.5f, 3));
  const oracle::Mat3 stretch = oracle::times(turn, oracle::scale(one, 0.5 * one, 0.8));
  switch (number % 6) {
    case 0: state.modelview = oracle::loaded(turn, translation); break;
    case 1:
      state.modelview =
          oracle::loaded(oracle::times(turn, oracle::scale(one, one, one)), translation);
      break;
    case 2: state.modelview = oracle::loaded(stretch, translation); break;
    case 3:
      state.modelview = oracle::loaded(turn, translation);
      state.normalize = true;
      break;
    case 4:
      state.modelview = oracle::loaded(stretch, translation);
      state.normalize = true;
      break;
    default:
      state.modelview =
          oracle::loaded(oracle::times(turn, oracle::scale(one, one, one)), translation);
      state.rescale_normal = true;
  }
}

oracle::Material material(Random& random, std::uint32_t number) {
  oracle::Material m;
  m.ambient = random.color(0.5f);
  m.diffuse = random.color(0.9f, random.unit());
  m.specular = random.color(0.9f);
  m.emission = random.color(0.05f);
  constexpr float kWhole[] = {0, 1, 10, 50, 128};
  m.shininess = number % 2 ? kWhole[number / 2 % 5] : random.uniform(0.01f, 128);
  return m;
}

oracle::Batch make_batch(const Case& c, std::uint32_t number) {
  const auto seed = 8 * static_cast<std::uint32_t>(c.lamp) + static_cast<std::uint32_t>(c.terms);
  Random random(seed, number);
  oracle::Batch batch;
  oracle::State& state = batch.state;
  place(state, random, number);
  state.light_model.ambient = random.color(0.3f);
  state.light_model.local_viewer = number / 6 % 2;
  state.light_model.two_side = batch.alternate_faces = number / 12 % 2;
  state.front = material(random, number);
  state.back = material(random, number + 1);
  if (c.lamp == Lamp::kMixed)
    for (std::uint32_t i = 0; i < 8; ++i)
      state.lights.push_back(lamp(random, static_cast<Lamp>(i % 5), c.terms, 0.2f));
  else state.lights = {lamp(random, c.lamp, c.terms, 1)};
  batch.vertices.resize(oracle::batch_size);
  for (int i = 0; i < oracle::batch_size; ++i) {
    oracle::Vertex& v = batch.vertices[static_cast<std::size_t>(i)];
    const auto in_cell = [&](int cell) {
      return (static_cast<float>(cell) + random.uniform(0.2f, 0.45f)) * (2.0f / kSide) - 1;
    };
    const float x = in_cell(i % kSide), y = in_cell(i / kSide);
    v.position_object = {x, y, random.uniform(-1, 1), 1};
    v.normal_object = random.unit_vector();
    for (float& component : v.normal_object) component *= state.normalize ? 3 : c.normal_length;
  }
  return batch;
}

bool shows_its_back(const oracle::Batch& batch, std::uint32_t number, int i) {
  return batch.alternate_faces && (static_cast<std::uint32_t>(i) + number) % 2 != 0;
}

/// Without the paths that would light on the CPU.
CoreContext& driver_context() {
  static CoreContext& context =
      make_shared_context<CoreContext>(kSide, kSide, PixelFormat::rgba32f);
  context.handle()->paths.cpu_lighting = context.handle()->paths.cpu_transform = false;
  return context;
}

Image draw(CoreContext& context, const oracle::Batch& batch, std::uint32_t number) {
  const GlFunctions& gl = context.gl;
  context.make_current();
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Disable(GL_DITHER);
  gl.ShadeModel(GL_FLAT);
  oracle::apply_state(gl, batch.state,
                      oracle::placing_projection(batch.state.modelview, batch.object_radius));
  gl.Begin(oracle::drawn_mode(batch));
  for (const oracle::Vertex& vertex : oracle::drawn_vertices(batch, number)) {
    gl.Normal3fv(vertex.normal_object.data());
    gl.Vertex3fv(vertex.position_object.data());
  }
  gl.End();
  return context.read_float();
}

/// The vertices from `first` on, as the CPU lights them.
LightingBlock light(const DrawInputs& inputs, const oracle::Batch& batch, int first,
                    unsigned face) {
  LightingBlock block;
  for (unsigned i = 0; i < LightingBlock::kVertices; ++i) {
    const oracle::Vertex& vertex = batch.vertices[static_cast<unsigned>(first) + i];
    for (unsigned axis = 0; axis < 3; ++axis) {
      block.position[axis][i] = vertex.position_object[axis];
      block.normal[axis][i] = vertex.normal_object[axis];
    }
  }
  light_block(inputs, face, block);
  return block;
}

struct Difference {
  float largest = 0;
  int compared = 0;
};

/// Nearer to a jump of the equation than this (a difference of cosines), float32 may fall on
/// either side of it.
constexpr double kJump = 2e-6;

void compare(const DrawInputs& inputs, const oracle::Batch& batch, std::uint32_t number,
             const Image& picture, Difference& difference) {
  constexpr int kVertices = LightingBlock::kVertices;
  for (int first = 0; first < oracle::batch_size; first += kVertices) {
    const LightingBlock faces[] = {
        light(inputs, batch, first, kFront),
        batch.alternate_faces ? light(inputs, batch, first, kBack) : LightingBlock{}};
    for (int i = 0; i < kVertices; ++i) {
      const auto vertex = static_cast<std::size_t>(first + i);
      const oracle::Result expected = oracle::evaluate(batch.state, batch.vertices[vertex]);
      if (!expected.defined || expected.distance_to_jump < kJump) continue;
      ++difference.compared;
      const LightingBlock& lit = faces[shows_its_back(batch, number, first + i) ? kBack : kFront];
      for (std::size_t c = 0; c < 4; ++c) {
        const float apart = std::abs(lit.color[c][i] - picture.floats[4 * vertex + c]);
        // A NaN counts as the largest difference.
        difference.largest = std::max(difference.largest, apart == apart ? apart : 1.0f);
      }
    }
  }
}

class VertexLighting : public testing::TestWithParam<Case> {};

TEST_P(VertexLighting, IsThatOfTheShader) {
  constexpr std::uint32_t kBatches = 24;
  CoreContext& context = driver_context();
  Difference difference;
  std::set<std::pair<LightingSpace, NormalMode>> placements;
  for (std::uint32_t number = 0; number < kBatches; ++number) {
    const oracle::Batch batch = make_batch(GetParam(), number);
    const Image picture = draw(context, batch, number);
    const DrawInputs& inputs = context.handle()->submission->inputs;
    ASSERT_TRUE(lights_blocks(inputs.key)) << describe(inputs.key);
    placements.emplace(inputs.key.space, inputs.key.normal);
    compare(inputs, batch, number, picture, difference);
  }
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
  std::printf("%-22s largest difference %.1e of %d vertices, %zu spaces and normal modes\n",
              GetParam().name, static_cast<double>(difference.largest), difference.compared,
              placements.size());
  EXPECT_LE(difference.largest, GetParam().tolerance);
  EXPECT_GT(difference.compared, static_cast<int>(0.99 * kBatches * oracle::batch_size));
  const bool by_position = GetParam().lamp != Lamp::kDirectional;
  if (by_position) {
    EXPECT_GE(placements.size(), 5u);
  }
}

INSTANTIATE_TEST_SUITE_P(Terms, VertexLighting, testing::ValuesIn(kCases),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace legacy_gl::test
