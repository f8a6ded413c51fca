// Rings of vertices, indices and uniform blocks begin anew without a trace in the picture.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "support/contexts.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 32;

template <typename Draw>
Image render(RenderContext& context, Draw draw) {
  context.recreate();
  context.gl.ClearColor(0, 0, 0, 0);
  context.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw(context.gl);
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
  return context.read();
}

}  // namespace

// Thousands of transform blocks push the one that the light is in out of the ring.
TEST(StreamBuffer, UniformBlocksThatDoNotChange) {
  CoreContext context(kSize, kSize);
  const auto draw = [](const GlFunctions& gl, int draws) {
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    const std::array<GLfloat, 4> diffuse = {0.2F, 0.9F, 0.6F, 1};
    gl.Materialfv(GL_FRONT, GL_DIFFUSE, diffuse.data());
    for (int i = draws - 1; i >= 0; --i) {
      gl.LoadIdentity();
      gl.Translatef(-1e-7F * static_cast<float>(i), 0, 0);  // far below a pixel
      gl.Rectf(-0.5F, -0.5F, 0.5F, 0.5F);
      gl.Flush();  // or they would join in one draw
    }
  };
  const Image once = render(context, [&](const GlFunctions& gl) { draw(gl, 1); });
  const Image often = render(context, [&](const GlFunctions& gl) { draw(gl, 7000); });
  legacy_gl_statistics statistics{};
  legacy_gl_get_statistics(&statistics);
  EXPECT_GT(statistics.uniform_bytes_uploaded, 3U << 19) << "more than the ring holds";
  EXPECT_GT(covered_pixels(once), 100);
  EXPECT_TRUE(images_match(often, once, {}, "uniform_ring"));
}

// Each draw differs: one that reads what a later one wrote is seen.
TEST(StreamBuffer, VerticesOfManyDraws) {
  const auto draw = [](const GlFunctions& gl) {
    constexpr unsigned kVertices = 30000;
    std::vector<std::array<GLfloat, 3>> positions(kVertices);
    std::vector<GLuint> indices(kVertices);
    for (unsigned i = 0; i < kVertices; ++i) indices[i] = kVertices - 1 - i;
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(3, GL_FLOAT, 0, positions.data());
    for (unsigned frame = 0; frame < 32; ++frame) {
      const float x = static_cast<float>(frame % 8) / 4 - 0.98F;
      const float y = static_cast<float>(frame / 8) / 2 - 0.98F;
      for (unsigned i = 0; i < kVertices; ++i)
        positions[i] = {x + 0.0625F * static_cast<float>(i % 4),
                        y + 0.0625F * static_cast<float>(i / 4 % 8), 0};
      gl.Color3f(static_cast<float>(frame) / 31, 0.5F, 0.3F);
      gl.DrawElements(GL_POINTS, kVertices, GL_UNSIGNED_INT, indices.data());
    }
  };
  CoreContext context(kSize, kSize);
  MesaContext mesa(kSize, kSize);
  const Image reference = render(mesa, draw);
  const Image ours = render(context, draw);
  legacy_gl_statistics statistics{};
  legacy_gl_get_statistics(&statistics);
  EXPECT_GT(statistics.vertex_bytes_uploaded, 24U << 20) << "more than the ring holds";
  EXPECT_GT(covered_pixels(reference), 300);
  // One step: two round colours to RGBA8 that differ by the last bits of a float.
  EXPECT_TRUE(images_match(ours, reference, {.max_difference_steps = 1}, "vertex_ring"));
}

}  // namespace legacy_gl::test
