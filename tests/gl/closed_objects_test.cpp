// Of small closed objects, from lists or given alike again and again, only the triangles that are
// seen are lit and drawn. Mesa's fixed function says that the picture is the same to the last
// sample of the outline.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>

#include "support/contexts.hpp"
#include "support/image_matcher.hpp"
#include "support/library.hpp"

namespace legacy_gl::test {
namespace {

using Change = void (*)(const GlFunctions& gl);

constexpr int kSize = 256;
constexpr int kColumns = 16;  // of objects, and rows
constexpr GLuint kFigures = 4;
constexpr std::uint64_t kObjects = std::uint64_t{kColumns} * kColumns;
constexpr std::uint64_t kTriangles = (12 + 4 + 8 + 96) * kObjects / kFigures;

void vertex(const GlFunctions& gl, const std::array<float, 3>& place) {
  gl.Normal3fv(place.data());
  gl.Vertex3fv(place.data());
}

void draw_cube(const GlFunctions& gl) {
  gl.Begin(GL_QUADS);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0F, 1.0F}) {
      std::array<float, 3> place{};
      place[axis] = side;
      gl.Normal3fv(place.data());
      for (const auto& [a, b] :
           {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {1.0F, 1.0F}, {-1.0F, 1.0F}}) {
        place[(axis + 1) % 3] = side * a;
        place[(axis + 2) % 3] = b;
        gl.Vertex3fv(place.data());
      }
    }
  gl.End();
}

// Wound the other way.
void draw_tetrahedron(const GlFunctions& gl) {
  constexpr std::array<std::array<float, 3>, 4> kCorners{
      {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
  constexpr std::array<std::array<std::size_t, 3>, 4> kFaces{
      {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
  gl.Begin(GL_TRIANGLES);
  for (const auto& face : kFaces)
    for (const std::size_t i : face) vertex(gl, kCorners[i]);
  gl.End();
}

void draw_octahedron(const GlFunctions& gl) {
  constexpr std::array<std::array<float, 3>, 4> kAround{
      {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}};
  for (const bool upper : {true, false}) {
    gl.Begin(GL_TRIANGLE_FAN);
    vertex(gl, {0, 0, upper ? 2.0F : -2.0F});
    for (std::size_t i = 0; i <= 4; ++i) vertex(gl, kAround[(upper ? i : 8 - i) % 4]);
    gl.End();
  }
}

// Its seam and its poles are rounded in different ways.
void draw_ball(const GlFunctions& gl) {
  constexpr int kSlices = 8, kStacks = 6;
  for (int stack = 0; stack < kStacks; ++stack) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int slice = 0; slice <= kSlices; ++slice)
      for (const int row : {stack + 1, stack}) {
        const float b = std::numbers::pi_v<float> * (static_cast<float>(row) / kStacks - 0.5F);
        const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(slice) / kSlices;
        vertex(gl, {std::cos(b) * std::cos(a), std::sin(b), std::cos(b) * std::sin(a)});
      }
    gl.End();
  }
}

// Half a cube is bent, by so much.
void draw_bent_cube(const GlFunctions& gl, float bend) {
  gl.Begin(GL_TRIANGLE_STRIP);
  for (const int i : {3, 2, 7, 6, 4, 2, 0, 3, 1, 7, 5, 4, 1, 0}) {
    const auto side = [i](int axis) { return i >> axis & 1 ? 1.0F : -1.0F; };
    vertex(gl, {side(0) + (side(2) > 0 ? bend : 0), side(1), side(2)});
  }
  gl.End();
}

constexpr std::array<Change, kFigures> kDraw{draw_cube, draw_tetrahedron, draw_octahedron,
                                             draw_ball};

// Inner sides glow red.
void set_up(const GlFunctions& gl) {
  gl.MatrixMode(GL_PROJECTION);
  gl.Frustum(-0.4, 0.4, -0.4, 0.4, 1, 20);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  const std::array<float, 4> red{0.9F, 0, 0, 1};
  gl.Materialfv(GL_BACK, GL_EMISSION, red.data());
  for (GLuint i = 0; i < kFigures; ++i) {
    gl.NewList(1 + i, GL_COMPILE);
    kDraw[i](gl);
    gl.EndList();
  }
}

// Objects side by side, so that nothing but its own front covers an inner side.
void frame(const GlFunctions& gl, unsigned seed, float size, bool from_lists = true) {
  std::minstd_rand random(seed);
  const auto between = [&random](float low, float high) {
    return low + (high - low) * static_cast<float>(random() % 10007) / 10006.0F;
  };
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (unsigned i = 0; i < kObjects; ++i) {
    const auto at = [](unsigned place) {
      return 3.0F * ((static_cast<float>(place) + 0.5F) / kColumns - 0.5F);
    };
    const std::array<float, 4> color{between(0, 0.3F), between(0.3F, 0.7F), between(0, 1), 1};
    gl.PushMatrix();
    gl.Translatef(at(i % kColumns), at(i / kColumns), -4);
    gl.Rotatef(between(0, 360), between(-1, 1), between(-1, 1), between(-1, 1));
    gl.Scalef(size, size, size * between(0.6F, 1));
    gl.Materialfv(GL_FRONT, GL_DIFFUSE, color.data());
    // The tetrahedron shows its back faces.
    gl.FrontFace(i % kFigures == 1 ? GL_CW : GL_CCW);
    if (from_lists) gl.CallList(1 + i % kFigures);
    else kDraw[i % kFigures](gl);
    gl.PopMatrix();
  }
}

class ClosedObjects : public testing::Test {
 protected:
  ClosedObjects()
      : mesa(kSize, kSize),
        ours(kSize, kSize, PixelFormat::rgba8, options_with(LEGACY_GL_PROGRAMS_GENERAL_FIRST)) {
    change(set_up);
  }

  void change(Change what) {
    for (RenderContext* context :
         {static_cast<RenderContext*>(&mesa), static_cast<RenderContext*>(&ours)}) {
      context->make_current();
      what(context->gl);
    }
  }

  // Triangles left out of the frame; its picture is Mesa's.
  std::uint64_t unseen(unsigned seed, float size, bool from_lists = true) {
    mesa.make_current();
    frame(mesa.gl, seed, size, from_lists);
    const Image expected = mesa.read_rgba8();
    ours.make_current();
    legacy_gl_reset_statistics();
    frame(ours.gl, seed, size, from_lists);
    EXPECT_TRUE(images_match(ours.read_rgba8(), expected, {.max_difference_steps = 1}, "closed"));
    EXPECT_EQ(ours.gl.GetError(), GLenum{GL_NO_ERROR});
    const legacy_gl_statistics statistics = statistics_now();
    lit = statistics.objects_lit;
    return statistics.triangles_unseen;
  }

  std::uint64_t lit = 0;  // objects of the last frame
  MesaContext mesa;
  CoreContext ours;
};

TEST_F(ClosedObjects, HiddenSidesAreLeftOutAndNoSampleChanges) {
  for (unsigned seed = 1; seed <= 12; ++seed)
    for (const float size : {0.03F, 0.06F, 0.09F}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", size " << size);
      const std::uint64_t count = unseen(seed, size);
      EXPECT_EQ(lit, kObjects);
      EXPECT_GT(count, kTriangles * 2 / 5);
      EXPECT_LT(count, kTriangles * 4 / 5);
    }
}

void light_one_side(const GlFunctions& gl) { gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 0); }

TEST_F(ClosedObjects, WhatIsSmallerThanASampleIsNotDrawn) {
  change([](const GlFunctions& gl) { gl.Viewport(0, 0, 24, 24); });
  for (unsigned seed = 1; seed <= 4; ++seed) {
    EXPECT_GT(unseen(seed, 0.05F), kTriangles * 3 / 4);
    EXPECT_LT(lit, kObjects * 3 / 4);
  }
}

TEST_F(ClosedObjects, MirroredAndFarFromTheEyeTheyAreTheSame) {
  change([](const GlFunctions& gl) { gl.Scalef(-1, 1, 1); });
  EXPECT_GT(unseen(3, 0.08F), kTriangles / 3);
  // Depths are so near to each other that rounding may change their order.
  change([](const GlFunctions& gl) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Frustum(-0.0004, 0.0004, -0.0004, 0.0004, 0.001, 20000);
    gl.MatrixMode(GL_MODELVIEW);
  });
  unseen(4, 0.08F);
}

TEST_F(ClosedObjects, WhereInnerSidesMatterTheyAreDrawn) {
  change([](const GlFunctions& gl) { gl.DepthMask(0); });
  EXPECT_LT(unseen(5, 0.08F), kTriangles / 8);
  change([](const GlFunctions& gl) {
    gl.DepthMask(1);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
  });
  EXPECT_LT(unseen(6, 0.08F), kTriangles / 8);
}

TEST_F(ClosedObjects, CutByTheNearPlaneTheyAreDrawnWhole) {
  change([](const GlFunctions& gl) {
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Frustum(-1.6, 1.6, -1.6, 1.6, 4, 20);
    gl.MatrixMode(GL_MODELVIEW);
  });
  EXPECT_LT(unseen(7, 0.09F), kTriangles / 8);
}

TEST_F(ClosedObjects, FarOutsideOfTheWindowTheyAreDrawnWhole) {
  change([](const GlFunctions& gl) { gl.Viewport(-9000, -9000, 16000, 16000); });
  unseen(8, 0.09F);
}

// A position of four components is none that small objects are made of.
TEST_F(ClosedObjects, PositionsWithAWAreDrawnAsTheyAre) {
  change([](const GlFunctions& gl) {
    gl.NewList(1, GL_COMPILE);
    gl.Begin(GL_TRIANGLES);
    gl.Normal3f(0, 0, 1);
    gl.Vertex4f(-2, -2, 0, 2);
    gl.Vertex4f(4, -2, 0, 4);
    gl.Vertex4f(0, 3, 0, 3);
    gl.End();
    gl.EndList();
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Translatef(0, 0, -4);
    gl.CallList(1);
  });
  EXPECT_TRUE(images_match(ours.read_rgba8(), mesa.read_rgba8(), {.max_difference_steps = 1}, "w"));
}

}  // namespace
}  // namespace legacy_gl::test
