// Lists as meshes: what is welded, and that the picture and the current values are those of the
// calls.
#include <gtest/gtest.h>

#include <cmath>

#include "scene_changes.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {
namespace {

void draw_grid(const GlFunctions& gl, GLenum mode) {
  const auto vertex = [&](int column, int row) {
    const float u = static_cast<float>(column) / 12, v = static_cast<float>(row) / 12;
    gl.Normal3f(std::sin(u), v - 0.5f, std::cos(u));
    gl.Vertex3f(2 * u - 1, 2 * v - 1, 0);
  };
  gl.Begin(mode);
  for (int row = 0; row < 12; ++row)
    for (int column = 0; column < 12; ++column) {
      vertex(column, row);
      vertex(column + 1, row);
      vertex(column + 1, row + 1);
      vertex(column, row + 1);
    }
  gl.End();
}

legacy_gl_statistics counted() {
  legacy_gl_flush();
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  legacy_gl_reset_statistics();
  return statistics;
}

class Lists : public testing::Test {
 protected:
  Lists() : context(64, 64), gl(context.gl) {
    set_up_scene(gl);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    legacy_gl_reset_statistics();
  }
  CoreContext context;
  const GlFunctions& gl;
};

TEST_F(Lists, VerticesThatAreAlikeAreKeptOnce) {
  gl.NewList(1, GL_COMPILE);
  draw_grid(gl, GL_QUADS);
  gl.EndList();
  gl.CallList(1);
  const legacy_gl_statistics first = counted();
  EXPECT_EQ(first.list_vertices_welded, 576u - 169u);
  EXPECT_EQ(first.vertices, 169u);
  EXPECT_EQ(first.draws, 1u);
  gl.CallList(1);
  EXPECT_EQ(counted().vertex_bytes_uploaded, 0u);
}

TEST_F(Lists, NeighbouringPairsJoinInOneDraw) {
  gl.NewList(1, GL_COMPILE);
  for (int i = 0; i < 10; ++i) draw_grid(gl, GL_QUADS);
  gl.EndList();
  gl.CallList(1);
  EXPECT_EQ(counted().draws, 1u);
}

TEST_F(Lists, TheCurrentValuesAfterwardsAreTheLastOnes) {
  gl.NewList(1, GL_COMPILE);
  gl.Color3f(1, 0, 0);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) {
    gl.Color4f(0.1f * static_cast<float>(i), 0.5f, 0.25f, 0.75f);
    gl.TexCoord2f(static_cast<float>(i), 3);
    gl.Vertex3f(static_cast<float>(i), 0, 0);
  }
  gl.Normal3f(0, 1, 0);
  gl.End();
  gl.EndList();
  gl.CallList(1);
  float color[4], normal[3], texture_coordinates[4];
  gl.GetFloatv(GL_CURRENT_COLOR, color);
  gl.GetFloatv(GL_CURRENT_NORMAL, normal);
  gl.GetFloatv(GL_CURRENT_TEXTURE_COORDS, texture_coordinates);
  EXPECT_EQ(color[0], 0.1f * 2.0f);
  EXPECT_EQ(color[3], 0.75f);
  EXPECT_EQ(normal[1], 1.0f);
  EXPECT_EQ(texture_coordinates[0], 2.0f);
}

TEST_F(Lists, WhatTheListDoesNotSayIsTheCallersCurrentValue) {
  gl.Disable(GL_LIGHTING);
  gl.LoadIdentity();
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.NewList(1, GL_COMPILE);
  gl.Rectf(-1, -1, 1, 1);
  gl.Begin(GL_QUADS);
  for (const auto& [x, y] : {std::pair{-1.f, -1.f}, {1.f, -1.f}, {1.f, 1.f}, {-1.f, 1.f}})
    gl.Vertex2f(x, y);
  gl.End();
  gl.EndList();
  for (const float green : {1.0f, 0.0f}) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Color3f(1, green, 0);
    gl.CallList(1);
    EXPECT_EQ(context.read_rgba8().bytes[1], green * 255);
  }
}

TEST_F(Lists, AListThatIsReplacedOrDeletedDrawsNoMore) {
  const auto center_red = [&] { return context.read_rgba8().bytes[4 * (32 * 64 + 32)]; };
  gl.NewList(1, GL_COMPILE);
  draw_grid(gl, GL_QUADS);
  gl.EndList();
  gl.CallList(1);
  EXPECT_GT(center_red(), 0);
  gl.NewList(1, GL_COMPILE);
  gl.EndList();
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.CallList(1);
  EXPECT_EQ(center_red(), 0);
  for (GLuint i = 0; i < 300; ++i) {  // more than are kept before deleted ones are looked for
    gl.NewList(2, GL_COMPILE);
    draw_grid(gl, i % 2 ? GL_QUADS : GL_TRIANGLE_STRIP);
    gl.EndList();
    gl.CallList(2);
  }
  gl.DeleteLists(2, 1);
  gl.CallList(2);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_F(Lists, ADrawWithoutVerticesIsAnErrorInsideBeginEnd) {
  gl.NewList(1, GL_COMPILE);
  gl.DrawArrays(GL_QUADS, 0, 4);
  gl.EndList();
  gl.CallList(1);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  gl.Begin(GL_QUADS);
  gl.CallList(1);
  gl.End();
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
}

}  // namespace
}  // namespace legacy_gl::test
