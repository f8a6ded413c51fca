#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

Scene shininess_scene(std::string name, float shininess) {
  return lit_sphere_scene(std::move(name), [shininess](const GlFunctions& gl) {
    gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, shininess);
  });
}

void draw_three_solids(const GlFunctions& gl) {
  begin_lit_scene(gl);
  gl.Enable(GL_NORMALIZE);
  use_brass(gl, GL_FRONT);
  in_quarter(gl, 0, 0, [](const GlFunctions& g) { draw_sphere(g); });
  use_turquoise(gl, GL_FRONT);
  in_quarter(gl, 1, 0, [](const GlFunctions& g) {
    g.PushMatrix();
    g.Rotatef(30, 1, 1, 0);
    draw_cube(g, 0.6F);
    g.PopMatrix();
  });
  use_black_plastic(gl, GL_FRONT);
  in_quarter(gl, 0, 1, [](const GlFunctions& g) {
    g.PushMatrix();
    g.Rotatef(-40, 1, 0.2F, 0);
    draw_torus(g);
    g.PopMatrix();
  });
}

}  // namespace

std::vector<Scene> materials_scenes() {
  return {
      lit_sphere_scene("brass", [](const GlFunctions& gl) { use_brass(gl, GL_FRONT); }),
      lit_sphere_scene("turquoise", [](const GlFunctions& gl) { use_turquoise(gl, GL_FRONT); }),
      lit_sphere_scene("black_plastic",
                       [](const GlFunctions& gl) { use_black_plastic(gl, GL_FRONT); }),
      {"three_solids", draw_three_solids},
      shininess_scene("shininess_0", 0),
      shininess_scene("shininess_half", 0.5F),
      shininess_scene("shininess_1", 1),
      shininess_scene("shininess_5_5", 5.5F),
      shininess_scene("shininess_64", 64),
      shininess_scene("shininess_128", 128),
      {"default_material",
       [](const GlFunctions& gl) {
         begin_scene(gl);
         gl.Enable(GL_LIGHTING);
         use_directional_light(gl, GL_LIGHT0, vec(1, 1, 1));
         draw_torus(gl);
       }},
      lit_sphere_scene("emission_only",
                       [](const GlFunctions& gl) {
                         use_material(gl, GL_FRONT, vec(0, 0, 0), vec(0, 0, 0), vec(0.4F, 0, 0), 9);
                         gl.Materialfv(GL_FRONT, GL_EMISSION, vec(0.1F, 0.3F, 0.6F));
                       }),
      lit_sphere_scene("ambient_and_diffuse",
                       [](const GlFunctions& gl) {
                         gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, vec(0.7F, 0.3F, 0.2F));
                       }),
      lit_sphere_scene("alpha_is_diffuse_alpha",
                       [](const GlFunctions& gl) {
                         gl.Materialfv(GL_FRONT, GL_AMBIENT, vec(0.1F, 0.1F, 0.1F, 0.9F));
                         gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0.5F, 0.5F, 0.1F, 0.3F));
                         gl.Materialfv(GL_FRONT, GL_SPECULAR, vec(0.5F, 0.5F, 0.5F, 0.7F));
                         gl.Materialfv(GL_FRONT, GL_EMISSION, vec(0.1F, 0, 0, 0.2F));
                       }),
      lit_sphere_scene("alpha_above_one_clamps",
                       [](const GlFunctions& gl) {
                         gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0.5F, 0.5F, 0.1F, 3.0F));
                       }),
      lit_sphere_scene("negative_diffuse_subtracts",
                       [](const GlFunctions& gl) {
                         gl.Materialfv(GL_FRONT, GL_AMBIENT, vec(1, 1, 1));
                         gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(0.8F, 0.8F, 0.8F));
                         gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(-0.5F, 0.1F, -0.3F));
                       }),
      lit_sphere_scene("above_one_clamps_after_the_sum",
                       [](const GlFunctions& gl) {
                         gl.Materialfv(GL_FRONT, GL_EMISSION, vec(-0.5F, -0.5F, 0));
                         gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(1.4F, 1.2F, 1.0F));
                       }),
      lit_sphere_scene(
          "integer_parameters",
          [](const GlFunctions& gl) {
            const std::array<GLint, 4> color = {1900000000, 300000000, -500000000, 2147483647};
            gl.Materialiv(GL_FRONT, GL_DIFFUSE, color.data());
            gl.Materiali(GL_FRONT, GL_SHININESS, 30);
          }),
      lit_sphere_scene("back_material_is_not_used_for_the_front",
                       [](const GlFunctions& gl) { use_brass(gl, GL_BACK); }),
      {"changed_between_draws",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         for (int i = 0; i < 4; ++i) {
           const float f = static_cast<float>(i) / 3.0F;
           gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(f, 1 - f, 0.5F));
           gl.Materialf(GL_FRONT, GL_SHININESS, 5 + 30 * f);
           in_quarter(gl, i % 2, i / 2, [](const GlFunctions& g) { draw_sphere(g); });
         }
       }},
  };
}

}  // namespace legacy_gl::test
