// glRect is a polygon of four vertices in the plane z = 0 (GL 2.1 spec 2.10).
#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

using Rectangle = std::function<void(const GlFunctions&, int index)>;

// Four rectangles with a colour each, over one another and turned.
Scene rect_scene(std::string name, Rectangle rectangle, Draw set = {}) {
  return {std::move(name),
          [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            if (set) set(gl);
            gl.Scalef(0.1F, 0.1F, 1);
            for (int i = 0; i < 4; ++i) {
              gl.Translatef(0, 0, 0.1F);
              gl.Rotatef(17, 0, 0, 1);
              gl.Color4f(0.3F * static_cast<float>(i), 0.8F - 0.2F * static_cast<float>(i), 0.5F,
                         1);
              rectangle(gl, i);
            }
          },
          {.few_colors = true}};
}

template <typename Value>
std::array<Value, 2> corner(int x, int y) {
  return {static_cast<Value>(x), static_cast<Value>(y)};
}

void rect_f(const GlFunctions& gl, int i) {
  const float f = static_cast<float>(i);
  gl.Rectf(-8.5F + 2 * f, -6 + f, 7.25F - f, 5 - f);
}

}  // namespace

std::vector<Scene> rect_scenes() {
  return {
      rect_scene("s",
                 [](const GlFunctions& gl, int i) {
                   gl.Rects(static_cast<GLshort>(-8 + 2 * i), -6, 7, static_cast<GLshort>(5 - i));
                 }),
      rect_scene("i", [](const GlFunctions& gl, int i) { gl.Recti(-8 + 2 * i, -6, 7, 5 - i); }),
      rect_scene("f", rect_f),
      rect_scene("d",
                 [](const GlFunctions& gl, int i) { gl.Rectd(-8.5 + 2 * i, -6, 7.25, 5 - i); }),
      rect_scene("sv",
                 [](const GlFunctions& gl, int i) {
                   gl.Rectsv(corner<GLshort>(-8 + 2 * i, -6).data(),
                             corner<GLshort>(7, 5 - i).data());
                 }),
      rect_scene("iv",
                 [](const GlFunctions& gl, int i) {
                   gl.Rectiv(corner<GLint>(-8 + 2 * i, -6).data(), corner<GLint>(7, 5 - i).data());
                 }),
      rect_scene("fv",
                 [](const GlFunctions& gl, int i) {
                   gl.Rectfv(corner<GLfloat>(-8 + 2 * i, -6).data(),
                             corner<GLfloat>(7, 5 - i).data());
                 }),
      rect_scene("dv",
                 [](const GlFunctions& gl, int i) {
                   gl.Rectdv(corner<GLdouble>(-8 + 2 * i, -6).data(),
                             corner<GLdouble>(7, 5 - i).data());
                 }),
      // x1 > x2 turns the rectangle's face away.
      rect_scene(
          "reversed_is_culled",
          [](const GlFunctions& gl, int i) {
            if (i % 2 == 0) gl.Recti(7, -6, -8 + i, 5);
            else gl.Recti(-8 + i, -6, 7, 5);
          },
          [](const GlFunctions& gl) { gl.Enable(GL_CULL_FACE); }),
      rect_scene("as_lines", rect_f,
                 [](const GlFunctions& gl) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); }),
      {"lit",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         for (int i = 0; i < 4; ++i) {
           gl.Normal3f(0.3F * static_cast<float>(i), 0.2F, 0.8F);
           in_quarter(gl, i % 2, i / 2, [](const GlFunctions& g) { g.Rectf(-1, -0.8F, 0.7F, 1); });
         }
       }},
      {"in_a_list",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         gl.NewList(1, GL_COMPILE);
         for (int i = 0; i < 5; ++i) {
           const float f = 0.2F * static_cast<float>(i);
           gl.Color3f(f, 1 - f, 0.5F);
           gl.Rectf(-0.9F + f, -0.9F + f, -0.4F + f, -0.1F + f);
         }
         gl.EndList();
         gl.CallList(1);
       }},
  };
}

}  // namespace legacy_gl::test
