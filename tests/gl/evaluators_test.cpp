// Evaluators (GL 2.1 spec 5.1), beside Mesa's.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 96;
using Draw = void (*)(const GlFunctions&);

// A bicubic patch that bends both ways.
constexpr GLfloat kPatch[4][4][3] = {
    {{-0.8F, -0.8F, 0.3F}, {-0.3F, -0.9F, 0.6F}, {0.3F, -0.7F, -0.5F}, {0.8F, -0.8F, 0.2F}},
    {{-0.9F, -0.3F, 0.4F}, {-0.2F, -0.3F, 0.9F}, {0.2F, -0.2F, 0.3F}, {0.7F, -0.3F, -0.4F}},
    {{-0.7F, 0.3F, -0.2F}, {-0.3F, 0.2F, 0.1F}, {0.3F, 0.3F, 0.8F}, {0.9F, 0.2F, 0.3F}},
    {{-0.8F, 0.8F, 0.1F}, {-0.2F, 0.9F, -0.3F}, {0.2F, 0.7F, 0.2F}, {0.8F, 0.8F, 0.5F}}};
constexpr GLfloat kColors[2][2][4] = {{{1, 0, 0, 1}, {0, 1, 0, 1}}, {{0, 0, 1, 1}, {1, 1, 0, 1}}};
// A circle's arc, rational.
constexpr GLfloat kArc[3][4] = {{0.8F, 0, 0, 1}, {0.5657F, 0.5657F, 0, 0.7071F}, {0, 0.8F, 0, 1}};

void patch(const GlFunctions& gl) {
  gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 12, 4, 0, 1, 3, 4, &kPatch[0][0][0]);
  gl.Enable(GL_MAP2_VERTEX_3);
  gl.MapGrid2f(7, 0, 1, 5, 0, 1);
}

void lit_patch(const GlFunctions& gl) {
  patch(gl);
  gl.Enable(GL_AUTO_NORMAL);
  gl.Enable(GL_NORMALIZE);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_DEPTH_TEST);
}

Image picture(RenderContext& context, Draw draw) {
  context.recreate();
  const GlFunctions& gl = context.gl;
  gl.ClearColor(0.2F, 0.2F, 0.2F, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw(gl);
  gl.Finish();
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  return context.read_rgba8();
}

class Evaluators : public testing::Test {
 protected:
  /// `allowed` pixels may differ by more than a step: Mesa evaluates in float32, whose last place
  /// decides pixels that an edge just meets.
  void compare(Draw draw, int allowed) {
    const Image expected = picture(mesa_, draw), image = picture(ours_, draw);
    int different = 0, drawn = 0;
    for (std::size_t at = 0; at < std::size_t{kSize} * kSize * 4; at += 4) {
      bool same = true, clear = true;
      for (std::size_t c = at; c < at + 3; ++c) {
        same = same && std::abs(int{expected.bytes[c]} - int{image.bytes[c]}) <= 1;
        clear = clear && int{expected.bytes[c]} == 51;
      }
      different += !same;
      drawn += !clear;
    }
    EXPECT_GT(drawn, 30);
    EXPECT_LE(different, allowed) << "of " << drawn << " pixels drawn";
  }

  MesaContext mesa_{kSize, kSize};
  CoreContext ours_{kSize, kSize};
};

}  // namespace

TEST_F(Evaluators, InitialState) {
  for (const RenderContext* context :
       {static_cast<RenderContext*>(&mesa_), static_cast<RenderContext*>(&ours_)}) {
    const GlFunctions& gl = context->gl;
    if (context == &mesa_) mesa_.make_current();
    else ours_.make_current();
    std::array<GLfloat, 4> values{9, 9, 9, 9};
    gl.GetMapfv(GL_MAP1_COLOR_4, GL_COEFF, values.data());
    EXPECT_EQ(values, (std::array<GLfloat, 4>{1, 1, 1, 1}));
    gl.GetMapfv(GL_MAP2_VERTEX_4, GL_COEFF, values.data());
    EXPECT_EQ(values, (std::array<GLfloat, 4>{0, 0, 0, 1}));
    gl.GetMapfv(GL_MAP2_NORMAL, GL_DOMAIN, values.data());
    EXPECT_EQ(values, (std::array<GLfloat, 4>{0, 1, 0, 1}));
    std::array<GLint, 2> order{9, 9};
    gl.GetMapiv(GL_MAP2_INDEX, GL_ORDER, order.data());
    EXPECT_EQ(order, (std::array<GLint, 2>{1, 1}));
    EXPECT_FALSE(gl.IsEnabled(GL_MAP1_VERTEX_3));
    EXPECT_FALSE(gl.IsEnabled(GL_AUTO_NORMAL));
  }
}

TEST_F(Evaluators, SetAndGet) {
  const GlFunctions& gl = ours_.gl;
  ours_.make_current();
  constexpr GLdouble points[] = {1, 2, 3, 99, 4, 5, 6, 99};
  gl.Map1d(GL_MAP1_VERTEX_3, -1, 3, 4, 2, points);
  std::array<GLdouble, 6> kept{};
  gl.GetMapdv(GL_MAP1_VERTEX_3, GL_COEFF, kept.data());
  EXPECT_EQ(kept, (std::array<GLdouble, 6>{1, 2, 3, 4, 5, 6}));
  std::array<GLint, 2> domain{};
  gl.GetMapiv(GL_MAP1_VERTEX_3, GL_DOMAIN, domain.data());
  EXPECT_EQ(domain, (std::array<GLint, 2>{-1, 3}));

  gl.PushAttrib(GL_EVAL_BIT);
  gl.Enable(GL_MAP1_VERTEX_3);
  gl.MapGrid2d(3, 0.5, 1, 4, -1, 2);
  std::array<GLfloat, 4> grid{};
  std::array<GLint, 2> segments{};
  gl.GetFloatv(GL_MAP2_GRID_DOMAIN, grid.data());
  gl.GetIntegerv(GL_MAP2_GRID_SEGMENTS, segments.data());
  EXPECT_EQ(grid, (std::array<GLfloat, 4>{0.5F, 1, -1, 2}));
  EXPECT_EQ(segments, (std::array<GLint, 2>{3, 4}));
  gl.PopAttrib();
  gl.GetIntegerv(GL_MAP2_GRID_SEGMENTS, segments.data());
  EXPECT_EQ(segments, (std::array<GLint, 2>{1, 1}));
  EXPECT_FALSE(gl.IsEnabled(GL_MAP1_VERTEX_3));
  gl.PushAttrib(GL_ENABLE_BIT);
  gl.Enable(GL_MAP2_TEXTURE_COORD_3);
  EXPECT_TRUE(gl.IsEnabled(GL_MAP2_TEXTURE_COORD_3));
  gl.PopAttrib();
  EXPECT_FALSE(gl.IsEnabled(GL_MAP2_TEXTURE_COORD_3));
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Evaluators, CurrentValuesStay) {
  const GlFunctions& gl = ours_.gl;
  ours_.make_current();
  gl.Color4f(0.25F, 0.5F, 0.75F, 1);
  gl.Map2f(GL_MAP2_COLOR_4, 0, 1, 8, 2, 0, 1, 4, 2, &kColors[0][0][0]);
  gl.Enable(GL_MAP2_COLOR_4);
  patch(gl);
  gl.EvalMesh2(GL_FILL, 0, 7, 0, 5);
  std::array<GLfloat, 4> color{};
  gl.GetFloatv(GL_CURRENT_COLOR, color.data());
  EXPECT_EQ(color, (std::array<GLfloat, 4>{0.25F, 0.5F, 0.75F, 1}));
}

TEST_F(Evaluators, RendersCurves) {
  compare(
      [](const GlFunctions& gl) {
        gl.Map1f(GL_MAP1_VERTEX_4, 0, 2, 4, 3, &kArc[0][0]);
        gl.Enable(GL_MAP1_VERTEX_4);
        gl.MapGrid1f(13, 0, 2);
        gl.EvalMesh1(GL_LINE, 0, 13);
        gl.Rotatef(180, 0, 0, 1);
        gl.PointSize(3);
        gl.EvalMesh1(GL_POINT, 2, 11);
        gl.Begin(GL_LINE_STRIP);
        for (int i = 0; i <= 6; ++i) gl.EvalCoord1f(0.2F * static_cast<float>(i));
        gl.EvalPoint1(13);
        gl.End();
      },
      4);
}

TEST_F(Evaluators, RendersColouredSurface) {
  compare(
      [](const GlFunctions& gl) {
        patch(gl);
        gl.Map2f(GL_MAP2_COLOR_4, 0, 1, 8, 2, 0, 1, 4, 2, &kColors[0][0][0]);
        gl.Enable(GL_MAP2_COLOR_4);
        gl.Enable(GL_DEPTH_TEST);
        gl.EvalMesh2(GL_FILL, 0, 7, 0, 5);
      },
      6);
}

TEST_F(Evaluators, RendersLitSurface) {
  compare(
      [](const GlFunctions& gl) {
        lit_patch(gl);
        gl.EvalMesh2(GL_FILL, 0, 7, 0, 5);
      },
      6);
}

// Texels show how its quads are split, and one colour leaves the choice to flat shading too.
TEST_F(Evaluators, RendersTexturedSurfaceUnderFlatShading) {
  compare(
      [](const GlFunctions& gl) {
        static constexpr GLfloat kCoordinates[] = {0, 0, 3, 1, 1, 4, 5, 5};
        static constexpr GLubyte kTexels[] = {255, 40, 90, 160, 40, 220, 130, 70};
        patch(gl);
        gl.Map2f(GL_MAP2_TEXTURE_COORD_2, 0, 1, 4, 2, 0, 1, 2, 2, kCoordinates);
        gl.Enable(GL_MAP2_TEXTURE_COORD_2);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                      kTexels);
        gl.Enable(GL_TEXTURE_2D);
        gl.Enable(GL_DEPTH_TEST);
        gl.ShadeModel(GL_FLAT);
        gl.EvalMesh2(GL_FILL, 0, 7, 0, 5);
      },
      6);
}

TEST_F(Evaluators, RendersGridsOfAList) {
  compare(
      [](const GlFunctions& gl) {
        gl.NewList(1, GL_COMPILE);
        patch(gl);
        gl.EvalMesh2(GL_LINE, 0, 7, 1, 5);
        gl.EndList();
        gl.CallList(1);
        gl.PointSize(3);
        gl.EvalMesh2(GL_POINT, 0, 7, 0, 0);
      },
      6);
}

}  // namespace legacy_gl::test
