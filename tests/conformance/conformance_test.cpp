// Every scene, drawn by Mesa's fixed function and by legacy_gl on both dialects.
#include <gtest/gtest.h>

#include <ostream>

#include "conformance/render_pair.hpp"
#include "conformance/results.hpp"
#include "conformance/scene.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {

namespace {

// The largest error that Mesa itself makes in ordinary ranges is 0.0056/255; twice that and the
// interpolation's rounding leave 0.02/255.
constexpr float float_tolerance_steps = 0.02F;

struct SceneCase {
  Dialect dialect;
  const Feature* feature;
  const Scene* scene;

  std::string full_name() const { return feature->name + "__" + scene->name; }
};

void PrintTo(const SceneCase& scene_case, std::ostream* out) {
  *out << dialect_name(scene_case.dialect) << " " << scene_case.full_name();
}

std::vector<SceneCase> scene_cases(Dialect dialect) {
  std::vector<SceneCase> cases;
  for (const Feature& feature : features())
    for (const Scene& scene : feature.scenes) cases.push_back({dialect, &feature, &scene});
  return cases;
}

std::string case_name(const testing::TestParamInfo<SceneCase>& info) {
  return info.param.full_name();
}

// From OpenGL's initial state. A scene that raises an error is a wrong scene, or a wrong library.
Image render(RenderContext& context, const Draw& draw, const char* whose) {
  context.recreate();
  draw(context.gl);
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR}) << whose;
  return context.read();
}

class SceneConformance : public testing::TestWithParam<SceneCase> {
 protected:
  // Compares with Mesa, or for a departure of Mesa's with its reference.
  void compare_in(PixelFormat format, float tolerance_steps) {
    const Scene& scene = *GetParam().scene;
    const bool departs = !scene.traits.mesa_departure.empty();
    RenderPair& pair = render_pair(GetParam().dialect, scene_size, format);
    const Image mesa = render(*pair.mesa, departs ? scene.traits.reference : scene.draw, "Mesa");
    const Image ours = render(*pair.ours, scene.draw, "legacy_gl");

    ImageTolerance tolerance{.max_difference_steps = tolerance_steps};
    const Comparison comparison = compare(ours, mesa);
    const bool passed =
        comparison.max_difference() <= tolerance_steps && comparison.same_coverage();
    record_result({dialect_name(GetParam().dialect), GetParam().feature->name, scene.name, format,
                   departs ? scene.traits.mesa_departure : "Mesa", comparison.max_difference(),
                   comparison.differing_pixels, passed});
    EXPECT_TRUE(images_match(ours, mesa, tolerance,
                             std::string(dialect_name(GetParam().dialect)) + "-" +
                                 GetParam().full_name() + "-" + format_name(format)));
  }
};

// One step: the two round colours to RGBA8 that differ by the last bits of a float.
TEST_P(SceneConformance, Rgba8WithinOneStep) { compare_in(PixelFormat::rgba8, 1.0F); }

TEST_P(SceneConformance, FloatColorsWithinFiftiethOfAStep) {
  // Where texels are filtered the two interpolate coordinates, and with them weights, of which
  // llvmpipe keeps 8 bits.
  compare_in(PixelFormat::rgba32f, GetParam().scene->traits.filtered ? 1.0F + float_tolerance_steps
                                                                     : float_tolerance_steps);
}

INSTANTIATE_TEST_SUITE_P(core_330, SceneConformance,
                         testing::ValuesIn(scene_cases(Dialect::core_330)), case_name);
INSTANTIATE_TEST_SUITE_P(es_300, SceneConformance, testing::ValuesIn(scene_cases(Dialect::es_300)),
                         case_name);

// The scenes themselves: an empty picture would agree with anything.
class SceneOnMesa : public testing::TestWithParam<SceneCase> {};

TEST_P(SceneOnMesa, DrawsSomethingAndRepeats) {
  const Scene& scene = *GetParam().scene;
  RenderContext& mesa = mesa_context(scene_size, PixelFormat::rgba8);
  const Image first = render(mesa, scene.draw, "Mesa");
  const Image second = render(mesa, scene.draw, "Mesa");
  EXPECT_TRUE(compare(first, second).identical());
  if (scene.traits.draws_nothing) return;
  EXPECT_GE(covered_pixels(first), 20);
  EXPECT_GE(distinct_colors(first), scene.traits.few_colors ? 1 : 4);
}

// A row of the table of departures that Mesa no longer earns must leave it. In float: some are
// smaller than a step of RGBA8, but none is as small as what is allowed as Mesa's own error.
TEST_P(SceneOnMesa, DepartsFromTheReferenceOnlyWhereMarked) {
  const Scene& scene = *GetParam().scene;
  if (scene.traits.mesa_departure.empty()) return;
  RenderContext& mesa = mesa_context(scene_size, PixelFormat::rgba32f);
  const Image drawn = render(mesa, scene.draw, "Mesa");
  const Image reference = render(mesa, scene.traits.reference, "Mesa");
  EXPECT_GT(covered_pixels(reference), 0);
  EXPECT_GT(compare(drawn, reference).max_difference(), float_tolerance_steps)
      << scene.traits.mesa_departure;
}

INSTANTIATE_TEST_SUITE_P(mesa, SceneOnMesa, testing::ValuesIn(scene_cases(Dialect::core_330)),
                         case_name);

}  // namespace

}  // namespace legacy_gl::test
