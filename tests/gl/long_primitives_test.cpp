// Primitives of many vertices are drawn while they are being given.
#include <gtest/gtest.h>

#include "scene_changes.hpp"
#include "support/contexts.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {
namespace {

constexpr int kSize = 64;

using Change = void (*)(const GlFunctions& gl, int vertex);

// Vertices all over the view, from a formula.
void give_vertices(const GlFunctions& gl, GLenum mode, int count, Change change) {
  gl.Begin(mode);
  for (int i = 0; i < count; ++i) {
    change(gl, i);
    const auto part = [i](int prime) {
      return static_cast<float>(i * 7 % prime) / static_cast<float>(prime);
    };
    gl.Normal3f(part(11) - 0.5F, part(13) - 0.5F, 1);
    gl.Vertex3f(2 * part(101) - 1, 2 * part(103) - 1, part(107));
  }
  gl.End();
}

Image draw(RenderContext& context, GLenum mode, int count, Change change) {
  context.recreate();
  set_up_scene(context.gl);
  context.gl.Enable(GL_DEPTH_TEST);
  context.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  give_vertices(context.gl, mode, count, change);
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
  return context.read_rgba8();
}

void expect_as_mesa(GLenum mode, int count, Change change) {
  MesaContext mesa(kSize, kSize);
  const Image expected = draw(mesa, mode, count, change);
  CoreContext ours(kSize, kSize);
  EXPECT_TRUE(images_match(draw(ours, mode, count, change), expected, {.max_difference_steps = 1},
                           "long-" + std::to_string(mode)));
}

void change_nothing(const GlFunctions&, int) {}
void change_color(const GlFunctions& gl, int vertex) {
  if (vertex == 0) gl.Disable(GL_LIGHTING);  // inside Begin/End: an error, and no change
  gl.Color3f(static_cast<float>(vertex % 17) / 17, 0.5F, 0.5F);
}
void change_material(const GlFunctions& gl, int vertex) {
  if (vertex % 1000) return;
  const float color[] = {static_cast<float>(vertex % 9) / 9, 0.4F, 0.3F, 1};
  gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, color);
}

constexpr int kMany = 60001;  // two more than whole triangles

TEST(LongPrimitives, Triangles) { expect_as_mesa(GL_TRIANGLES, kMany, change_nothing); }
TEST(LongPrimitives, Lines) { expect_as_mesa(GL_LINES, kMany, change_nothing); }
TEST(LongPrimitives, Points) { expect_as_mesa(GL_POINTS, kMany, change_nothing); }
TEST(LongPrimitives, Quads) { expect_as_mesa(GL_QUADS, kMany, change_nothing); }
TEST(LongPrimitives, Strip) { expect_as_mesa(GL_TRIANGLE_STRIP, kMany, change_nothing); }
TEST(LongPrimitives, MaterialsThatChangeInTheMiddle) {
  expect_as_mesa(GL_TRIANGLES, kMany, change_material);
}

TEST(LongPrimitives, ErrorsInTheMiddleChangeNothing) {
  CoreContext ours(kSize, kSize);
  const auto draw_colored = [&ours](Change change) {
    ours.recreate();
    set_up_scene(ours.gl);
    ours.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    give_vertices(ours.gl, GL_TRIANGLES, kMany, change);
    return ours.gl.GetError();
  };
  EXPECT_EQ(draw_colored(change_color), GLenum{GL_INVALID_OPERATION});
  const Image with_error = ours.read_rgba8();
  EXPECT_EQ(draw_colored(change_nothing), GLenum{GL_NO_ERROR});
  EXPECT_EQ(with_error.bytes, ours.read_rgba8().bytes);
}

TEST(LongPrimitives, DrawsBeforeTheirEnd) {
  CoreContext ours(kSize, kSize);
  set_up_scene(ours.gl);
  give_vertices(ours.gl, GL_TRIANGLES, 300000, change_nothing);
  ours.gl.Finish();
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  EXPECT_GT(statistics.batches, 10u);
  EXPECT_EQ(statistics.vertices, 300000u);
}

}  // namespace
}  // namespace legacy_gl::test
