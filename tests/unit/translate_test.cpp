// From state to program key and uniform values, without a driver.
#include <array>
#include <random>

#include "recording_context.hpp"
#include "translate/draw_inputs.hpp"

namespace legacy_gl::test {
namespace {

using Values = std::array<float, 4>;
using Kinds = std::vector<std::pair<unsigned, unsigned>>;  // kind and count of each run

constexpr unsigned kTerms = kLightDiffuse | kLightSpecular;

class TranslateTest : public RecordingTest {
 protected:
  explicit TranslateTest(const legacy_gl_options& options = {}) : RecordingTest(options) {
    lglEnable(GL_LIGHTING);
    lglEnable(GL_LIGHT0);
    material(GL_SPECULAR, {1, 1, 1, 1});
  }

  const ProgramKey& update(const DrawFacts& facts = {}) {
    inputs.stale.fill(false);
    inputs.update(context, Recorder::relevant_layout(context), facts);
    return inputs.key;
  }
  std::vector<unsigned> stale_blocks() const {
    std::vector<unsigned> blocks;
    for (unsigned block = 0; block < kUniformBlockCount; ++block)
      if (inputs.stale[block]) blocks.push_back(block);
    return blocks;
  }
  Kinds runs() {
    Kinds found;
    for (const LightRun& run : update().lights)
      if (run.count) found.emplace_back(run.kind, run.count);
    return found;
  }
  static void material(GLenum pname, Values values) {
    lglMaterialfv(GL_FRONT_AND_BACK, pname, values.data());
  }
  /// A white light without an ambient term.
  static void light(unsigned index, Values position) {
    constexpr Values kWhite{1, 1, 1, 1};
    lglLightfv(GL_LIGHT0 + index, GL_POSITION, position.data());
    lglLightfv(GL_LIGHT0 + index, GL_DIFFUSE, kWhite.data());
    lglLightfv(GL_LIGHT0 + index, GL_SPECULAR, kWhite.data());
    lglEnable(GL_LIGHT0 + index);
  }

  DrawInputs inputs;
};

void set_some_lighting(std::mt19937& random) {
  const auto coin = [&] { return (random() & 1) != 0; };
  const auto set = [&](GLenum capability) {
    if (coin()) lglEnable(capability);
    else lglDisable(capability);
  };
  for (GLenum i = 0; i < 8; ++i) {
    set(GL_LIGHT0 + i);
    const Values position{1, 2, 3, coin() ? 1.0f : 0.0f};
    lglLightfv(GL_LIGHT0 + i, GL_POSITION, position.data());
    lglLightf(GL_LIGHT0 + i, GL_SPOT_CUTOFF, coin() ? 30 : 180);
    lglLightf(GL_LIGHT0 + i, GL_LINEAR_ATTENUATION, coin() ? 1 : 0);
  }
  lglLightModeli(GL_LIGHT_MODEL_TWO_SIDE, coin());
  lglLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, coin());
  lglLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                 coin() ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  lglMaterialf(GL_FRONT, GL_SHININESS, static_cast<float>(random() % 256) * 0.5f);
  set(GL_COLOR_MATERIAL);
  set(GL_NORMALIZE);
  set(GL_RESCALE_NORMAL);
  lglLoadIdentity();
  if (coin()) lglScalef(1, 2, 3);
}

TEST_F(TranslateTest, WithoutLightingNoLightingFieldIsSet) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    set_some_lighting(random);
    if (i % 2) {  // a key that was lit before
      lglEnable(GL_LIGHTING);
      update();
    }
    lglDisable(GL_LIGHTING);
    ASSERT_EQ(update(), ProgramKey{}) << describe(inputs.key);
  }
}

TEST_F(TranslateTest, AnUnusedLightChangesNoKey) {
  const ProgramKey before = update();
  light(1, {1, 2, 3, 1});
  lglDisable(GL_LIGHT0 + 1);
  EXPECT_EQ(update(), before);
  lglEnable(GL_LIGHT0 + 2);  // black
  EXPECT_EQ(update(), before);
  lglLightf(GL_LIGHT0 + 2, GL_SPOT_CUTOFF, 20);
  EXPECT_EQ(update(), before);
  EXPECT_GT(context.statistics.lights_skipped, 0u);
  light(1, {1, 2, 3, 1});
  EXPECT_NE(update(), before);
  lglDisable(GL_LIGHT0 + 1);
  EXPECT_EQ(update(), before);
}

TEST_F(TranslateTest, WhatAddsNothingChangesNoKey) {
  material(GL_SPECULAR, {0, 0, 0, 1});
  const ProgramKey before = update();
  lglLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  lglLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  material(GL_SHININESS, {20});
  EXPECT_EQ(update(), before);
  lglLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  EXPECT_TRUE(update().two_side);
  lglEnable(GL_CULL_FACE);  // no back face is seen
  EXPECT_EQ(update(), before);
}

struct Placement {
  const char* name;
  void (*set)();
  LightingSpace space;
  NormalMode normal;
  bool unit_normals = false;
  float light_w = 1;
};
void PrintTo(const Placement& placement, std::ostream* out) { *out << placement.name; }
class PlacementTest : public TranslateTest, public testing::WithParamInterface<Placement> {};

TEST_P(PlacementTest, SpaceAndNormals) {
  light(0, {1, 2, 3, GetParam().light_w});
  GetParam().set();
  DrawFacts facts;
  facts.unit_normals = GetParam().unit_normals;
  const ProgramKey& key = update(facts);
  EXPECT_EQ(static_cast<int>(key.space), static_cast<int>(GetParam().space));
  EXPECT_EQ(static_cast<int>(key.normal), static_cast<int>(GetParam().normal));
}

void turn() {
  lglTranslatef(1, 2, 3);
  lglRotatef(30, 1, 2, 3);
}
constexpr float kPerspective[] = {1, 0, 0, 0.5f, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

const Placement kPlacements[] = {
    {"Identity", [] {}, LightingSpace::kObject, NormalMode::kAsIs},
    {"Rotation", turn, LightingSpace::kObject, NormalMode::kAsIs},
    {"Reflection", [] { lglScalef(-1, 1, 1); }, LightingSpace::kObject, NormalMode::kAsIs},
    // Near 1 the products take the scale.
    {"NearlyOne", [] { lglScalef(1.1f, 1.1f, 1.1f); }, LightingSpace::kObject, NormalMode::kAsIs},
    {"Scale", [] { lglScalef(2, 2, 2); }, LightingSpace::kObject, NormalMode::kScaled},
    {"RescaledScale", [] { lglScalef(2, 2, 2), lglEnable(GL_RESCALE_NORMAL); },
     LightingSpace::kObject, NormalMode::kAsIs},
    {"ThreeScales", [] { lglScalef(1, 2, 3); }, LightingSpace::kEyeAxes, NormalMode::kMatrix},
    {"Normalize", [] { turn(), lglEnable(GL_NORMALIZE); }, LightingSpace::kObject,
     NormalMode::kNormalize},
    {"NormalizeThreeScales", [] { lglScalef(1, 2, 3), lglEnable(GL_NORMALIZE); },
     LightingSpace::kEyeAxes, NormalMode::kNormalize},
    {"NormalizeUnitNormals", [] { lglScalef(2, 2, 2), lglEnable(GL_NORMALIZE); },
     LightingSpace::kObject, NormalMode::kAsIs, true},
    {"Perspective", [] { lglMultMatrixf(kPerspective); }, LightingSpace::kEyeHomogeneous,
     NormalMode::kMatrix},
    // Directions alone meet normals as they are given, under any modelview.
    {"DirectionThreeScales", [] { lglScalef(1, 2, 3); }, LightingSpace::kObject, NormalMode::kAsIs,
     false, 0},
    {"DirectionPerspective", [] { lglMultMatrixf(kPerspective); }, LightingSpace::kObject,
     NormalMode::kAsIs, false, 0},
    {"DirectionLocalViewer",
     [] { lglScalef(1, 2, 3), lglLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); },
     LightingSpace::kEyeAxes, NormalMode::kMatrix, false, 0},
};
INSTANTIATE_TEST_SUITE_P(Modelviews, PlacementTest, testing::ValuesIn(kPlacements),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST_F(TranslateTest, AVertexWIsLitInHomogeneousCoordinates) {
  light(0, {1, 2, 3, 1});
  VertexLayout layout = Recorder::relevant_layout(context);
  layout.fields |= kFieldPositionW;
  inputs.update(context, layout);
  EXPECT_TRUE(inputs.key.position4);
  EXPECT_FALSE(inputs.key.w_is_one);
  EXPECT_EQ(static_cast<int>(inputs.key.space), static_cast<int>(LightingSpace::kEyeHomogeneous));
}

TEST_F(TranslateTest, BlocksAreStaleWhereValuesChanged) {
  using Blocks = std::vector<unsigned>;
  update();
  update();
  EXPECT_EQ(stale_blocks(), Blocks{});
  lglColor3f(1, 0, 0);
  lglDepthFunc(GL_ALWAYS);
  update();
  EXPECT_EQ(stale_blocks(), Blocks{});
  material(GL_DIFFUSE, {0.5f, 0.5f, 0.5f, 1});
  update();
  EXPECT_EQ(stale_blocks(), Blocks{kFrontBlock});
  lglFogf(GL_FOG_DENSITY, 0.5f);  // of no fog
  update();
  EXPECT_EQ(stale_blocks(), Blocks{});
  lglEnable(GL_FOG);
  update();
  lglFogf(GL_FOG_DENSITY, 0.25f);
  update();
  EXPECT_EQ(stale_blocks(), Blocks{kFragmentsBlock});

  lglLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  update();
  EXPECT_TRUE(inputs.stale[kFrontBlock] && inputs.stale[kBackBlock]);
  material(GL_EMISSION, {0.1f, 0, 0, 1});
  update();
  EXPECT_EQ(stale_blocks(), (Blocks{kFrontBlock, kBackBlock}));

  lglTranslatef(1, 0, 0);
  update();
  EXPECT_TRUE(inputs.stale[kTransformBlock]);
  EXPECT_FALSE(inputs.stale[kFrontBlock] || inputs.stale[kBackBlock]);
  light(0, {1, 0, 0, 0});
  update();
  EXPECT_TRUE(inputs.stale[kLightsBlock]);
  EXPECT_FALSE(inputs.stale[kTransformBlock]);

  lglDisable(GL_LIGHTING);
  update();
  light(0, {0, 1, 0, 0});
  material(GL_DIFFUSE, {1, 0, 0, 1});
  update();
  EXPECT_EQ(stale_blocks(), Blocks{});
}

TEST_F(TranslateTest, EqualKindsAreOneRun) {
  EXPECT_EQ(runs(), (Kinds{{kTerms, 1}}));
  light(1, {1, 2, 3, 1});
  light(2, {0, 1, 0, 0});
  light(3, {1, 2, 3, 1});
  lglLightf(GL_LIGHT0 + 3, GL_QUADRATIC_ATTENUATION, 1);
  light(4, {1, 2, 3, 1});
  lglLightf(GL_LIGHT0 + 4, GL_SPOT_CUTOFF, 30);
  light(5, {3, 2, 1, 1});
  lglLightf(GL_LIGHT0 + 5, GL_CONSTANT_ATTENUATION, 2);  // the products take it
  light(6, {1, 2, 3, 1});
  lglLightf(GL_LIGHT0 + 6, GL_SPOT_CUTOFF, 30);
  lglLightf(GL_LIGHT0 + 6, GL_SPOT_EXPONENT, 2);
  // Directions, then points, then spots, in whichever order GL numbers them.
  EXPECT_EQ(runs(), (Kinds{{kTerms, 2},
                           {kLightPoint | kLightAttenuated | kTerms, 1},
                           {kLightPoint | kTerms, 2},
                           {kLightPoint | kLightSpot | kLightSpotExponent | kTerms, 1},
                           {kLightPoint | kLightSpot | kTerms, 1}}));
  EXPECT_EQ(inputs.lights.size(), 7u);
  EXPECT_EQ(inputs.faces[kFront].products.size(), 7u);
}

TEST_F(TranslateTest, AmbientIsPartOfTheSceneUnlessItIsAttenuated) {
  constexpr Values kDim{0.5f, 0.5f, 0.5f, 1};
  lglLightfv(GL_LIGHT0, GL_AMBIENT, kDim.data());
  EXPECT_EQ(runs(), (Kinds{{kTerms, 1}}));
  EXPECT_FLOAT_EQ(inputs.faces[kFront].head.scene.r, (0.2f + 0.5f) * 0.2f);
  light(0, {0, 0, 1, 1});
  lglLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 1);
  EXPECT_EQ(runs(), (Kinds{{kLightPoint | kLightAttenuated | kLightAmbient | kTerms, 1}}));
  EXPECT_FLOAT_EQ(inputs.faces[kFront].head.scene.r, 0.2f * 0.2f);
}

legacy_gl_options many_lights() {
  legacy_gl_options options{};
  options.max_lights = 16;
  return options;
}
class ManyKindsTest : public TranslateTest {
 protected:
  ManyKindsTest() : TranslateTest(many_lights()) {}
};

// More kinds than a key holds become the widest of each class.
TEST_F(ManyKindsTest, BecomeThree) {
  constexpr Values kBlack{0, 0, 0, 1};
  for (unsigned i = 0; i < 12; ++i) {
    light(i, {1, 2, 3, i < 2 ? 0.0f : 1.0f});
    if (i % 2) lglLightfv(GL_LIGHT0 + i, GL_SPECULAR, kBlack.data());
    if (i / 2 % 2) lglLightf(GL_LIGHT0 + i, GL_LINEAR_ATTENUATION, 1);
    if (i >= 6) lglLightf(GL_LIGHT0 + i, GL_SPOT_CUTOFF, 30);
    if (i >= 10) lglLightf(GL_LIGHT0 + i, GL_SPOT_EXPONENT, 3);
  }
  const Kinds found = runs();
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0], (std::pair{kTerms, 2u}));
  EXPECT_EQ(found[1].second, 4u);
  EXPECT_EQ(found[2].second, 6u);
  EXPECT_TRUE(found[2].first & kLightSpotExponent);
}

TEST_F(TranslateTest, MaterialsOfVertices) {
  VertexLayout layout = Recorder::relevant_layout(context);
  layout.materials = material_bit(kFront, kDiffuse) | material_bit(kFront, kShininess);
  inputs.update(context, layout);
  EXPECT_EQ(inputs.key.vertex_materials, layout.materials);
  EXPECT_EQ(static_cast<int>(inputs.key.material[kFront][kDiffuse]),
            static_cast<int>(MaterialSource::kVertex));
  EXPECT_EQ(inputs.key.integer_shininess[kFront], kGeneralShininess);
  // The light's own colour is left.
  EXPECT_EQ(inputs.faces[kFront].products.at(0).diffuse.r, 1);
  lglEnable(GL_COLOR_MATERIAL);
  EXPECT_EQ(static_cast<int>(update().material[kFront][kDiffuse]),
            static_cast<int>(MaterialSource::kColor));
  EXPECT_EQ(inputs.key.vertex_materials, 0);
}

}  // namespace
}  // namespace legacy_gl::test
