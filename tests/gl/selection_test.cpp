// Selection (GL 2.1 spec 5.2), beside Mesa's.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 64;

struct Selected {
  GLint records = 0;
  std::array<GLuint, 64> buffer{};
};

Selected select(const GlFunctions& gl, void (*draw)(const GlFunctions&), GLsizei size = 64) {
  Selected selected;
  gl.SelectBuffer(size, selected.buffer.data());
  EXPECT_EQ(gl.RenderMode(GL_SELECT), 0);
  gl.InitNames();
  draw(gl);
  selected.records = gl.RenderMode(GL_RENDER);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  return selected;
}

void square(const GlFunctions& gl, float x, float z) {
  gl.Begin(GL_QUADS);
  gl.Vertex3f(x, -0.2F, z);
  gl.Vertex3f(x + 0.3F, -0.2F, z);
  gl.Vertex3f(x + 0.3F, 0.2F, z);
  gl.Vertex3f(x, 0.2F, z);
  gl.End();
}

class Selection : public testing::Test {
 protected:
  void compare(void (*draw)(const GlFunctions&), GLint records) {
    mesa_.recreate();
    const Selected mesa = select(mesa_.gl, draw);
    ours_.recreate();
    const Selected ours = select(ours_.gl, draw);
    EXPECT_EQ(mesa.records, records);
    EXPECT_EQ(ours.records, records);
    for (std::size_t at = 0; at + 3 < ours.buffer.size() && ours.buffer[at];) {
      const GLuint names = ours.buffer[at];
      ASSERT_EQ(mesa.buffer[at], names) << at;
      // Both compute depths in float, whose last place is 512 of 2^32.
      for (std::size_t i = 1; i <= 2; ++i)
        EXPECT_NEAR(static_cast<double>(ours.buffer[at + i]),
                    static_cast<double>(mesa.buffer[at + i]), 2048.0);
      for (std::size_t i = 3; i < 3 + names; ++i)
        EXPECT_EQ(ours.buffer[at + i], mesa.buffer[at + i]);
      at += 3 + names;
    }
  }

  MesaContext mesa_{kSize, kSize};
  CoreContext ours_{kSize, kSize};
};

}  // namespace

TEST_F(Selection, InitialState) {
  GLint mode = 0, depth = -1, size = -1, most = 0;
  void* pointer = this;
  ours_.gl.GetIntegerv(GL_RENDER_MODE, &mode);
  ours_.gl.GetIntegerv(GL_NAME_STACK_DEPTH, &depth);
  ours_.gl.GetIntegerv(GL_SELECTION_BUFFER_SIZE, &size);
  ours_.gl.GetIntegerv(GL_MAX_NAME_STACK_DEPTH, &most);
  ours_.gl.GetPointerv(GL_SELECTION_BUFFER_POINTER, &pointer);
  EXPECT_EQ(mode, GL_RENDER);
  EXPECT_EQ(depth, 0);
  EXPECT_EQ(size, 0);
  EXPECT_EQ(most, 64);
  EXPECT_EQ(pointer, nullptr);
}

TEST_F(Selection, RecordsWhatIsInTheViewVolume) {
  compare(
      [](const GlFunctions& gl) {
        gl.PushName(7);
        square(gl, -0.9F, 0.5F);
        gl.LoadName(8);
        square(gl, 1.5F, 0);  // outside
        gl.LoadName(9);
        square(gl, 0.9F, -0.25F);  // partly
        gl.PushName(10);
        square(gl, 0, 0);
        square(gl, 0, 0.75F);
        gl.PopName();
        gl.PopName();
        square(gl, 0, 0.1F);  // under no name
      },
      4);
}

TEST_F(Selection, OfEachPrimitive) {
  compare(
      [](const GlFunctions& gl) {
        gl.PushName(0);
        for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
          gl.LoadName(mode);
          gl.Begin(mode);
          for (int i = 0; i < 7; ++i) {
            const float turn = 0.8F * static_cast<float>(i);
            gl.Vertex3f(0.4F * std::cos(turn), 0.5F * std::sin(turn), 0.1F * turn - 0.2F);
          }
          gl.End();
        }
      },
      10);
}

TEST_F(Selection, InPerspectiveWithClippedDepths) {
  compare(
      [](const GlFunctions& gl) {
        gl.MatrixMode(GL_PROJECTION);
        gl.Frustum(-0.1, 0.1, -0.1, 0.1, 1, 4);
        gl.MatrixMode(GL_MODELVIEW);
        gl.DepthRange(0.2, 0.8);
        gl.PushName(1);
        gl.Begin(GL_LINES);
        gl.Vertex3f(0, 0, -0.5F);
        gl.Vertex3f(0, 0.01F, -9);
        gl.End();
        gl.LoadName(2);
        gl.Begin(GL_TRIANGLES);
        gl.Vertex3f(-9, 0, -2);
        gl.Vertex3f(9, 0, -3);
        gl.Vertex3f(0, 9, -2);
        gl.End();
      },
      2);
}

TEST_F(Selection, LeavesCulledPolygonsOut) {
  compare(
      [](const GlFunctions& gl) {
        gl.Enable(GL_CULL_FACE);
        gl.PushName(1);
        square(gl, 0, 0);
        gl.LoadName(2);
        gl.FrontFace(GL_CW);
        square(gl, 0, 0);
        gl.LoadName(3);
        gl.CullFace(GL_FRONT);
        square(gl, 0, 0);
      },
      2);
}

TEST_F(Selection, HeedsClipPlanes) {
  compare(
      [](const GlFunctions& gl) {
        constexpr GLdouble plane[] = {1, 0, 0, -0.1};
        gl.ClipPlane(GL_CLIP_PLANE2, plane);
        gl.Enable(GL_CLIP_PLANE2);
        gl.PushName(1);
        square(gl, -0.3F, 0);
        gl.LoadName(2);
        square(gl, 0, 0.5F);
      },
      1);
}

TEST_F(Selection, OfListsAndArrays) {
  compare(
      [](const GlFunctions& gl) {
        gl.NewList(1, GL_COMPILE);
        gl.LoadName(5);
        square(gl, 0, 0.2F);
        gl.PushName(6);
        square(gl, -0.5F, 0.3F);
        gl.PopName();
        gl.EndList();
        gl.PushName(0);
        gl.CallList(1);
        static constexpr GLfloat vertices[] = {0, 0, 0.5F, 0, 0, 0.5F};
        gl.LoadName(7);
        gl.EnableClientState(GL_VERTEX_ARRAY);
        gl.VertexPointer(2, GL_FLOAT, 0, vertices);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
      },
      3);
}

TEST_F(Selection, RasterPositionsHit) {
  compare(
      [](const GlFunctions& gl) {
        gl.PushName(3);
        gl.RasterPos3f(0, 0, 0.5F);
        gl.LoadName(4);
        gl.RasterPos3f(0, 2, 0.5F);
      },
      1);
}

TEST_F(Selection, OverflowIsMinusOne) {
  const auto draw = [](const GlFunctions& gl) {
    gl.PushName(3);
    square(gl, 0, 0.5F);
    gl.LoadName(4);
    square(gl, 0, 0.5F);
  };
  for (const GlFunctions* gl : {&mesa_.gl, &ours_.gl}) {
    gl == &mesa_.gl ? mesa_.recreate() : ours_.recreate();
    const Selected selected = select(*gl, draw, 6);
    EXPECT_EQ(selected.records, -1);
    EXPECT_EQ(selected.buffer[3], 3U);
    EXPECT_EQ(selected.buffer[6], 0U);
  }
}

TEST_F(Selection, DrawsAndClearsNothing) {
  ours_.recreate();
  const GlFunctions& gl = ours_.gl;
  gl.Rectf(-1, -1, 1, 1);
  const Image before = ours_.read();
  ours_.make_current();
  select(gl, [](const GlFunctions& g) {
    g.ClearColor(1, 0, 0, 1);
    g.Clear(GL_COLOR_BUFFER_BIT);
    g.Color3f(0, 1, 0);
    square(g, 0, 0);
    constexpr GLubyte bits[] = {0xff, 0xff, 0xff, 0xff};
    g.RasterPos2f(0, 0);
    g.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    g.Bitmap(8, 4, 0, 0, 0, 0, bits);
  });
  EXPECT_TRUE(legacy_gl::test::compare(before, ours_.read()).identical());
}

}  // namespace legacy_gl::test
