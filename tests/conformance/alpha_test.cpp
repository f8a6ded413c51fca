// Every comparison of the alpha test, over colours whose alpha varies.
#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

// Rows of equal alpha, which no rounding brings across a reference.
void draw_rows(const GlFunctions& gl) {
  for (int i = 0; i < 10; ++i) {
    const float y = 0.2F * static_cast<float>(i) - 1;
    gl.Color4f(1 - 0.1F * static_cast<float>(i), 0.5F, 0.8F, 0.125F * static_cast<float>(i));
    gl.Rectf(-1, y, 1, y + 0.15F);
  }
}

Scene comparison(std::string name, GLenum function) {
  return {std::move(name),
          [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            gl.Enable(GL_ALPHA_TEST);
            gl.AlphaFunc(function, 0.5F);
            draw_rows(gl);
          },
          {.few_colors = true, .draws_nothing = function == GL_NEVER}};
}

}  // namespace

std::vector<Scene> alpha_test_scenes() {
  return {
      comparison("never", GL_NEVER),
      comparison("less", GL_LESS),
      comparison("equal", GL_EQUAL),
      comparison("lequal", GL_LEQUAL),
      comparison("greater", GL_GREATER),
      comparison("notequal", GL_NOTEQUAL),
      comparison("gequal", GL_GEQUAL),
      comparison("always", GL_ALWAYS),
      {"material_alpha",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.Enable(GL_ALPHA_TEST);
         gl.AlphaFunc(GL_GREATER, 0.5F);
         gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0.8F, 0.2F, 0.1F, 0.6F));
         draw_sphere(gl, 0.6F);
         gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0.1F, 0.2F, 0.9F, 0.4F));
         gl.Translatef(0.5F, 0.5F, 0.5F);
         draw_sphere(gl, 0.6F);
       }},
      {"depth_of_fragments_that_fail_stays",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         gl.Enable(GL_ALPHA_TEST);
         gl.AlphaFunc(GL_GREATER, 0.5F);
         gl.Translatef(0, 0, 0.5F);
         draw_rows(gl);
         gl.Translatef(0, 0, -0.2F);
         gl.Disable(GL_ALPHA_TEST);
         gl.Color4f(0, 1, 0, 1);
         gl.Rectf(-0.5F, -1, 0.5F, 1);
       },
       {.few_colors = true}},
      {"attribute_group",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         gl.Enable(GL_ALPHA_TEST);
         gl.AlphaFunc(GL_LESS, 0.5F);
         gl.PushAttrib(GL_COLOR_BUFFER_BIT);
         gl.AlphaFunc(GL_GREATER, 0.75F);
         gl.Disable(GL_ALPHA_TEST);
         gl.PopAttrib();
         draw_rows(gl);
       },
       {.few_colors = true}},
  };
}

}  // namespace legacy_gl::test
