// Of a large closed list only the triangles that are seen are drawn; Mesa's fixed function says
// that the picture is the same, also where none may be left out.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "support/contexts.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {
namespace {

using Change = void (*)(const GlFunctions& gl);
using Color = std::array<float, 4>;

constexpr int kSize = 96;
constexpr int kSlices = 60, kStacks = 40;

void draw_ball(const GlFunctions& gl, int stacks) {
  for (int stack = 0; stack < stacks; ++stack) {
    gl.Begin(GL_QUAD_STRIP);
    for (int slice = 0; slice <= kSlices; ++slice)
      for (const int row : {stack, stack + 1}) {
        const float b = std::numbers::pi_v<float> * (static_cast<float>(row) / kStacks - 0.5F);
        const float a = 2 * std::numbers::pi_v<float> * static_cast<float>(slice) / kSlices;
        const float x = std::cos(b) * std::cos(a), y = std::sin(b), z = std::cos(b) * std::sin(a);
        gl.Color3f(0.5F + 0.5F * x, 0.5F + 0.5F * y, 0.5F + 0.5F * z);
        gl.TexCoord2f(a, b);
        gl.Normal3f(x, y, z);
        gl.Vertex3f(x, y, z);
      }
    gl.End();
  }
}

void set_up(const GlFunctions& gl) {
  gl.MatrixMode(GL_PROJECTION);
  gl.Frustum(-0.4, 0.4, -0.4, 0.4, 1, 20);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Translatef(0, 0, -4);
  gl.Rotatef(50, 1, 0.5F, 0.2F);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  const Color front{0.8F, 0.4F, 0.1F, 0.6F}, back{0.1F, 0.9F, 0.5F, 0.6F};
  gl.Materialfv(GL_FRONT, GL_DIFFUSE, front.data());
  gl.Materialfv(GL_BACK, GL_DIFFUSE, back.data());
  gl.NewList(1, GL_COMPILE);
  draw_ball(gl, kStacks);
  gl.EndList();
  gl.NewList(2, GL_COMPILE);
  draw_ball(gl, kStacks - 5);
  gl.EndList();
}

class ClosedSurfaces : public testing::Test {
 protected:
  ClosedSurfaces() : mesa(kSize, kSize), ours(kSize, kSize) { change(set_up); }

  void change(Change what) {
    for (RenderContext* context :
         {static_cast<RenderContext*>(&mesa), static_cast<RenderContext*>(&ours)}) {
      context->make_current();
      what(context->gl);
    }
  }

  static void frame(const GlFunctions& gl, GLuint list) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.CallList(list);
  }

  // Triangles left out of the fifth frame; its picture is Mesa's.
  std::uint64_t unseen(GLuint list = 1) {
    mesa.make_current();
    frame(mesa.gl, list);
    const Image expected = mesa.read_rgba8();
    EXPECT_GT(covered_pixels(expected), 500);
    ours.make_current();
    for (int i = 0; i < 4; ++i) frame(ours.gl, list);
    legacy_gl_flush();
    legacy_gl_reset_statistics();
    frame(ours.gl, list);
    EXPECT_TRUE(images_match(ours.read_rgba8(), expected, {.max_difference_steps = 1}, "closed"));
    EXPECT_EQ(ours.gl.GetError(), GLenum{GL_NO_ERROR});
    legacy_gl_statistics statistics;
    legacy_gl_get_statistics(&statistics);
    return statistics.triangles_unseen;
  }

  std::uint64_t unseen_after(Change what) {
    change(what);
    return unseen();
  }

  MesaContext mesa;
  CoreContext ours;
};

constexpr std::uint64_t kTriangles = std::uint64_t{2} * kSlices * kStacks;

TEST_F(ClosedSurfaces, NearlyHalfOfTheTrianglesAreNotDrawn) {
  const std::uint64_t count = unseen();
  EXPECT_GT(count, kTriangles * 2 / 5);
  EXPECT_LT(count, kTriangles * 4 / 5);
}

TEST_F(ClosedSurfaces, AnotherViewHasOtherTriangles) {
  unseen();
  EXPECT_GT(unseen_after([](const GlFunctions& gl) { gl.Rotatef(90, 0, 1, 0.3F); }),
            kTriangles / 3);
  EXPECT_GT(unseen_after([](const GlFunctions& gl) { gl.Translatef(0.9F, 0.3F, 0.3F); }),
            kTriangles / 3);
  EXPECT_GT(unseen_after([](const GlFunctions& gl) { gl.Scalef(1, -1, 1); }), kTriangles / 3);
  EXPECT_GT(unseen_after([](const GlFunctions& gl) { gl.Scalef(-0.5F, 1, 2); }), kTriangles / 3);
  EXPECT_GT(unseen_after([](const GlFunctions& gl) { gl.Viewport(10, 5, 200, 60); }),
            kTriangles / 3);
  EXPECT_GT(unseen_after([](const GlFunctions& gl) { gl.FrontFace(GL_CW); }), kTriangles / 3);
  EXPECT_GT(unseen_after([](const GlFunctions& gl) { gl.DepthFunc(GL_LEQUAL); }), kTriangles / 3);
}

TEST_F(ClosedSurfaces, TwoSidesFlatShadingAndColoursAreAsTheyWere) {
  EXPECT_GT(unseen_after([](const GlFunctions& gl) { gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); }),
            kTriangles / 3);
  EXPECT_GT(unseen_after([](const GlFunctions& gl) { gl.ShadeModel(GL_FLAT); }), kTriangles / 3);
  EXPECT_GT(unseen_after([](const GlFunctions& gl) { gl.Disable(GL_LIGHTING); }), kTriangles / 3);
}

TEST_F(ClosedSurfaces, AnOpenOneIsDrawnWhole) { EXPECT_EQ(unseen(2), 0u); }

TEST_F(ClosedSurfaces, CutByTheNearPlaneItIsDrawnWhole) {
  EXPECT_EQ(unseen_after([](const GlFunctions& gl) {
              gl.LoadIdentity();
              gl.Translatef(0, 0, -1.5F);
            }),
            0u);
}

// Everything that lets the far side be seen, or that counts its samples.
TEST_F(ClosedSurfaces, WhereTheFarSideMattersItIsDrawn) {
  struct Case {
    const char* name;
    Change set, reset;
  };
  const Case cases[] = {
      {"blending",
       [](const GlFunctions& gl) {
         gl.Enable(GL_BLEND);
         gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
       },
       [](const GlFunctions& gl) { gl.Disable(GL_BLEND); }},
      {"no depth test", [](const GlFunctions& gl) { gl.Disable(GL_DEPTH_TEST); },
       [](const GlFunctions& gl) { gl.Enable(GL_DEPTH_TEST); }},
      {"the farthest wins",
       [](const GlFunctions& gl) {
         gl.DepthFunc(GL_GREATER);
         gl.ClearDepth(0);
       },
       [](const GlFunctions& gl) {
         gl.DepthFunc(GL_LESS);
         gl.ClearDepth(1);
       }},
      {"a depth range upside down", [](const GlFunctions& gl) { gl.DepthRange(1, 0); },
       [](const GlFunctions& gl) { gl.DepthRange(0, 1); }},
      {"no depth writes",
       [](const GlFunctions& gl) {
         gl.Clear(GL_DEPTH_BUFFER_BIT);
         gl.DepthMask(0);
       },

       [](const GlFunctions& gl) { gl.DepthMask(1); }},
      {"alpha test",
       [](const GlFunctions& gl) {
         gl.Disable(GL_LIGHTING);
         gl.Enable(GL_ALPHA_TEST);
         gl.AlphaFunc(GL_GREATER, 0.5F);
       },
       [](const GlFunctions& gl) {
         gl.Enable(GL_LIGHTING);
         gl.Disable(GL_ALPHA_TEST);
       }},
      {"stencil test",
       [](const GlFunctions& gl) {
         gl.Enable(GL_STENCIL_TEST);
         gl.StencilOp(GL_KEEP, GL_INCR, GL_INCR);
       },
       [](const GlFunctions& gl) { gl.Disable(GL_STENCIL_TEST); }},
      {"a clip plane",
       [](const GlFunctions& gl) {
         const double plane[] = {0.3, 0.5, 1, 0};
         gl.ClipPlane(GL_CLIP_PLANE0, plane);
         gl.Enable(GL_CLIP_PLANE0);
       },
       [](const GlFunctions& gl) { gl.Disable(GL_CLIP_PLANE0); }},
      {"lines", [](const GlFunctions& gl) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); },
       [](const GlFunctions& gl) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL); }},
      {"culling of what is seen",
       [](const GlFunctions& gl) {
         gl.Enable(GL_CULL_FACE);
         gl.CullFace(GL_FRONT);
       },
       [](const GlFunctions& gl) { gl.Disable(GL_CULL_FACE); }},
      {"polygon stipple",
       [](const GlFunctions& gl) {
         std::array<GLubyte, 128> mask{};
         for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = i / 4 % 2 == 0 ? 0x55 : 0xaa;
         gl.PolygonStipple(mask.data());
         gl.Enable(GL_POLYGON_STIPPLE);
       },
       [](const GlFunctions& gl) { gl.Disable(GL_POLYGON_STIPPLE); }},
      {"logic operation",
       [](const GlFunctions& gl) {
         gl.Enable(GL_COLOR_LOGIC_OP);
         gl.LogicOp(GL_OR);
       },
       [](const GlFunctions& gl) { gl.Disable(GL_COLOR_LOGIC_OP); }},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(one.name);
    EXPECT_EQ(unseen_after(one.set), 0u);
    EXPECT_GT(unseen_after(one.reset), 0u);
  }
}

TEST_F(ClosedSurfaces, AQueryCountsAllSamples) {
  unseen();
  const auto passed = [](RenderContext& context) {
    context.make_current();
    GLuint samples = 0;
    context.gl.BeginQuery(GL_SAMPLES_PASSED, 7);
    frame(context.gl, 1);
    context.gl.EndQuery(GL_SAMPLES_PASSED);
    context.gl.GetQueryObjectuiv(7, GL_QUERY_RESULT, &samples);
    return samples;
  };
  const GLuint expected = passed(mesa);
  EXPECT_GT(expected, 1000u);
  EXPECT_EQ(passed(ours), expected);
}

TEST_F(ClosedSurfaces, AListThatIsMadeAnewIsLookedAtAnew) {
  EXPECT_GT(unseen(), 0u);
  change([](const GlFunctions& gl) {
    gl.NewList(1, GL_COMPILE);
    draw_ball(gl, kStacks - 7);
    gl.EndList();
  });
  EXPECT_EQ(unseen(), 0u);
}

TEST(ClosedSurfacesOption, KeepsUnseenTriangles) {
  legacy_gl_options options{};
  options.keep_unseen_triangles = 1;
  CoreContext context(kSize, kSize, PixelFormat::rgba8, options);
  set_up(context.gl);
  for (int i = 0; i < 5; ++i) context.gl.CallList(1);
  legacy_gl_flush();
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  EXPECT_EQ(statistics.triangles_unseen, 0u);
  EXPECT_GT(statistics.vertices, 0u);
}

}  // namespace
}  // namespace legacy_gl::test
