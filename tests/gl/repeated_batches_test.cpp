// What a program gives by Begin/End in every frame alike is drawn as a kept mesh; what goes on
// otherwise is drawn as it is given. Mesa's fixed function says that the picture is the same.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "support/contexts.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {
namespace {

constexpr int kSize = 96;
constexpr int kSlices = 120;

// How the ball differs from the usual one.
struct Ball {
  int stacks = 80;        // of 80; fewer leave it open
  int dented_stack = -1;  // where one vertex is elsewhere
  GLenum mode = GL_QUAD_STRIP;
  std::function<void(const GlFunctions&, int stack)> between = {};
};

void put_vertex(const GlFunctions& gl, int row, int slice, float radius) {
  const float b = std::numbers::pi_v<float> * (static_cast<float>(row) / 80 - 0.5F);
  const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(slice) / kSlices;
  const float x = std::cos(b) * std::cos(a), y = std::sin(b), z = std::cos(b) * std::sin(a);
  gl.Normal3f(x, y, z);
  gl.Vertex3f(radius * x, radius * y, radius * z);
}

void draw_ball(const GlFunctions& gl, const Ball& ball) {
  if (ball.mode == GL_TRIANGLES) gl.Begin(GL_TRIANGLES);
  for (int stack = 0; stack < ball.stacks; ++stack) {
    if (ball.between) ball.between(gl, stack);
    const float radius = stack == ball.dented_stack ? 0.97F : 1.0F;
    if (ball.mode == GL_TRIANGLES) {
      for (int slice = 0; slice < kSlices; ++slice)
        for (const auto& [row, column] : {std::pair{0, 0}, {0, 1}, {1, 1}, {1, 1}, {1, 0}, {0, 0}})
          put_vertex(gl, stack + row, slice + column, radius);
      continue;
    }
    gl.Begin(ball.mode);
    for (int slice = 0; slice <= kSlices; ++slice)
      for (const int row : {stack, stack + 1}) put_vertex(gl, row, slice, slice == 50 ? radius : 1);
    gl.End();
  }
  if (ball.mode == GL_TRIANGLES) gl.End();
}

class RepeatedBatches : public testing::Test {
 protected:
  RepeatedBatches() : mesa(kSize, kSize), ours(kSize, kSize) {
    for (RenderContext* context : contexts()) {
      context->make_current();
      const GlFunctions& gl = context->gl;
      gl.MatrixMode(GL_PROJECTION);
      gl.Frustum(-0.4, 0.4, -0.4, 0.4, 1, 20);
      gl.MatrixMode(GL_MODELVIEW);
      gl.Translatef(0, 0, -4);
      gl.Rotatef(50, 1, 0.5F, 0.2F);
      for (const GLenum what : std::initializer_list<GLenum>{GL_DEPTH_TEST, GL_LIGHTING, GL_LIGHT0})
        gl.Enable(what);
    }
  }

  std::array<RenderContext*, 2> contexts() { return {&mesa, &ours}; }

  // A frame on both; the triangles that ours left out.
  std::uint64_t frame(const Ball& ball) {
    return frame_of([&ball](const GlFunctions& gl) { draw_ball(gl, ball); });
  }
  std::uint64_t frame_of(const std::function<void(const GlFunctions&)>& draw) {
    std::array<Image, 2> images;
    for (std::size_t i = 0; i < 2; ++i) {
      contexts()[i]->make_current();
      if (i == 1) legacy_gl_reset_statistics();
      const GlFunctions& gl = contexts()[i]->gl;
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      draw(gl);
      images[i] = contexts()[i]->read_rgba8();
    }
    EXPECT_TRUE(images_match(images[1], images[0], {.max_difference_steps = 1}, "repeated"));
    EXPECT_GT(covered_pixels(images[0]), 500);
    legacy_gl_statistics statistics;
    legacy_gl_get_statistics(&statistics);
    return statistics.triangles_unseen;
  }
  std::uint64_t after_frames(const Ball& ball, int frames = 6) {
    for (int i = 1; i < frames; ++i) frame(ball);
    return frame(ball);
  }

  MesaContext mesa;
  CoreContext ours;
};

constexpr std::uint64_t kTriangles = std::uint64_t{2} * kSlices * 80;

TEST_F(RepeatedBatches, AreDrawnAsFarAsTheyAreSeen) {
  for (const GLenum mode :
       std::initializer_list<GLenum>{GL_QUAD_STRIP, GL_TRIANGLE_STRIP, GL_TRIANGLES}) {
    SCOPED_TRACE(mode);
    EXPECT_EQ(frame({.mode = mode}), 0u);
    EXPECT_GT(after_frames({.mode = mode}), kTriangles / 3);
  }
}

TEST_F(RepeatedBatches, AnotherViewOrMaterialIsStillTheSameBatch) {
  after_frames({});
  for (RenderContext* context : contexts()) {
    context->make_current();
    context->gl.Rotatef(70, 0, 1, 1);
    const float red[] = {1, 0, 0, 1};
    context->gl.Materialfv(GL_FRONT, GL_DIFFUSE, red);
  }
  EXPECT_GT(frame({}), kTriangles / 3);
}

TEST_F(RepeatedBatches, OpenOnesAreDrawnWhole) { EXPECT_EQ(after_frames({.stacks = 70}), 0u); }

TEST_F(RepeatedBatches, WhatGoesOnOtherwiseIsDrawnAsGiven) {
  after_frames({});
  EXPECT_EQ(frame({.stacks = 79}), 0u);        // ends early
  EXPECT_GT(frame({}), 0u);                    // and is whole again
  EXPECT_EQ(frame({.dented_stack = 75}), 0u);  // differs late
  EXPECT_GT(frame({}), 0u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(frame({.dented_stack = 40}), 0u);
  EXPECT_EQ(frame({}), 0u);  // what has failed so often is not tried any more
}

TEST_F(RepeatedBatches, MoreOfTheSameStateIsDrawnToo) {
  after_frames({});
  EXPECT_EQ(frame_of([](const GlFunctions& gl) {
              draw_ball(gl, {});
              gl.Begin(GL_TRIANGLES);
              gl.Vertex3f(-1.5F, -1.5F, 0);
              gl.Vertex3f(1.5F, -1.5F, 0);
              gl.Vertex3f(0, 1.5F, 0.5F);
              gl.End();
            }),
            0u);
}

TEST_F(RepeatedBatches, AStateThatChangesWithinSplitsThem) {
  after_frames({});
  const auto change_material = [](const GlFunctions& gl, int stack) {
    if (stack != 60) return;
    const float green[] = {0, 1, 0, 1};
    gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, green);
  };
  frame({.between = change_material});
  const auto flush = [](const GlFunctions& gl, int stack) {
    if (stack == 60) gl.Flush();
  };
  frame({.between = flush});
  const auto turn = [](const GlFunctions& gl, int stack) {
    if (stack == 60) gl.Rotatef(20, 0, 0, 1);
  };
  frame({.between = turn});
}

TEST_F(RepeatedBatches, OtherStatesOfTheSameVerticesAreDrawnAsTheyShouldBe) {
  after_frames({});
  const auto with = [this](GLenum capability) {
    for (RenderContext* context : contexts()) {
      context->make_current();
      context->gl.Enable(capability);
    }
    const std::uint64_t unseen = frame({});
    for (RenderContext* context : contexts()) {
      context->make_current();
      context->gl.Disable(capability);
    }
    return unseen;
  };
  EXPECT_EQ(with(GL_BLEND), 0u);
  EXPECT_GT(frame({}), 0u);
  with(GL_NORMALIZE);
  with(GL_FOG);
  with(GL_COLOR_MATERIAL);
  EXPECT_GT(frame({}), 0u);
}

// The ball by client arrays, as triangles of shared vertices.
struct Arrays {
  std::vector<float> vertices;  // normal, position
  std::vector<GLuint> elements;

  Arrays() {
    for (int row = 0; row <= 80; ++row)
      for (int slice = 0; slice <= kSlices; ++slice) {
        const float b = std::numbers::pi_v<float> * (static_cast<float>(row) / 80 - 0.5F);
        const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(slice) / kSlices;
        for (int copy = 0; copy < 2; ++copy)
          for (const float value :
               {std::cos(b) * std::cos(a), std::sin(b), std::cos(b) * std::sin(a)})
            vertices.push_back(value);
      }
    for (GLuint row = 0; row < 80; ++row)
      for (GLuint slice = 0; slice < kSlices; ++slice) {
        const GLuint at = row * (kSlices + 1) + slice, above = at + kSlices + 1;
        elements.insert(elements.end(), {at, at + 1, above + 1, above + 1, above, at});
      }
  }
  void draw(const GlFunctions& gl) const {
    gl.InterleavedArrays(GL_N3F_V3F, 0, vertices.data());
    gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(elements.size()), GL_UNSIGNED_INT,
                    elements.data());
  }
};

TEST_F(RepeatedBatches, ClientArraysAreComparedInEveryDraw) {
  Arrays arrays;
  const auto draw = [&arrays](const GlFunctions& gl) { arrays.draw(gl); };
  EXPECT_EQ(frame_of(draw), 0u);
  for (int i = 0; i < 5; ++i) frame_of(draw);
  EXPECT_GT(frame_of(draw), kTriangles / 3);
  // One vertex moves, then one element names another.
  for (std::size_t k = 3; k < 6; ++k) arrays.vertices[6 * 5000 + k] *= 1.2F;
  EXPECT_EQ(frame_of(draw), 0u);
  for (int i = 0; i < 5; ++i) frame_of(draw);
  EXPECT_GT(frame_of(draw), kTriangles / 3);
  std::swap(arrays.elements[30000], arrays.elements[30001]);
  EXPECT_EQ(frame_of(draw), 0u);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(frame_of(draw), 0u);  // a triangle is turned: not closed
}

TEST_F(RepeatedBatches, ArraysThatMoveInEveryFrameAreDrawnAsTheyAre) {
  Arrays arrays;
  for (int i = 1; i <= 20; ++i) {
    arrays.vertices[6 * 5000 + 3] += 0.01F;
    const std::uint64_t unseen = frame_of([&arrays](const GlFunctions& gl) { arrays.draw(gl); });
    // Copied three times for nothing, they are not looked at any more.
    EXPECT_TRUE(i <= 12 || unseen == 0) << "frame " << i;
  }
}

// Of more figures than are remembered, each is drawn all the same.
TEST_F(RepeatedBatches, MoreThanAreRemembered) {
  for (int round = 0; round < 4; ++round)
    for (int i = 0; i < 40; ++i)
      frame_of([i](const GlFunctions& gl) {
        gl.Normal3f(0, 0, 1);
        gl.Begin(GL_TRIANGLE_STRIP);
        for (int k = 0; k < 1100; ++k)
          gl.Vertex3f(static_cast<float>(k) / 600 - 0.9F, k % 2 ? 1.0F : -1.0F,
                      0.02F * static_cast<float>(i));
        gl.End();
      });
}

TEST_F(RepeatedBatches, ManyOfThemOneAfterTheOther) {
  const auto balls = [](const GlFunctions& gl) {
    for (int i = 0; i < 3; ++i) {
      gl.PushMatrix();
      gl.Translatef(static_cast<float>(i) - 1, 0, 0);
      gl.Scalef(0.5F, 0.5F, 0.5F);
      draw_ball(gl, {.stacks = i == 1 ? 60 : 80});
      gl.PopMatrix();
    }
  };
  for (int i = 0; i < 5; ++i) frame_of(balls);
  EXPECT_GT(frame_of(balls), kTriangles / 3);
}

}  // namespace
}  // namespace legacy_gl::test
