// The accumulation buffer (GL 2.1 spec 4.2.4), beside Mesa's, which has 16 bits.
#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "support/contexts.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 32;

enum class Dialect { core, gles };

void rectangles(const GlFunctions& gl, float turn) {
  gl.ClearColor(0.1F, 0.2F, 0.3F, 0.4F);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.PushMatrix();
  gl.Rotatef(turn, 0, 0, 1);
  gl.Color4f(0.9F, 0.5F, 0.2F, 0.7F);
  gl.Rectf(-0.7F, -0.4F, 0.5F, 0.6F);
  gl.Color4f(0.2F, 0.8F, 0.6F, 1);
  gl.Rectf(0, 0, 0.8F, 0.3F);
  gl.PopMatrix();
}

class Accumulation : public testing::TestWithParam<Dialect> {
 protected:
  void compare(void (*draw)(const GlFunctions&)) {
    const auto image = [&](RenderContext& context) {
      context.recreate();
      draw(context.gl);
      EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
      return context.read();
    };
    const Image mesa = image(mesa_), ours = image(*ours_);
    EXPECT_GE(distinct_colors(ours), 3);
    EXPECT_TRUE(images_match(ours, mesa, {.max_difference_steps = 1}, "accumulation"));
  }

  MesaContext mesa_{kSize, kSize};
  std::unique_ptr<RenderContext> ours_ =
      GetParam() == Dialect::core
          ? std::unique_ptr<RenderContext>(std::make_unique<CoreContext>(kSize, kSize))
          : std::make_unique<GlesContext>(kSize, kSize);
};

INSTANTIATE_TEST_SUITE_P(Dialects, Accumulation, testing::Values(Dialect::core, Dialect::gles),
                         [](const auto& parameter) {
                           return parameter.param == Dialect::core ? "core" : "gles";
                         });

TEST_P(Accumulation, InitialState) {
  const GlFunctions& gl = ours_->gl;
  std::array<GLfloat, 4> value{1, 1, 1, 1};
  gl.GetFloatv(GL_ACCUM_CLEAR_VALUE, value.data());
  EXPECT_EQ(value, (std::array<GLfloat, 4>{}));
  GLint bits = 0;
  gl.GetIntegerv(GL_ACCUM_RED_BITS, &bits);
  EXPECT_EQ(bits, 16);
}

TEST_P(Accumulation, SetAndGet) {
  const GlFunctions& gl = ours_->gl;
  gl.ClearAccum(0.5F, -2, 3, -0.25F);
  gl.PushAttrib(GL_ACCUM_BUFFER_BIT);
  gl.ClearAccum(1, 1, 1, 1);
  gl.PopAttrib();
  std::array<GLfloat, 4> value{};
  gl.GetFloatv(GL_ACCUM_CLEAR_VALUE, value.data());
  EXPECT_EQ(value, (std::array<GLfloat, 4>{0.5F, -1, 1, -0.25F}));
}

TEST_P(Accumulation, Errors) {
  const GlFunctions& gl = ours_->gl;
  gl.Accum(GL_ADD + 1, 1);
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_ENUM});
  gl.Begin(GL_POINTS);
  gl.Accum(GL_LOAD, 1);
  gl.ClearAccum(1, 1, 1, 1);
  gl.End();
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
}

/// A context that did not ask for one.
TEST(AccumulationBuffer, IsThereWhenAskedFor) {
  CoreContext context(kSize, kSize);
  legacy_gl_options options{};
  legacy_gl_context* const plain =
      legacy_gl_create_context(CoreContext::driver_proc, &options, nullptr);
  ASSERT_NE(plain, nullptr);
  legacy_gl_make_current(plain);
  GLint bits = -1;
  context.gl.GetIntegerv(GL_ACCUM_ALPHA_BITS, &bits);
  EXPECT_EQ(bits, 0);
  context.gl.Clear(GL_ACCUM_BUFFER_BIT);
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
  context.gl.Accum(GL_LOAD, 1);
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_INVALID_OPERATION});
  context.make_current();
  legacy_gl_destroy_context(plain);
}

TEST_P(Accumulation, MeanOfFrames) {
  compare([](const GlFunctions& gl) {
    gl.Clear(GL_ACCUM_BUFFER_BIT);
    for (int i = 0; i < 8; ++i) {
      rectangles(gl, static_cast<float>(i) * 9);
      gl.Accum(GL_ACCUM, 0.125F);
    }
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Accum(GL_RETURN, 1);
  });
}

TEST_P(Accumulation, LoadMultiplyAddReturn) {
  compare([](const GlFunctions& gl) {
    rectangles(gl, 20);
    gl.Accum(GL_LOAD, 0.75F);
    gl.Accum(GL_MULT, 0.5F);
    gl.Accum(GL_ADD, 0.125F);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Accum(GL_RETURN, 1.5F);
  });
}

TEST_P(Accumulation, ClearValueAndScissor) {
  compare([](const GlFunctions& gl) {
    gl.ClearAccum(0.25F, 0.5F, -0.125F, 0.25F);
    gl.Clear(GL_ACCUM_BUFFER_BIT);
    rectangles(gl, 0);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(5, 7, 14, 12);
    gl.Accum(GL_ACCUM, 0.5F);
    gl.Disable(GL_SCISSOR_TEST);
    gl.Accum(GL_RETURN, 1);
  });
}

TEST_P(Accumulation, OnlyTheMaskConcernsWhatReturns) {
  compare([](const GlFunctions& gl) {
    rectangles(gl, 45);
    gl.Accum(GL_LOAD, 1);
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.ColorMask(1, 0, 1, 1);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ZERO, GL_ONE);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_NEVER);
    gl.Enable(GL_ALPHA_TEST);
    gl.AlphaFunc(GL_NEVER, 0);
    gl.Enable(GL_FOG);
    gl.PixelTransferf(GL_RED_SCALE, 0.25F);
    gl.Accum(GL_RETURN, 1);
    gl.PixelTransferf(GL_RED_SCALE, 1);
  });
}

TEST_P(Accumulation, InLists) {
  compare([](const GlFunctions& gl) {
    rectangles(gl, 30);
    gl.NewList(1, GL_COMPILE);
    gl.Accum(GL_LOAD, 0.5F);
    gl.Accum(GL_RETURN, 1);
    gl.EndList();
    gl.CallList(1);
    gl.CallList(1);
  });
}

}  // namespace

}  // namespace legacy_gl::test
