// What a scene does not need leaves no trace in programs and uploads: the counters prove it.
#include <gtest/gtest.h>

#include <array>

#include "scene_changes.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {
namespace {

class Skipping : public testing::Test {
 protected:
  Skipping() : context(64, 64), gl(context.gl) { set_up_scene(gl); }

  legacy_gl_statistics draw() {
    legacy_gl_reset_statistics();
    draw_scene(gl);
    legacy_gl_flush();
    legacy_gl_statistics statistics;
    legacy_gl_get_statistics(&statistics);
    return statistics;
  }

  CoreContext context;
  const GlFunctions& gl;
};

TEST_F(Skipping, TheSameSceneAgainCompilesAndUploadsNoState) {
  EXPECT_GT(draw().programs_compiled, 0u);
  const legacy_gl_statistics second = draw();
  EXPECT_EQ(second.programs_generated, 0u);
  EXPECT_EQ(second.uniform_bytes_uploaded, 0u);
  EXPECT_EQ(second.normal_matrix_updates, 0u);
}

TEST_F(Skipping, LightsThatAreOffMakeNoProgramAndNoUpload) {
  draw();
  const float red[] = {1, 0, 0, 1};
  gl.Lightfv(GL_LIGHT3, GL_DIFFUSE, red);
  gl.Lightf(GL_LIGHT3, GL_SPOT_CUTOFF, 20);
  const legacy_gl_statistics second = draw();
  EXPECT_EQ(second.programs_generated, 0u);
}

TEST_F(Skipping, WithLightingOffLightStateMakesNoProgram) {
  gl.Disable(GL_LIGHTING);
  draw();
  gl.Enable(GL_LIGHT3);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  gl.Enable(GL_NORMALIZE);
  gl.ColorMaterial(GL_FRONT, GL_EMISSION);
  gl.Materialf(GL_FRONT, GL_SHININESS, 77);
  const legacy_gl_statistics second = draw();
  EXPECT_EQ(second.programs_generated, 0u);
}

TEST_F(Skipping, WhichLightIsOnMakesNoProgram) {
  const float white[] = {1, 1, 1, 1};
  for (GLenum light = GL_LIGHT1; light <= GL_LIGHT7; ++light) {
    gl.Lightfv(light, GL_DIFFUSE, white);
    gl.Lightfv(light, GL_SPECULAR, white);
  }
  draw();
  for (GLenum light = GL_LIGHT1; light <= GL_LIGHT7; ++light) {
    gl.Disable(light - 1);
    gl.Enable(light);
    EXPECT_EQ(draw().programs_generated, 0u) << "GL_LIGHT" << light - GL_LIGHT0;
  }
}

TEST_F(Skipping, BlackLightsAreLeftOut) {
  draw();
  const float black[] = {0, 0, 0, 1};
  for (GLenum light = GL_LIGHT1; light <= GL_LIGHT7; ++light) {
    gl.Lightfv(light, GL_DIFFUSE, black);
    gl.Lightfv(light, GL_SPECULAR, black);
    gl.Enable(light);
  }
  const legacy_gl_statistics second = draw();
  EXPECT_EQ(second.programs_generated, 0u);
  EXPECT_EQ(second.lights_skipped, 7u);
}

// Integer shininess is part of a program's text, but not without end.
TEST_F(Skipping, AnAnimatedShininessStopsCompiling) {
  const std::uint64_t of_a_scene = draw().programs_compiled;
  std::uint64_t compiled = 0;
  for (int shininess = 0; shininess <= 128; ++shininess) {
    gl.Materiali(GL_FRONT_AND_BACK, GL_SHININESS, shininess);
    compiled += draw().programs_compiled;
  }
  EXPECT_LE(compiled, 17 * of_a_scene);
  for (int shininess = 0; shininess <= 128; ++shininess) {
    gl.Materiali(GL_FRONT_AND_BACK, GL_SHININESS, shininess);
    EXPECT_EQ(draw().programs_compiled, 0u) << "shininess " << shininess;
  }
}

TEST_F(Skipping, ATranslationKeepsTheNormalMatrix) {
  gl.Scalef(1, 2, 3);
  draw();
  gl.Translatef(0.1f, 0.2f, 0.3f);
  const legacy_gl_statistics second = draw();
  EXPECT_EQ(second.normal_matrix_updates, 0u);
  EXPECT_GT(second.uniform_bytes_uploaded, 0u);
}

TEST_F(Skipping, AMaterialChangeLeavesLightsAndTransform) {
  draw();
  const float green[] = {0, 1, 0, 1};
  gl.Materialfv(GL_FRONT, GL_DIFFUSE, green);
  EXPECT_EQ(draw().uniform_block_updates, 1u);
}

TEST_F(Skipping, SettingAValueToItselfIsNoChange) {
  draw();
  set_up_scene(gl);
  gl.Begin(GL_POINTS);
  gl.End();
  legacy_gl_reset_statistics();
  const float specular[] = {0.6f, 0.5f, 0.4f, 0.75f};
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
  gl.ShadeModel(GL_SMOOTH);
  gl.Enable(GL_LIGHTING);
  draw_scene(gl);
  legacy_gl_flush();
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  EXPECT_EQ(statistics.programs_generated, 0u);
}

TEST_F(Skipping, TextureCoordinatesThatNobodyReadsAreNotUploaded) {
  const std::uint64_t before = draw().vertex_bytes_uploaded;
  legacy_gl_reset_statistics();
  gl.TexCoord2f(0.5f, 0.5f);
  EXPECT_EQ(draw().vertex_bytes_uploaded, before);
}

TEST_F(Skipping, NeutralBeginEndPairsMerge) {
  draw();
  legacy_gl_reset_statistics();
  for (int i = 0; i < 100; ++i) {
    gl.Begin(GL_TRIANGLES);
    for (int corner = 0; corner < 3; ++corner)
      gl.Vertex3f(static_cast<float>(corner == 1), static_cast<float>(corner == 2), 0);
    gl.End();
  }
  legacy_gl_flush();
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  EXPECT_EQ(statistics.begin_end_merged, 99u);
  EXPECT_EQ(statistics.draws, 1u);
}

TEST_F(Skipping, WhatIsOutsideOfTheViewIsNotDrawn) {
  draw();
  const Image before = context.read_rgba8();
  legacy_gl_reset_statistics();
  gl.Begin(GL_TRIANGLES);
  for (int corner = 0; corner < 3; ++corner)
    gl.Vertex3f(static_cast<float>(corner == 1), static_cast<float>(corner == 2), 1000);
  gl.End();
  EXPECT_EQ(context.read_rgba8().bytes, before.bytes);
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  EXPECT_EQ(statistics.primitives_clipped, 1u);
  EXPECT_EQ(statistics.draws, 0u);
  EXPECT_EQ(statistics.vertex_bytes_uploaded, 0u);
}

TEST_F(Skipping, WhatCrossesTheViewIsDrawn) {
  draw();
  legacy_gl_reset_statistics();
  gl.Begin(GL_TRIANGLES);  // every corner outside, each beyond another plane
  gl.Vertex3f(-1000, -1000, 0);
  gl.Vertex3f(1000, -1000, 0);
  gl.Vertex3f(0, 1000, 0);
  gl.End();
  legacy_gl_flush();
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  EXPECT_EQ(statistics.primitives_clipped, 0u);
  EXPECT_EQ(statistics.draws, 1u);
}

// Its program is the polygons' own; a pattern that is off costs nothing.
TEST_F(Skipping, APolygonStippleConcernsPolygonsAlone) {
  draw();
  const std::array<GLubyte, 128> mask{0x0f};
  gl.PolygonStipple(mask.data());
  const legacy_gl_statistics off = draw();
  EXPECT_EQ(off.programs_generated, 0u);
  EXPECT_EQ(off.uniform_bytes_uploaded, 0u);
  gl.Enable(GL_POLYGON_STIPPLE);
  legacy_gl_reset_statistics();
  gl.Begin(GL_LINES);
  gl.Vertex3f(-1, 0, 0);
  gl.Vertex3f(1, 0, 0);
  gl.End();
  gl.Begin(GL_POINTS);
  gl.Vertex3f(0, 0, 0);
  gl.End();
  legacy_gl_flush();
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  EXPECT_EQ(statistics.draws, 2u);
  EXPECT_EQ(statistics.programs_generated, 0u);
  EXPECT_GT(draw().programs_generated, 0u);
  EXPECT_EQ(draw().uniform_bytes_uploaded, 0u);
}

// Patterns of lines make no program; that of smooth points is the points' own.
TEST_F(Skipping, LineStippleMakesNoProgramAndSmoothPointsOne) {
  draw();
  gl.LineStipple(2, 0x1234);
  EXPECT_EQ(draw().uniform_bytes_uploaded, 0u);
  gl.Enable(GL_LINE_STIPPLE);
  const legacy_gl_statistics stippled = draw();
  EXPECT_EQ(stippled.programs_generated, 0u);
  EXPECT_EQ(stippled.uniform_bytes_uploaded, 0u);
  gl.Disable(GL_LINE_STIPPLE);
  gl.Enable(GL_POINT_SMOOTH);
  EXPECT_EQ(draw().programs_generated, 1u);
}

TEST_F(Skipping, MatricesThatAreNotDrawnWithAreNotDerivedFrom) {
  draw();
  const Image before = context.read_rgba8();
  for (int i = 0; i < 10; ++i) {
    gl.PushMatrix();
    gl.Rotatef(static_cast<float>(i), 1, 2, 3);
    gl.Scalef(1, 2, 3);
    gl.PopMatrix();
  }
  EXPECT_EQ(draw().normal_matrix_updates, 0u);
  EXPECT_EQ(context.read_rgba8().bytes, before.bytes);
}

}  // namespace
}  // namespace legacy_gl::test
