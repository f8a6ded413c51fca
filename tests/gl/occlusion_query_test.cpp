// Occlusion queries (GL 2.1 spec 4.1.7).
#include <gtest/gtest.h>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 32;

// A rectangle of 16 × 8 pixels, half of it behind another, drawn in a query.
GLuint samples_of_half_hidden_rectangle(const GlFunctions& gl, bool in_list) {
  gl.Enable(GL_DEPTH_TEST);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Rectf(-1, -1, 0, 1);
  gl.DepthFunc(GL_LESS);
  GLuint query = 0;
  gl.GenQueries(1, &query);
  EXPECT_FALSE(gl.IsQuery(query));
  if (in_list) gl.NewList(1, GL_COMPILE);
  gl.BeginQuery(GL_SAMPLES_PASSED, query);
  gl.Rectf(-0.5F, -0.25F, 0.5F, 0.25F);
  gl.EndQuery(GL_SAMPLES_PASSED);
  if (in_list) {
    gl.EndList();
    EXPECT_FALSE(gl.IsQuery(query));
    gl.CallList(1);
  }
  EXPECT_TRUE(gl.IsQuery(query));
  gl.Rectf(-1, -1, 1, 1);  // behind glEndQuery: not counted
  GLuint samples = 0, available = 0;
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &available);
  EXPECT_EQ(available, 1U);
  gl.DeleteQueries(1, &query);
  EXPECT_FALSE(gl.IsQuery(query));
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  return samples;
}

}  // namespace

TEST(OcclusionQuery, CountsSamplesAsMesa) {
  MesaContext mesa(kSize, kSize);
  CoreContext ours(kSize, kSize);
  for (const bool in_list : {false, true}) {
    mesa.recreate();
    EXPECT_EQ(samples_of_half_hidden_rectangle(mesa.gl, in_list), 64U);
    ours.recreate();
    EXPECT_EQ(samples_of_half_hidden_rectangle(ours.gl, in_list), 64U);
  }
}

// GLES has no more than this to say: a counter of one bit.
TEST(OcclusionQuery, TellsWhetherAnySamplePassedOnGles) {
  legacy_gl_options options{};
  options.diagnostic = [](const char*, void*) {};
  GlesContext context(kSize, kSize, PixelFormat::rgba8, options);
  EXPECT_EQ(samples_of_half_hidden_rectangle(context.gl, false), 1U);
  GLint bits = 0;
  context.gl.GetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
  EXPECT_EQ(bits, 1);
}

TEST(OcclusionQuery, IsCurrentWhileItIsActive) {
  CoreContext context(kSize, kSize);
  const GlFunctions& gl = context.gl;
  GLint current = -1, bits = 0;
  gl.BeginQuery(GL_SAMPLES_PASSED, 7);
  gl.GetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &current);
  EXPECT_EQ(current, 7);
  gl.EndQuery(GL_SAMPLES_PASSED);
  gl.GetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &current);
  EXPECT_EQ(current, 0);
  gl.GetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &bits);
  EXPECT_GE(bits, 32);
  GLuint generated = 0;
  for (int i = 0; i < 10; ++i) {
    gl.GenQueries(1, &generated);
    EXPECT_NE(generated, 7U) << "a name in use was given out";
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

}  // namespace legacy_gl::test
