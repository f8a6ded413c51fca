// Error against the oracle, class by class: Mesa's fixed function (which proves that the oracle,
// the classes and the probe agree with an independent implementation) and this library.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdio>
#include <map>
#include <string>

#include "oracle/sampler.hpp"
#include "support/contexts.hpp"
#include "support/shared_context.hpp"

namespace oracle {
namespace {

using legacy_gl::test::CoreContext;
using legacy_gl::test::Image;
using legacy_gl::test::make_shared_context;
using legacy_gl::test::MesaContext;
using legacy_gl::test::PixelFormat;
using legacy_gl::test::RenderContext;

constexpr int tiles_across = 16;  // 262144 samples a picture
constexpr std::uint32_t seed = 1;

ErrorStatistics measure(RenderContext& context, const LightingClass& lighting_class) {
  Image picture;
  SampleTarget target;
  target.draw = [&](const Batch& batch, std::uint32_t number) {
    draw_batch(context.gl, batch, number, tiles_across);
  };
  target.begin = [&] {
    context.make_current();
    context.gl.ClearColor(0, 0, 0, 0);
    context.gl.Clear(GL_COLOR_BUFFER_BIT);
  };
  target.read = [&] {
    picture = context.read_float();
    return static_cast<const float*>(picture.floats.data());
  };
  return run_class(lighting_class, seed, 1, tiles_across, target);
}

constexpr int width = tiles_across * batch_side;

RenderContext& mesa() {
  static auto& context = make_shared_context<MesaContext>(width, width, PixelFormat::rgba32f);
  return context;
}

RenderContext& ours(legacy_gl_quality quality) {
  static std::map<legacy_gl_quality, CoreContext*> contexts;
  CoreContext*& context = contexts[quality];
  if (context == nullptr) {
    legacy_gl_options options = {};
    options.quality = quality;
    context = &make_shared_context<CoreContext>(width, width, PixelFormat::rgba32f, options);
  }
  return *context;
}

void report(const char* who, const LightingClass& lighting_class, const ErrorStatistics& error) {
  std::printf("%-5s %-32s max %.2e rms %.2e alpha %.1e skipped %llu worst %u/%d\n", who,
              lighting_class.name.c_str(), error.largest, error.root_mean_square(),
              error.largest_alpha, static_cast<unsigned long long>(error.skipped),
              error.worst_batch, error.worst_vertex);
}

class Accuracy : public testing::TestWithParam<LightingClass> {};

TEST_P(Accuracy, MesaAgreesWithTheOracle) {
  const ErrorStatistics error = measure(mesa(), GetParam());
  report("Mesa", GetParam(), error);
  // Its largest error over 21 million samples of such classes was found to be 0.0056 / 255.
  EXPECT_LT(error.largest, 0.01);
  EXPECT_EQ(error.largest_alpha, 0);
  EXPECT_GT(error.samples, 0.999 * width * width);
}

// The largest error that is asked of the default quality, in 1/255: half of Mesa's. Classes that
// have no goal of their own take that of the nearest one that has.
double default_goal(const std::string& name) {
  if (name == "ambient and emission") return 2e-5;
  if (name == "diffuse, directional") return 4e-5;
  if (name == "shininess 0") return 4e-5;
  if (name == "specular, shininess 10") return 1.8e-4;
  if (name == "specular, shininess 50") return 1e-3;
  if (name == "specular, shininess 128") return 2.8e-3;
  if (name == "specular, fractional shininess") return 2.8e-3;
  if (name == "spot, any exponent") return 6e-4;
  if (name == "normalize, shear and scale") return 1e-4;
  if (name == "two-sided") return 1.2e-3;
  if (name == "colour material") return 1.2e-3;
  if (name == "separate specular") return 1.2e-3;
  if (name == "eight lights, everything mixed") return 3e-4;
  return 1e-3;
}

// A tenth of Mesa's, of the precise quality.
double precise_goal(const std::string& name) {
  if (name == "ambient and emission") return 2e-5;
  if (name == "diffuse, directional") return 2e-5;
  if (name == "shininess 0") return 4e-5;
  if (name == "specular, shininess 10") return 4e-5;
  if (name == "specular, shininess 50") return 2e-4;
  if (name == "specular, shininess 128") return 6e-4;
  if (name == "specular, fractional shininess") return 6e-4;
  if (name == "spot, any exponent") return 4e-4;
  if (name == "normalize, shear and scale") return 1e-4;
  if (name == "two-sided") return 4e-4;
  if (name == "colour material") return 4e-4;
  if (name == "separate specular") return 4e-4;
  if (name == "eight lights, everything mixed") return 7e-5;
  return 3e-4;
}

void expect_goal(legacy_gl_quality quality, const char* who, const LightingClass& lighting_class,
                 double goal) {
  const ErrorStatistics error = measure(ours(quality), lighting_class);
  report(who, lighting_class, error);
  EXPECT_LE(error.largest, goal);
  EXPECT_EQ(error.largest_alpha, 0);
  EXPECT_GT(error.samples, 0.999 * width * width);
}

TEST_P(Accuracy, DefaultQualityReachesItsGoal) {
  expect_goal(LEGACY_GL_QUALITY_DEFAULT, "ours", GetParam(), default_goal(GetParam().name));
}

// What its documentation promises; a fortieth of it is reached, as Mesa does.
TEST_P(Accuracy, FastestQualityStaysInItsBound) {
  expect_goal(LEGACY_GL_QUALITY_FASTEST, "fast", GetParam(), 0.25);
}

TEST_P(Accuracy, PreciseQualityReachesItsGoal) {
  expect_goal(LEGACY_GL_QUALITY_PRECISE, "prec", GetParam(), precise_goal(GetParam().name));
}

INSTANTIATE_TEST_SUITE_P(Classes, Accuracy,
                         testing::ValuesIn(lighting_classes().begin(), lighting_classes().end()),
                         [](const testing::TestParamInfo<LightingClass>& instance) {
                           std::string name;
                           for (const char c : instance.param.name) {
                             if (std::isalnum(static_cast<unsigned char>(c))) name += c;
                           }
                           return name;
                         });

// The probe itself: a material that differs by a hundredth of a colour step is seen.
TEST(Probe, SeesAHundredthOfAStep) {
  LightingClass altered{"altered", [](std::uint32_t s, std::uint32_t number) {
                          Batch batch = lighting_classes()[1].make(s, number);
                          batch.state.front.emission[1] = 0.25f;
                          return batch;
                        }};
  EXPECT_LT(measure(mesa(), altered).largest, 1e-3);
  const auto draw_other = [](std::uint32_t s, std::uint32_t number) {
    Batch batch = lighting_classes()[1].make(s, number);
    batch.state.front.emission[1] = 0.25f + 0.01f / 255;
    return batch;
  };
  RenderContext& context = mesa();
  context.make_current();
  context.gl.Clear(GL_COLOR_BUFFER_BIT);
  draw_batch(context.gl, draw_other(seed, 0), 0, tiles_across);
  const Image picture = context.read_float();
  const ErrorStatistics error =
      judge_batch(altered.make(seed, 0), 0, picture.floats.data(), 4 * std::size_t(width));
  EXPECT_NEAR(error.largest, 0.01, 0.001);
}

}  // namespace
}  // namespace oracle
