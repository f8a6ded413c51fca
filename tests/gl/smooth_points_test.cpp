// GL_POINT_SMOOTH (GL 2.1 spec 3.3.1, 3.11): a point takes from alpha what of a pixel it does not
// cover. Mesa's edges are no judge (M23 of docs/deviations.md), the area of circles is; its colours
// are.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 64;

/// The part of the pixel (x, y) that the circle covers, from 32 x 32 places in it.
double covered_area(int x, int y, double center_x, double center_y, double radius) {
  constexpr int kPlaces = 32;
  int inside = 0;
  for (int i = 0; i < kPlaces; ++i)
    for (int j = 0; j < kPlaces; ++j)
      inside += std::hypot(x + (i + 0.5) / kPlaces - center_x,
                           y + (j + 0.5) / kPlaces - center_y) <= radius;
  return static_cast<double>(inside) / (kPlaces * kPlaces);
}

class SmoothPoints : public testing::TestWithParam<bool> {
 protected:
  SmoothPoints() {
    if (GetParam()) ours_ = std::make_unique<GlesContext>(kSize, kSize);
    else ours_ = std::make_unique<CoreContext>(kSize, kSize);
  }

  static void begin(const GlFunctions& gl) {
    gl.Viewport(0, 0, kSize, kSize);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Ortho(0, kSize, 0, kSize, -1, 1);
    gl.MatrixMode(GL_MODELVIEW);
    gl.ClearColor(0, 0, 0, 0);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Enable(GL_POINT_SMOOTH);
  }

  static unsigned alpha_at(const Image& image, int x, int y) {
    return image.bytes[(static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x)) * 4 + 3];
  }

  /// Where both have a fragment, Mesa's has the colour that ours has.
  void compare_colors(void (*draw)(const GlFunctions&)) {
    const auto run = [draw](RenderContext& context) {
      context.recreate();
      begin(context.gl);
      draw(context.gl);
      EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
      return context.read_rgba8();
    };
    const Image mesa = run(mesa_), ours = run(*ours_);
    int both = 0;
    for (std::size_t at = 0; at < mesa.bytes.size(); at += 4) {
      if (!mesa.bytes[at + 3] || !ours.bytes[at + 3]) continue;
      ++both;
      for (std::size_t c = at; c < at + 3; ++c)
        ASSERT_NEAR(int{ours.bytes[c]}, int{mesa.bytes[c]}, 1) << "pixel " << at / 4;
    }
    EXPECT_GT(both, 300);
  }

  MesaContext mesa_{kSize, kSize};
  std::unique_ptr<RenderContext> ours_;
};

INSTANTIATE_TEST_SUITE_P(Dialects, SmoothPoints, testing::Bool(),
                         [](const auto& parameter) { return parameter.param ? "gles" : "core"; });

/// Not nearer than ten pixels to each other.
void draw_grid(const GlFunctions& gl) {
  gl.PointSize(8.3F);
  gl.Begin(GL_POINTS);
  for (int i = 0; i < 25; ++i) {
    const float x = static_cast<float>(i % 5), y = static_cast<float>(i / 5);
    gl.Color4f(0.2F * x, 0.9F - 0.1F * y, 0.5F, 1);
    gl.Normal3f(0.2F * x - 0.4F, 0.2F * y - 0.4F, 0.7F);
    gl.TexCoord2f(0.2F * x, 0.2F * y);
    gl.Vertex3f(6.3F + 12.1F * x, 7.6F + 12.2F * y, -0.1F * x);
  }
  gl.End();
}

// A pixel's edge is met at any angle: the ramp of one pixel's length departs from the area by up to
// 0.043 for a straight edge at 45 degrees, and by more where a circle is as small as a pixel: in
// the middle of one of size 1 it is 1 and not pi/4.
TEST_P(SmoothPoints, AlphaIsThePartThatIsCovered) {
  const GlFunctions& gl = ours_->gl;
  for (const float size : {1.0F, 2.0F, 3.0F, 4.5F, 8.0F, 21.3F}) {
    const double allowed = size < 2 ? 0.25 : size < 4 ? 0.12 : 0.065;
    for (int offset = 0; offset < 5; ++offset) {
      const float x = 31.5F + 0.23F * static_cast<float>(offset),
                  y = 32.0F - 0.31F * static_cast<float>(offset);
      ours_->make_current();
      begin(gl);
      gl.PointSize(size);
      gl.Color4f(1, 1, 1, 1);
      gl.Begin(GL_POINTS);
      gl.Vertex2f(x, y);
      gl.End();
      const Image image = ours_->read_rgba8();
      double sum = 0, exact_sum = 0, worst = 0;
      for (int row = 0; row < kSize; ++row)
        for (int column = 0; column < kSize; ++column) {
          const double exact = covered_area(column, row, double{x}, double{y}, 0.5 * double{size});
          const double drawn = alpha_at(image, column, row) / 255.0;
          worst = std::max(worst, std::abs(drawn - exact));
          sum += drawn;
          exact_sum += exact;
        }
      EXPECT_LE(worst, allowed) << size << " at " << x << ", " << y;
      // A cone of this ramp holds pi (r^2 + 1/12) in place of pi r^2.
      const double expected = 1 + 1 / (3.0 * double{size} * double{size});
      EXPECT_NEAR(sum / exact_sum, expected, size < 2 ? 0.1 : 0.05)
          << size << " at " << x << ", " << y;
    }
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(SmoothPoints, ColoursAreMesas) { compare_colors(draw_grid); }

TEST_P(SmoothPoints, ColoursOfLitPointsAreMesas) {
  compare_colors([](const GlFunctions& gl) {
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    draw_grid(gl);
  });
}

TEST_P(SmoothPoints, ColoursWithFogAndTexturesAreMesas) {
  compare_colors([](const GlFunctions& gl) {
    const GLubyte texels[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 9, 255, 9, 90, 255, 255};
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.Enable(GL_TEXTURE_2D);
    gl.Enable(GL_FOG);
    draw_grid(gl);
  });
}

TEST_P(SmoothPoints, ColoursOfPolygonsAsPointsAreMesas) {
  compare_colors([](const GlFunctions& gl) {
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    gl.PointSize(12);
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
      gl.Color4f(0.3F * static_cast<float>(i), 0.5F, 0.1F, 1);
      gl.Vertex2f(i == 1 || i == 2 ? 50.2F : 10.4F, i >= 2 ? 48.3F : 12.7F);
    }
    gl.End();
  });
}

TEST_P(SmoothPoints, ListsAndArraysHaveThemWhileTheyAreEnabled) {
  compare_colors([](const GlFunctions& gl) {
    gl.Disable(GL_POINT_SMOOTH);
    gl.NewList(1, GL_COMPILE);
    gl.Enable(GL_POINT_SMOOTH);
    draw_grid(gl);
    gl.EndList();
    gl.CallList(1);
  });
  const Image image = ours_->read_rgba8();
  EXPECT_EQ(alpha_at(image, 3, 3), 0u);  // the corner of a square of this size
}

// The alpha test comes after (GL 2.1 spec 4.1.4), and what is not covered writes no depth.
TEST_P(SmoothPoints, TheAlphaTestSeesTheCoverage) {
  const GlFunctions& gl = ours_->gl;
  begin(gl);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.5F);
  gl.Color4f(1, 1, 1, 0.75F);
  gl.PointSize(20);
  gl.Begin(GL_POINTS);
  gl.Vertex2f(32.3F, 31.6F);
  gl.End();
  const Image image = ours_->read_rgba8();
  int drawn = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const unsigned alpha = alpha_at(image, x, y);
      drawn += alpha != 0;
      EXPECT_TRUE(alpha == 0 || (alpha >= 127 && alpha <= 192)) << alpha;
    }
  EXPECT_NEAR(drawn, 3.1416 * 9.83 * 9.83, 20);  // where 0.75 times coverage is above 0.5
}

TEST_P(SmoothPoints, OfAPointWhoseCentreIsOutsideNothingIsDrawn) {
  const GlFunctions& gl = ours_->gl;
  begin(gl);
  gl.PointSize(20);
  gl.Begin(GL_POINTS);
  gl.Vertex2f(-1, 30);
  gl.Vertex2f(30, 65);
  gl.End();
  const Image image = ours_->read_rgba8();
  for (int i = 0; i < kSize * kSize; ++i) ASSERT_EQ(alpha_at(image, i % kSize, i / kSize), 0u);
}

}  // namespace

}  // namespace legacy_gl::test
