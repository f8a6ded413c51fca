// Wide lines where the driver refuses them, as forward-compatible contexts do (GL 2.1 spec 3.4.2),
// beside Mesa's.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 96;

using GetIntegerv = void (*)(GLenum, GLint*);
using LineWidth = void (*)(GLfloat);

template <typename Function>
Function driver(const char* name) {
  return reinterpret_cast<Function>(CoreContext::driver_proc(name));
}

void tell_forward_compatible(GLenum name, GLint* values) {
  driver<GetIntegerv>("glGetIntegerv")(name, values);
  if (name == 0x821E) *values |= 1;  // GL_CONTEXT_FLAGS
}

int wide_lines_asked_for = 0;
void refuse_wide_lines(GLfloat width) {
  if (width > 1) ++wide_lines_asked_for;
  driver<LineWidth>("glLineWidth")(std::fmin(width, 1.0F));
}

/// The driver is never done with what it reads: streams take new memory.
GLenum wait_in_vain(void*, GLbitfield, std::uint64_t) { return 0x911B; }  // GL_TIMEOUT_EXPIRED

legacy_gl_proc forward_compatible(const char* name) {
  if (!std::strcmp(name, "glClientWaitSync")) return reinterpret_cast<legacy_gl_proc>(wait_in_vain);
  if (!std::strcmp(name, "glGetIntegerv"))
    return reinterpret_cast<legacy_gl_proc>(tell_forward_compatible);
  if (!std::strcmp(name, "glLineWidth")) return reinterpret_cast<legacy_gl_proc>(refuse_wide_lines);
  return CoreContext::driver_proc(name);
}

using Draw = void (*)(const GlFunctions&);

Image picture(RenderContext& context, Draw draw) {
  const GlFunctions& gl = context.gl;
  gl.Viewport(0, 0, kSize, kSize);
  gl.ClearColor(0.2F, 0.2F, 0.2F, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  draw(gl);
  gl.Finish();
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  return context.read_rgba8();
}

class WideLines : public testing::Test {
 protected:
  /// How many pixels differ by more than a step.
  void compare(Draw draw, int allowed = 0) {
    mesa_.make_current();
    const Image expected = picture(mesa_, draw);
    ours_.make_current();
    legacy_gl_options options{};
    options.programs = LEGACY_GL_PROGRAMS_SPECIALISED;
    legacy_gl_context* const context =
        legacy_gl_create_context(forward_compatible, &options, nullptr);
    ASSERT_NE(context, nullptr);
    legacy_gl_make_current(context);
    wide_lines_asked_for = 0;
    const Image image = picture(ours_, draw);
    EXPECT_EQ(wide_lines_asked_for, 0);
    legacy_gl_destroy_context(context);
    int different = 0, drawn = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const std::size_t at =
            (static_cast<std::size_t>(y) * kSize + static_cast<std::size_t>(x)) * 4;
        bool same = true;
        for (std::size_t c = at; c < at + 3; ++c)
          same = same && std::abs(int{expected.bytes[c]} - int{image.bytes[c]}) <= 1;
        different += !same;
        drawn += expected.bytes[at + 1] != 51;
      }
    EXPECT_GT(drawn, 50);
    EXPECT_LE(different, allowed) << "of " << drawn << " pixels drawn";
  }

  MesaContext mesa_{kSize, kSize};
  CoreContext ours_{kSize, kSize};
};

template <int Tenths>
void star(const GlFunctions& gl) {
  gl.LineWidth(static_cast<float>(Tenths) / 10);
  gl.Begin(GL_LINES);
  for (int i = 0; i < 15; ++i) {
    const float angle = 0.1F + 0.41887902F * static_cast<float>(i);
    gl.Color3f(1, 0.3F + 0.04F * static_cast<float>(i), 0);
    gl.Vertex2f(0.35F * std::cos(angle), 0.35F * std::sin(angle));
    gl.Vertex2f(0.9F * std::cos(angle), 0.9F * std::sin(angle));
  }
  gl.End();
}

void bent(const GlFunctions& gl, GLenum mode) {
  gl.Begin(mode);
  gl.Color3f(1, 1, 0);
  for (int i = 0; i < 5; ++i)
    gl.Vertex2f(0.7F * std::cos(1.3F * static_cast<float>(i)),
                0.7F * std::sin(1.3F * static_cast<float>(i)));
  gl.End();
}

}  // namespace

// Even widths move a line by half a pixel. The specification asks then which diamonds the ends
// leave (GL 2.1 spec 3.4.1, 3.4.2), Mesa before: an end may have a column more or less. So may at
// most one of the two ends of a line.
constexpr int kLines = 15;

TEST_F(WideLines, OfEachWidth) {
  compare(star<20>, kLines * 2);
  compare(star<30>);
  compare(star<40>, kLines * 4);
  compare(star<70>);
}

TEST_F(WideLines, WidthsAreRounded) {
  compare(star<14>);
  compare(star<16>, kLines * 2);
  compare(star<34>);
}

TEST_F(WideLines, StripsAndLoops) {
  compare([](const GlFunctions& gl) {
    gl.LineWidth(3);
    bent(gl, GL_LINE_STRIP);
  });
  compare(
      [](const GlFunctions& gl) {
        gl.LineWidth(2);
        bent(gl, GL_LINE_LOOP);
      },
      5 * 2);
}

TEST_F(WideLines, Stippled) {
  compare([](const GlFunctions& gl) {
    gl.LineStipple(3, 0x1c4f);
    gl.Enable(GL_LINE_STIPPLE);
    gl.LineWidth(3);
    bent(gl, GL_LINE_STRIP);
    gl.Scalef(0.4F, 0.4F, 1);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    bent(gl, GL_POLYGON);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl.LoadIdentity();
    gl.Disable(GL_LINE_STIPPLE);
  });
}

TEST_F(WideLines, UnfilledPolygons) {
  compare([](const GlFunctions& gl) {
    gl.LineWidth(3);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    bent(gl, GL_POLYGON);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  });
}

TEST_F(WideLines, OfListsAndArraysAmongPolygons) {
  compare([](const GlFunctions& gl) {
    static constexpr GLfloat kVertices[] = {-0.9F, -0.8F, 0.9F, -0.7F, 0.8F, 0.9F};
    gl.LineWidth(5);
    gl.NewList(1, GL_COMPILE);
    bent(gl, GL_LINES);
    gl.EndList();
    gl.Color3f(0, 1, 1);
    gl.Rectf(-0.3F, -0.3F, 0.3F, 0.3F);
    gl.CallList(1);
    gl.DeleteLists(1, 1);
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(2, GL_FLOAT, 0, kVertices);
    gl.DrawArrays(GL_LINE_STRIP, 0, 3);
    gl.DisableClientState(GL_VERTEX_ARRAY);
  });
}

TEST_F(WideLines, InPerspectiveAcrossTheNearPlane) {
  compare(
      [](const GlFunctions& gl) {
        gl.MatrixMode(GL_PROJECTION);
        gl.LoadIdentity();
        gl.Frustum(-0.5, 0.5, -0.5, 0.5, 1, 9);
        gl.MatrixMode(GL_MODELVIEW);
        gl.LineWidth(4);
        gl.Begin(GL_LINES);
        gl.Color3f(1, 1, 1);
        gl.Vertex3f(-0.4F, -0.2F, -0.5F);
        gl.Vertex3f(0.3F, 0.4F, -4);
        gl.Vertex3f(0.2F, -0.9F, -3);
        gl.Vertex3f(0.4F, 0.6F, -2);
        gl.End();
        gl.MatrixMode(GL_PROJECTION);
        gl.LoadIdentity();
        gl.MatrixMode(GL_MODELVIEW);
      },
      // Where a line leaves the view its ends are a corner: Mesa clips it first, and the driver
      // here each of the thin lines.
      8);
}

// More than the stream of vertices holds; each batch has lines to widen and vertices as they are.
TEST_F(WideLines, BesidePolygonsInManyBatches) {
  compare([](const GlFunctions& gl) {
    gl.LineWidth(9);
    gl.PolygonMode(GL_BACK, GL_LINE);
    for (int i = 0; i < 40; ++i) {
      const float x = 0.04F * static_cast<float>(i) - 0.9F;
      gl.Color3f(1, 0.02F * static_cast<float>(i), 0.5F);
      gl.Rectf(x, -0.9F, x + 0.04F, 0.3F);
      gl.Begin(GL_LINES);
      for (int line = 0; line < 3000; ++line) {
        gl.Vertex2f(x, 0.7F);
        gl.Vertex2f(x + 0.04F, 0.7F);
      }
      gl.End();
      gl.Flush();
    }
    gl.PolygonMode(GL_BACK, GL_FILL);
  });
}

}  // namespace legacy_gl::test
