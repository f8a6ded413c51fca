// The general program stands in for specialised ones: soon, and without a visible difference.
#include <gtest/gtest.h>

#include "conformance/random_state.hpp"
#include "scene_changes.hpp"
#include "support/contexts.hpp"
#include "support/image_matcher.hpp"
#include "support/library.hpp"

namespace legacy_gl::test {
namespace {

struct Picture {
  Image colors;
  std::vector<float> depths;
};

Picture draw_state(RenderContext& context, int index) {
  context.make_current();
  draw_random_state(context.gl, index);
  Picture picture{context.read_float(), {}};
  picture.depths.resize(std::size_t{random_state_size} * random_state_size);
  context.gl.ReadPixels(0, 0, random_state_size, random_state_size, GL_DEPTH_COMPONENT, GL_FLOAT,
                        picture.depths.data());
  return picture;
}

// Half a step of 8 bits: the change from one to the other is at most one step, as rounding is.
constexpr float kHalfStep = 0.5F;

TEST(GeneralProgram, AgreesWithSpecialisedProgramsOverRandomStates) {
  constexpr int kSize = random_state_size;
  CoreContext special(kSize, kSize, PixelFormat::rgba32f);
  CoreContext general(kSize, kSize, PixelFormat::rgba32f, options_with(LEGACY_GL_PROGRAMS_GENERAL));
  for (int index = 0; index < random_state_count; index += 17) {
    const Picture expected = draw_state(special, index);
    const Picture actual = draw_state(general, index);
    EXPECT_TRUE(images_match(actual.colors, expected.colors, {.max_difference_steps = kHalfStep},
                             "general-state-" + std::to_string(index)));
    EXPECT_EQ(actual.depths, expected.depths) << "state " << index;
  }
  general.make_current();
  EXPECT_GT(statistics_now().general_draws, 0u);
  const std::uint64_t few = statistics_now().programs_compiled;
  special.make_current();
  EXPECT_LT(2 * few, statistics_now().programs_compiled);
}

TEST(GeneralProgram, AgreesWithMesaInEs300) {
  constexpr int kSize = random_state_size;
  MesaContext mesa(kSize, kSize, PixelFormat::rgba8, Target::framebuffer_object);
  GlesContext general(kSize, kSize, PixelFormat::rgba8, options_with(LEGACY_GL_PROGRAMS_GENERAL));
  for (int index = 3; index < random_state_count; index += 97) {
    mesa.make_current();
    draw_random_state(mesa.gl, index);
    const Image expected = mesa.read();
    general.make_current();
    draw_random_state(general.gl, index);
    EXPECT_TRUE(images_match(general.read(), expected, {.max_difference_steps = 1},
                             "general-es-state-" + std::to_string(index)));
  }
}

// Each mask of eight lights in turn.
void draw_masks(const GlFunctions& gl, unsigned count) {
  for (unsigned mask = 0; mask < count; ++mask) {
    for (unsigned i = 0; i < 8; ++i) {
      if (mask >> i & 1) gl.Enable(GL_LIGHT0 + i);
      else gl.Disable(GL_LIGHT0 + i);
    }
    gl.Begin(GL_TRIANGLES);
    for (int corner = 0; corner < 3; ++corner)
      gl.Vertex3f(static_cast<float>(corner == 1), static_cast<float>(corner == 2), 0);
    gl.End();
  }
  gl.Finish();
}

TEST(GeneralProgram, AllSetsOfLightsNeedOneBesidesTheFirst) {
  CoreContext context(64, 64, PixelFormat::rgba8, options_with(LEGACY_GL_PROGRAMS_GENERAL_FIRST));
  const GlFunctions& gl = context.gl;
  set_up_scene(gl);
  const float white[] = {0.1F, 0.1F, 0.1F, 1}, point[] = {1, 2, 3, 1};
  for (unsigned i = 0; i < 8; ++i) {
    gl.Lightfv(GL_LIGHT0 + i, GL_DIFFUSE, white);
    if (i > 2) gl.Lightfv(GL_LIGHT0 + i, GL_POSITION, point);
    if (i > 4) gl.Lightf(GL_LIGHT0 + i, GL_SPOT_CUTOFF, 50);
    if (i > 5) gl.Lightf(GL_LIGHT0 + i, GL_LINEAR_ATTENUATION, 0.1F);
  }
  draw_masks(gl, 1);
  EXPECT_EQ(statistics_now().general_draws, 0u);
  draw_masks(gl, 256);
  EXPECT_EQ(statistics_now().programs_compiled, 2u);
  legacy_gl_reset_statistics();
  draw_masks(gl, 256);
  EXPECT_EQ(statistics_now().programs_generated, 0u);
}

TEST(GeneralProgram, MoreThanEightLights) {
  legacy_gl_options options = options_with(LEGACY_GL_PROGRAMS_GENERAL);
  options.max_lights = 32;
  CoreContext general(64, 64, PixelFormat::rgba8, options);
  options.programs = LEGACY_GL_PROGRAMS_SPECIALISED;
  CoreContext special(64, 64, PixelFormat::rgba8, options);
  for (RenderContext* const context :
       {static_cast<RenderContext*>(&general), static_cast<RenderContext*>(&special)}) {
    context->make_current();
    set_up_scene(context->gl);
    for (unsigned i = 0; i < 20; ++i) {
      const float color[] = {0.02F * static_cast<float>(i % 5), 0.05F, 0.03F, 1};
      const float position[] = {static_cast<float>(i) - 10, 3, 2, static_cast<float>(i % 2)};
      context->gl.Lightfv(GL_LIGHT0 + i, GL_DIFFUSE, color);
      context->gl.Lightfv(GL_LIGHT0 + i, GL_POSITION, position);
      context->gl.Enable(GL_LIGHT0 + i);
    }
    draw_scene(context->gl);
  }
  const Image expected = special.read_rgba8();
  general.make_current();
  EXPECT_TRUE(images_match(general.read_rgba8(), expected, {.max_difference_steps = 1},
                           "general-20-lights"));
  EXPECT_GT(statistics_now().general_draws, 0u);
}

TEST(GeneralProgram, GivesWayOnceAStateHasDrawnEnough) {
  CoreContext context(64, 64, PixelFormat::rgba8, options_with(LEGACY_GL_PROGRAMS_GENERAL_FIRST));
  const GlFunctions& gl = context.gl;
  set_up_scene(gl);
  const auto draw_much = [&gl] {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 30000; ++i) {
      gl.Normal3f(static_cast<float>(i % 3) - 1, 0, 1);
      gl.Vertex3f(static_cast<float>(i % 3 == 1), static_cast<float>(i % 3 == 2), 0);
    }
    gl.End();
  };
  draw_much();
  gl.Enable(GL_LIGHT1);
  draw_much();
  const Image before = context.read_rgba8();
  EXPECT_EQ(statistics_now().programs_compiled, 2u);
  for (int frame = 0; frame < 60; ++frame) draw_much();
  EXPECT_TRUE(
      images_match(context.read_rgba8(), before, {.max_difference_steps = 1}, "takes-over"));
  EXPECT_EQ(statistics_now().programs_compiled, 3u);
  legacy_gl_reset_statistics();
  draw_much();
  gl.Finish();
  EXPECT_EQ(statistics_now().general_draws, 0u);
  EXPECT_EQ(statistics_now().programs_generated, 0u);
}

}  // namespace
}  // namespace legacy_gl::test
