// The current raster position and glBitmap (GL 2.1 spec 2.13, 3.7), beside Mesa's.
#include <gtest/gtest.h>

#include <array>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 64;
// Rows of four bytes: the initial alignment.
constexpr GLubyte kBits[8 * 4] = {0xff, 0x81, 0x81, 0x81, 0x81, 0x81, 0x81, 0xff};

struct RasterState {
  std::array<GLfloat, 4> position{}, color{}, texture{};
  GLfloat distance = -1;
  GLint valid = -1;
  GLenum error = 0;
};

RasterState read_state(const GlFunctions& gl) {
  RasterState state;
  gl.GetFloatv(GL_CURRENT_RASTER_POSITION, state.position.data());
  gl.GetFloatv(GL_CURRENT_RASTER_COLOR, state.color.data());
  gl.GetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, state.texture.data());
  gl.GetFloatv(GL_CURRENT_RASTER_DISTANCE, &state.distance);
  gl.GetIntegerv(GL_CURRENT_RASTER_POSITION_VALID, &state.valid);
  state.error = gl.GetError();
  return state;
}

void expect_equal(const RasterState& ours, const RasterState& mesa) {
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(ours.position[i], mesa.position[i], 1e-4F) << i;  // of up to 64 pixels
    EXPECT_NEAR(ours.color[i], mesa.color[i], 1e-5F) << i;
    EXPECT_NEAR(ours.texture[i], mesa.texture[i], 1e-5F) << i;
  }
  EXPECT_NEAR(ours.distance, mesa.distance, 1e-5F);
  EXPECT_EQ(ours.valid, mesa.valid);
  EXPECT_EQ(ours.error, mesa.error);
}

class RasterPosition : public testing::Test {
 protected:
  // What the calls leave, on Mesa and here.
  void compare(void (*calls)(const GlFunctions&)) {
    mesa_.recreate();
    calls(mesa_.gl);
    const RasterState mesa = read_state(mesa_.gl);
    ours_.recreate();
    calls(ours_.gl);
    expect_equal(read_state(ours_.gl), mesa);
  }

  MesaContext mesa_{kSize, kSize};
  CoreContext ours_{kSize, kSize};
};

void set_view(const GlFunctions& gl) {
  gl.MatrixMode(GL_PROJECTION);
  gl.Frustum(-1, 1, -1, 1, 1, 10);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Translatef(0.2F, 0.1F, -3);
}

void generate_texture_coordinates(const GlFunctions& gl, GLenum mode) {
  constexpr GLfloat plane[] = {0.5F, 1, 0.25F, 0.125F};
  set_view(gl);
  gl.Rotatef(30, 1, 2, 0);
  gl.Normal3f(0.6F, 0, 0.8F);
  gl.TexCoord4f(1, 2, 3, 1);
  gl.TexGenfv(GL_S, GL_OBJECT_PLANE, plane);
  gl.TexGenfv(GL_T, GL_EYE_PLANE, plane);
  gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, static_cast<GLint>(mode));
  gl.TexGeni(GL_T, GL_TEXTURE_GEN_MODE, static_cast<GLint>(mode));
  gl.Enable(GL_TEXTURE_GEN_S);
  gl.Enable(GL_TEXTURE_GEN_T);
  gl.MatrixMode(GL_TEXTURE);
  gl.Scalef(2, 3, 1);
  gl.MatrixMode(GL_MODELVIEW);
}

}  // namespace

TEST_F(RasterPosition, InitialState) {
  compare([](const GlFunctions&) {});
}

TEST_F(RasterPosition, GeneratesTextureCoordinates) {
  static GLenum mode;
  for (mode = GL_EYE_LINEAR; mode <= GL_OBJECT_LINEAR; ++mode) {
    SCOPED_TRACE(mode);
    compare([](const GlFunctions& gl) {
      generate_texture_coordinates(gl, mode);
      gl.RasterPos3f(0.3F, -0.4F, 0.5F);
    });
  }
}

// Row M17: Mesa takes another normal, though not for vertices: feedback of points is compared with
// its own in feedback_test.cpp.
TEST_F(RasterPosition, GeneratesThemAsVerticesDo) {
  for (const GLenum mode : {GLenum{GL_SPHERE_MAP}, GLenum{GL_EYE_LINEAR}}) {
    ours_.recreate();
    const GlFunctions& gl = ours_.gl;
    std::array<GLfloat, 13> fed_back{};
    generate_texture_coordinates(gl, mode);
    gl.FeedbackBuffer(static_cast<GLsizei>(fed_back.size()), GL_4D_COLOR_TEXTURE, fed_back.data());
    gl.RenderMode(GL_FEEDBACK);
    gl.Begin(GL_POINTS);
    gl.Vertex3f(0.3F, -0.4F, 0.5F);
    gl.End();
    ASSERT_EQ(gl.RenderMode(GL_RENDER), 13);
    gl.RasterPos3f(0.3F, -0.4F, 0.5F);
    const RasterState state = read_state(gl);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(state.position[i], fed_back[1 + i]) << i;
      EXPECT_EQ(state.texture[i], fed_back[9 + i]) << i;
    }
  }
}

TEST_F(RasterPosition, IsTransformed) {
  compare([](const GlFunctions& gl) {
    set_view(gl);
    gl.DepthRange(0.25, 0.5);
    gl.Viewport(5, 7, 40, 50);
    gl.RasterPos3f(0.3F, -0.4F, 0.5F);
  });
  compare([](const GlFunctions& gl) {
    set_view(gl);
    gl.RasterPos4d(0.3, -0.4, 0.5, 1.5);
  });
  compare([](const GlFunctions& gl) { gl.RasterPos2s(0, 1); });
}

TEST_F(RasterPosition, TakesCurrentValues) {
  compare([](const GlFunctions& gl) {
    set_view(gl);
    gl.MatrixMode(GL_TEXTURE);
    gl.Scalef(2, 3, 4);
    gl.TexCoord4f(1, 2, 3, 1);
    gl.Color4f(0.1F, 0.2F, 2, -1);
    gl.RasterPos2i(0, 0);
    gl.Color3f(0, 0, 0);
    gl.TexCoord2f(0, 0);
  });
}

TEST_F(RasterPosition, IsLit) {
  compare([](const GlFunctions& gl) {
    set_view(gl);
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    gl.Enable(GL_COLOR_MATERIAL);
    gl.Color4f(0.9F, 0.3F, 0.4F, 0.5F);
    gl.Normal3f(0.6F, 0, 0.8F);
    gl.RasterPos2i(0, 0);
  });
}

TEST_F(RasterPosition, IsInvalidOutsideTheViewVolume) {
  compare([](const GlFunctions& gl) {
    gl.Color3f(1, 0.5F, 0);
    gl.RasterPos2f(0.5F, 0.5F);
    gl.Color3f(0, 0.5F, 0);
    gl.RasterPos2f(1.5F, 0.5F);
    gl.Bitmap(8, 8, 0, 0, 10, 10, kBits);
  });
  compare([](const GlFunctions& gl) { gl.RasterPos3f(0, 0, -1.01F); });
}

TEST_F(RasterPosition, IsClippedByPlanes) {
  compare([](const GlFunctions& gl) {
    set_view(gl);
    constexpr GLdouble plane[] = {-1, 0, 0, 0.5};
    gl.ClipPlane(GL_CLIP_PLANE1, plane);
    gl.Enable(GL_CLIP_PLANE1);
    gl.RasterPos2f(0.4F, 0);
    gl.RasterPos2f(0.6F, 0);
  });
}

TEST_F(RasterPosition, DistanceIsTheFogCoordinate) {
  compare([](const GlFunctions& gl) {
    gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
    gl.FogCoordf(3);
    gl.RasterPos2f(0.4F, 0);
    gl.FogCoordf(4);
  });
}

TEST_F(RasterPosition, InWindowCoordinates) {
  compare([](const GlFunctions& gl) {
    gl.DepthRange(0.25, 0.5);
    gl.RasterPos2f(9, 9);
    gl.Color4f(0.1F, 2, 0.3F, 0.4F);
    gl.WindowPos3d(-20.5, 700.25, 0.5);
  });
  compare([](const GlFunctions& gl) { gl.WindowPos3f(1, 2, 5); });
}

TEST_F(RasterPosition, MovesWithBitmaps) {
  compare([](const GlFunctions& gl) {
    gl.WindowPos2i(3, 4);
    gl.Bitmap(8, 8, 2, 2, 10.5F, -3.25F, kBits);
    gl.Bitmap(0, 0, 0, 0, 1, 1, nullptr);
    gl.Bitmap(-1, 0, 0, 0, 100, 100, kBits);
  });
}

TEST_F(RasterPosition, BelongsToTheCurrentGroup) {
  compare([](const GlFunctions& gl) {
    gl.Color3f(0.5F, 0.25F, 0.75F);
    gl.RasterPos2f(0.5F, 0.25F);
    gl.PushAttrib(GL_CURRENT_BIT);
    gl.Color3f(1, 0, 0);
    gl.RasterPos2f(0, 0);
    gl.PopAttrib();
  });
}

TEST_F(RasterPosition, InListsIsThatOfTheCall) {
  compare([](const GlFunctions& gl) {
    gl.NewList(1, GL_COMPILE);
    gl.RasterPos2f(0.5F, 0.25F);
    gl.Bitmap(8, 8, 0, 0, 9, 0, kBits);
    gl.EndList();
    gl.Scalef(0.5F, 0.5F, 1);
    gl.CallList(1);
    gl.CallList(1);
    gl.Bitmap(8, 8, 0, 0, 9, 0, kBits);
  });
}

// A text of one state is one draw.
TEST_F(RasterPosition, BitmapsJoin) {
  ours_.recreate();
  const GlFunctions& gl = ours_.gl;
  gl.RasterPos2f(-1, 0);
  gl.Bitmap(8, 8, 0, 0, 9, 0, kBits);
  gl.Finish();
  legacy_gl_statistics before{}, after{};
  legacy_gl_get_statistics(&before);
  for (int i = 0; i < 200; ++i) {
    gl.RasterPos2f(-1 + 0.01F * static_cast<float>(i), 0);
    gl.Bitmap(8, 8, 0, 0, 9, 0, kBits);
  }
  gl.Finish();
  legacy_gl_get_statistics(&after);
  EXPECT_EQ(after.draws - before.draws, 1U);
  EXPECT_EQ(after.programs_compiled, before.programs_compiled);
}

}  // namespace legacy_gl::test
