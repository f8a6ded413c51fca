// Every stress class on this library: within the bound where the specification defines the answer,
// finite and in [0,1] everywhere, and no draw changed by an earlier one. Mesa's figure is printed
// beside ours.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <map>

#include "oracle/single_vertex.hpp"
#include "stress/stress_classes.hpp"
#include "support/shared_context.hpp"

namespace oracle {
namespace {

using legacy_gl::test::CoreContext;
using legacy_gl::test::GlesContext;
using legacy_gl::test::make_shared_context;
using legacy_gl::test::MesaContext;
using legacy_gl::test::PixelFormat;
using legacy_gl::test::RenderContext;

constexpr int size = 2;
constexpr std::uint32_t seed = 7;
constexpr std::uint32_t samples_per_class = 150;

// Nearer to a jump of the equation than float arithmetic can tell: a few roundings of a cosine.
constexpr double jump_tolerance = 2e-6;

bool is_presentable(const Color& color) {
  return std::all_of(color.begin(), color.end(),
                     [](float c) { return std::isfinite(c) && c >= 0 && c <= 1; });
}

struct Outcome {
  double largest = 0;
  std::uint32_t worst = 0;
  std::uint32_t judged = 0;
  std::uint32_t not_presentable = 0;
  std::uint32_t poisoned = 0;
};

StressSample reference() {
  Random random(seed, 0);
  return ordinary(random, {1, 2, 3, 1}, {0, 0, 0, 1});
}

Outcome run(RenderContext& context, const StressClass& stress_class) {
  context.make_current();
  const StressSample calm = reference();
  const Color calm_color = draw_lit_vertex(context, calm.state, calm.vertex);
  Outcome outcome;
  for (std::uint32_t i = 0; i < samples_per_class; ++i) {
    Random random(seed, i);
    const StressSample sample = stress_class.make(random);
    const Color color = draw_lit_vertex(context, sample.state, sample.vertex);
    if (!is_presentable(color)) {
      if (outcome.not_presentable++ == 0) outcome.worst = i;
    }
    const Result result = evaluate(sample.state, sample.vertex);
    if (result.defined && (stress_class.on_a_jump || result.distance_to_jump > jump_tolerance)) {
      ++outcome.judged;
      const double error = difference_steps(color, expected_color(sample.state, sample.vertex));
      if (error > outcome.largest) {
        outcome.largest = error;
        outcome.worst = i;
      }
    }
    if (i % 10 == 9 && draw_lit_vertex(context, calm.state, calm.vertex) != calm_color) {
      ++outcome.poisoned;
    }
  }
  return outcome;
}

void print(const char* who, const StressClass& stress_class, const Outcome& outcome) {
  std::printf("%-5s %-44s max %.2e worst %3u judged %3u not finite or clamped %u poisoned %u\n",
              who, stress_class.name.c_str(), outcome.largest, outcome.worst, outcome.judged,
              outcome.not_presentable, outcome.poisoned);
}

template <class Context>
RenderContext& of_quality(legacy_gl_quality quality) {
  static std::map<legacy_gl_quality, Context*> contexts;
  Context*& context = contexts[quality];
  if (context == nullptr) {
    legacy_gl_options options = {};
    options.quality = quality;
    context = &make_shared_context<Context>(size, size, PixelFormat::rgba32f, options);
  }
  return *context;
}

class Stress : public testing::TestWithParam<StressClass> {};

void expect_calm(const StressClass& stress_class, const Outcome& outcome) {
  EXPECT_LE(outcome.largest, stress_class.bound_steps);
  EXPECT_EQ(outcome.not_presentable, 0U);
  EXPECT_EQ(outcome.poisoned, 0U);
}

TEST_P(Stress, MesaForComparison) {
  static auto& mesa = make_shared_context<MesaContext>(size, size, PixelFormat::rgba32f);
  print("Mesa", GetParam(), run(mesa, GetParam()));
}

template <class Context>
void expect_calm_in(legacy_gl_quality quality, const char* who) {
  const Outcome outcome = run(of_quality<Context>(quality), Stress::GetParam());
  print(who, Stress::GetParam(), outcome);
  expect_calm(Stress::GetParam(), outcome);
}

TEST_P(Stress, CoreProfile) { expect_calm_in<CoreContext>(LEGACY_GL_QUALITY_DEFAULT, "core"); }
TEST_P(Stress, Gles) { expect_calm_in<GlesContext>(LEGACY_GL_QUALITY_DEFAULT, "GLES"); }
TEST_P(Stress, PreciseCoreProfile) {
  expect_calm_in<CoreContext>(LEGACY_GL_QUALITY_PRECISE, "prec");
}
TEST_P(Stress, PerFragmentCoreProfile) {
  expect_calm_in<CoreContext>(LEGACY_GL_QUALITY_PER_FRAGMENT, "frag");
}
TEST_P(Stress, PreciseGles) { expect_calm_in<GlesContext>(LEGACY_GL_QUALITY_PRECISE, "PGLE"); }

INSTANTIATE_TEST_SUITE_P(Classes, Stress,
                         testing::ValuesIn(stress_classes().begin(), stress_classes().end()),
                         [](const testing::TestParamInfo<StressClass>& instance) {
                           std::string name;
                           for (const char c : instance.param.name) {
                             if (std::isalnum(static_cast<unsigned char>(c))) name += c;
                             if (c == '-') name += "m";
                           }
                           return name;
                         });

}  // namespace
}  // namespace oracle
