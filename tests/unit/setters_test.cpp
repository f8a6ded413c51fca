// The order of every setter, without a driver: it validates, then draws what was recorded under the
// old value, stores and raises its dirty bits.
#include <array>

#include "recording_context.hpp"

namespace legacy_gl::test {
namespace {

using Values = std::array<float, 4>;

void light(GLenum name, GLenum pname, Values values) { lglLightfv(name, pname, values.data()); }
void material(GLenum face, GLenum pname, Values values) {
  lglMaterialfv(face, pname, values.data());
}
void light_model(GLenum pname, Values values) { lglLightModelfv(pname, values.data()); }

bool equal(const LightingState& a, const LightingState& b) {
  return a.enabled == b.enabled && a.lights == b.lights && a.model == b.model &&
         a.materials == b.materials && a.color_material == b.color_material &&
         a.shade_model == b.shade_model;
}

/// One call under a lit state with light 0 on, which has been drawn once.
struct Call {
  const char* name;
  void (*make)();
  GLenum error;
  std::uint32_t dirty;  ///< the bits that it raises
};
void PrintTo(const Call& call, std::ostream* out) { *out << call.name; }
std::string name_of(const testing::TestParamInfo<Call>& instance) { return instance.param.name; }

class LitTest : public RecordingTest {
 protected:
  LitTest() {
    lglEnable(GL_LIGHTING);
    lglEnable(GL_LIGHT0);
    primitive(GL_TRIANGLES, 3);
    flush_pending(context);
    renderer.batches.clear();
    primitive(GL_TRIANGLES, 300);  // no small object, which waits for others
  }
};

class CallTest : public LitTest, public testing::WithParamInterface<Call> {};

class RefusedTest : public CallTest {};
TEST_P(RefusedTest, LeavesTheValueAndTheBatch) {
  const LightingState lighting = context.lighting;
  GetParam().make();
  EXPECT_EQ(take_error(), GetParam().error);
  EXPECT_TRUE(equal(context.lighting, lighting));
  EXPECT_EQ(context.dirty, 0u);
  EXPECT_TRUE(renderer.batches.empty());
}

constexpr Call kRefused[] = {
    {"Light", [] { light(GL_LIGHT0 + 8, GL_DIFFUSE, {}); }, GL_INVALID_ENUM, 0},
    {"LightParameter", [] { light(GL_LIGHT0, GL_SHININESS, {}); }, GL_INVALID_ENUM, 0},
    {"SpotExponent", [] { light(GL_LIGHT0, GL_SPOT_EXPONENT, {129}); }, GL_INVALID_VALUE, 0},
    {"SpotCutoff", [] { light(GL_LIGHT0, GL_SPOT_CUTOFF, {91}); }, GL_INVALID_VALUE, 0},
    {"Attenuation", [] { light(GL_LIGHT0, GL_LINEAR_ATTENUATION, {-1}); }, GL_INVALID_VALUE, 0},
    {"MaterialFace", [] { material(GL_LEFT, GL_DIFFUSE, {}); }, GL_INVALID_ENUM, 0},
    {"MaterialParameter", [] { material(GL_FRONT, GL_POSITION, {}); }, GL_INVALID_ENUM, 0},
    {"Shininess", [] { material(GL_FRONT, GL_SHININESS, {128.5f}); }, GL_INVALID_VALUE, 0},
    {"LightModel", [] { light_model(GL_DIFFUSE, {}); }, GL_INVALID_ENUM, 0},
    {"ColorControl", [] { lglLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, 7); }, GL_INVALID_ENUM, 0},
    {"ColorMaterialFace", [] { lglColorMaterial(GL_LEFT, GL_DIFFUSE); }, GL_INVALID_ENUM, 0},
    {"ColorMaterialMode", [] { lglColorMaterial(GL_FRONT, GL_SHININESS); }, GL_INVALID_ENUM, 0},
    {"ShadeModel", [] { lglShadeModel(GL_LINES); }, GL_INVALID_ENUM, 0},
    {"DepthFunc", [] { lglDepthFunc(GL_LINES); }, GL_INVALID_ENUM, 0},
    {"CullFace", [] { lglCullFace(GL_LEFT); }, GL_INVALID_ENUM, 0},
    {"LineWidth", [] { lglLineWidth(0); }, GL_INVALID_VALUE, 0},
    {"FogDensity", [] { lglFogf(GL_FOG_DENSITY, -1); }, GL_INVALID_VALUE, 0},
    {"End", [] { lglEnd(); }, GL_INVALID_OPERATION, 0},
    {"Begin", [] { lglBegin(GL_POLYGON + 1); }, GL_INVALID_ENUM, 0},
};
INSTANTIATE_TEST_SUITE_P(Calls, RefusedTest, testing::ValuesIn(kRefused), name_of);

class UnchangedTest : public CallTest {};
TEST_P(UnchangedTest, RaisesNoBitAndEndsNoBatch) {
  const LightingState lighting = context.lighting;
  GetParam().make();
  EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
  EXPECT_EQ(context.dirty, 0u);
  EXPECT_TRUE(renderer.batches.empty());
  EXPECT_TRUE(equal(context.lighting, lighting));
}

constexpr Call kUnchanged[] = {
    {"LightDiffuse",
     [] {
       light(GL_LIGHT0, GL_DIFFUSE, {1, 1, 1, 1});
     },
     0, 0},
    {"LightPosition",
     [] {
       light(GL_LIGHT0, GL_POSITION, {0, 0, 1, 0});
     },
     0, 0},
    {"SpotCutoff", [] { light(GL_LIGHT0, GL_SPOT_CUTOFF, {180}); }, 0, 0},
    {"Material",
     [] {
       material(GL_FRONT, GL_DIFFUSE, {0.8f, 0.8f, 0.8f, 1});
     },
     0, 0},
    {"MaterialOfBothFaces",
     [] {
       material(GL_FRONT_AND_BACK, GL_SPECULAR, {0, 0, 0, 1});
     },
     0, 0},
    {"LightModelAmbient",
     [] {
       light_model(GL_LIGHT_MODEL_AMBIENT, {0.2f, 0.2f, 0.2f, 1});
     },
     0, 0},
    {"ColorMaterial", [] { lglColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE); }, 0, 0},
    {"ShadeModel", [] { lglShadeModel(GL_SMOOTH); }, 0, 0},
    {"Enable", [] { lglEnable(GL_LIGHTING); }, 0, 0},
    {"Disable", [] { lglDisable(GL_NORMALIZE); }, 0, 0},
    {"EnableLight", [] { lglEnable(GL_LIGHT0); }, 0, 0},
    {"DepthFunc", [] { lglDepthFunc(GL_LESS); }, 0, 0},
    {"CullFace", [] { lglCullFace(GL_BACK); }, 0, 0},
    {"FogDensity", [] { lglFogf(GL_FOG_DENSITY, 1); }, 0, 0},
    {"CurrentValues", [] { lglColor3f(1, 0, 0), lglNormal3f(1, 0, 0), lglTexCoord2f(1, 1); }, 0, 0},
};
INSTANTIATE_TEST_SUITE_P(Calls, UnchangedTest, testing::ValuesIn(kUnchanged), name_of);

class ChangedTest : public CallTest {};
TEST_P(ChangedTest, DrawsUnderTheOldValueAndMarks) {
  const LightingState lighting = context.lighting;
  bool under_the_old_value = false;
  renderer.before_batch = [&] { under_the_old_value = equal(context.lighting, lighting); };
  GetParam().make();
  EXPECT_EQ(take_error(), GLenum{GL_NO_ERROR});
  ASSERT_EQ(renderer.batches.size(), 1u);
  EXPECT_TRUE(under_the_old_value);
  EXPECT_EQ(context.dirty, GetParam().dirty);
}

constexpr Call kChanged[] = {
    {"LightDiffuse",
     [] {
       light(GL_LIGHT0, GL_DIFFUSE, {1, 1, 0, 1});
     },
     0, kDirtyLights},
    {"LightPosition",
     [] {
       light(GL_LIGHT0, GL_POSITION, {0, 0, 1, 1});
     },
     0, kDirtyLights},
    {"SpotDirection", [] { light(GL_LIGHT0, GL_SPOT_DIRECTION, {1}); }, 0, kDirtyLights},
    {"EnableLight", [] { lglEnable(GL_LIGHT0 + 1); }, 0, kDirtyLights},
    {"Material", [] { material(GL_FRONT, GL_DIFFUSE, {}); }, 0, kDirtyMaterial},
    {"Shininess", [] { material(GL_FRONT, GL_SHININESS, {3}); }, 0, kDirtyMaterial},
    {"LightModelAmbient", [] { light_model(GL_LIGHT_MODEL_AMBIENT, {}); }, 0, kDirtyMaterial},
    {"LocalViewer", [] { lglLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); }, 0,
     kDirtyKey | kDirtyTransform},
    {"TwoSide", [] { lglLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); }, 0, kDirtyKey | kDirtyMaterial},
    {"ColorControl",
     [] { lglLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR); }, 0,
     kDirtyKey},
    {"ColorMaterialMode", [] { lglColorMaterial(GL_FRONT, GL_EMISSION); }, 0,
     kDirtyKey | kDirtyMaterial},
    {"ColorMaterial", [] { lglEnable(GL_COLOR_MATERIAL); }, 0, kDirtyKey | kDirtyMaterial},
    {"ShadeModel", [] { lglShadeModel(GL_FLAT); }, 0, kDirtyKey},
    {"Normalize", [] { lglEnable(GL_NORMALIZE); }, 0, kDirtyTransform},
    {"Modelview", [] { lglTranslatef(0, 0, 1); }, 0, kDirtyTransform},
    {"DepthFunc", [] { lglDepthFunc(GL_ALWAYS); }, 0, kDirtyRaster},
    {"Fog", [] { lglEnable(GL_FOG); }, 0, kDirtyKey | kDirtyFragments},
};
INSTANTIATE_TEST_SUITE_P(Calls, ChangedTest, testing::ValuesIn(kChanged), name_of);

using SettersTest = LitTest;

TEST_F(SettersTest, ALightThatIsOffEndsNoBatch) {
  light(GL_LIGHT0 + 1, GL_DIFFUSE, {1, 0, 0, 1});
  light(GL_LIGHT0 + 1, GL_POSITION, {1, 2, 3, 1});
  EXPECT_EQ(context.lighting.lights[1].diffuse, glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(context.dirty, 0u);
  EXPECT_TRUE(renderer.batches.empty());
  lglEnable(GL_LIGHT0 + 1);  // brings all of it up to date
  EXPECT_EQ(context.dirty, kDirtyLights);
  EXPECT_EQ(renderer.batches.size(), 1u);
}

TEST_F(SettersTest, AMaterialThatNoFaceShowsEndsNoBatch) {
  material(GL_BACK, GL_DIFFUSE, {1, 0, 0, 1});
  EXPECT_EQ(context.lighting.materials[kBack].diffuse, glm::vec4(1, 0, 0, 1));
  EXPECT_TRUE(renderer.batches.empty());
  lglLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  EXPECT_TRUE(context.dirty & kDirtyMaterial);
}

TEST_F(SettersTest, LightsEndNoBatchThatIsNotLit) {
  lglDisable(GL_LIGHTING);
  primitive(GL_TRIANGLES, 3);
  flush_pending(context);
  renderer.batches.clear();
  primitive(GL_TRIANGLES, 3);
  light(GL_LIGHT0, GL_DIFFUSE, {1, 0, 0, 1});
  EXPECT_TRUE(renderer.batches.empty());
  EXPECT_EQ(context.dirty, 0u);
  lglEnable(GL_LIGHTING);
  EXPECT_TRUE(context.dirty & kDirtyLights);
}

TEST_F(SettersTest, PositionsGoThroughTheModelviewOfTheCall) {
  lglTranslatef(1, 2, 3);
  light(GL_LIGHT0, GL_POSITION, {1, 1, 1, 1});
  light(GL_LIGHT0, GL_SPOT_DIRECTION, {1, 0, 0});
  lglLoadIdentity();
  EXPECT_EQ(context.lighting.lights[0].position_eye, glm::dvec4(2, 3, 4, 1));
  EXPECT_EQ(context.lighting.lights[0].spot_direction_eye, glm::dvec3(1, 0, 0));
}

TEST_F(SettersTest, SettersAreRefusedInsideBeginEnd) {
  const LightingState lighting = context.lighting;
  lglBegin(GL_TRIANGLES);
  for (void (*call)() :
       {+[] { light(GL_LIGHT0, GL_DIFFUSE, {}); }, +[] { light_model(GL_LIGHT_MODEL_AMBIENT, {}); },
        +[] { lglColorMaterial(GL_FRONT, GL_EMISSION); }, +[] { lglShadeModel(GL_FLAT); },
        +[] { lglEnable(GL_LIGHT0 + 1); }, +[] { lglTranslatef(1, 0, 0); },
        +[] { lglDepthFunc(GL_ALWAYS); }}) {
    call();
    EXPECT_EQ(take_error(), GLenum{GL_INVALID_OPERATION});
  }
  EXPECT_TRUE(equal(context.lighting, lighting));
  EXPECT_EQ(context.dirty, 0u);
  EXPECT_TRUE(renderer.batches.empty());
}

// GL 2.1 spec 2.14.3: what tracked the colour keeps its last value.
TEST_F(SettersTest, ColorMaterialLatches) {
  lglColor4f(1, 0, 0, 0.5f);
  lglEnable(GL_COLOR_MATERIAL);
  const Materials& materials = context.lighting.materials;
  EXPECT_EQ(materials[kFront].diffuse, glm::vec4(1, 0, 0, 0.5f));
  EXPECT_EQ(materials[kBack].ambient, glm::vec4(1, 0, 0, 0.5f));
  EXPECT_EQ(materials[kFront].emission, glm::vec4(0, 0, 0, 1));

  lglColor4f(0, 1, 0, 1);
  lglColorMaterial(GL_FRONT, GL_EMISSION);
  EXPECT_EQ(materials[kFront].diffuse, glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(materials[kFront].emission, glm::vec4(0, 1, 0, 1));
  EXPECT_EQ(materials[kBack].emission, glm::vec4(0, 0, 0, 1));

  lglColor4f(0, 0, 1, 1);
  lglDisable(GL_COLOR_MATERIAL);
  lglColor4f(1, 1, 1, 1);
  EXPECT_EQ(materials[kFront].emission, glm::vec4(0, 0, 1, 1));
  EXPECT_EQ(materials[kFront].diffuse, glm::vec4(0, 1, 0, 1));
}

TEST_F(SettersTest, AColorThatAMaterialTracksEndsNoBatch) {
  lglEnable(GL_COLOR_MATERIAL);
  primitive(GL_TRIANGLES, 3);
  flush_pending(context);
  renderer.batches.clear();
  primitive(GL_TRIANGLES, 300);
  lglColor3f(1, 0, 0);
  material(GL_FRONT, GL_DIFFUSE, {0, 0, 1, 1});  // it is tracked
  EXPECT_EQ(context.dirty, 0u);
  EXPECT_TRUE(renderer.batches.empty());
  lglDisable(GL_COLOR_MATERIAL);
  EXPECT_EQ(context.lighting.materials[kFront].diffuse, glm::vec4(1, 0, 0, 1));
}

TEST_F(SettersTest, TheFirstErrorSticks) {
  lglShadeModel(GL_LINES);
  light(GL_LIGHT0, GL_SPOT_CUTOFF, {91});
  EXPECT_EQ(lglGetError(), GLenum{GL_INVALID_ENUM});
  EXPECT_EQ(lglGetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace legacy_gl::test
