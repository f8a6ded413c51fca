#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

std::vector<Scene> light_model_scenes() {
  return {
      lit_sphere_scene("ambient_default", [](const GlFunctions&) {}),
      lit_sphere_scene(
          "ambient_black",
          [](const GlFunctions& gl) { gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(0, 0, 0)); }),
      lit_sphere_scene(
          "ambient_above_one",
          [](const GlFunctions& gl) { gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(2, 1.5F, 1)); }),
      lit_sphere_scene(
          "ambient_negative",
          [](const GlFunctions& gl) { gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(-2, 0.5F, 1)); }),
      lit_sphere_scene("ambient_integer",
                       [](const GlFunctions& gl) {
                         const std::array<GLint, 4> color = {1500000000, 700000000, 0, 0};
                         gl.LightModeliv(GL_LIGHT_MODEL_AMBIENT, color.data());
                       }),
      lit_sphere_scene("local_viewer_directional",
                       [](const GlFunctions& gl) {
                         gl.LightModelf(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
                         gl.Materialf(GL_FRONT, GL_SHININESS, 50);
                       }),
      lit_sphere_scene("local_viewer_positional",
                       [](const GlFunctions& gl) {
                         gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
                         gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(1, 1, 2));
                       }),
      lit_sphere_scene(
          "infinite_viewer_positional",
          [](const GlFunctions& gl) { gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(1, 1, 2)); }),
      lit_sphere_scene("separate_specular_without_texture",
                       [](const GlFunctions& gl) {
                         gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
                         gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(1.3F, 0.2F, 0.7F, 0.5F));
                         gl.Materialfv(GL_FRONT, GL_SPECULAR, vec(1, 1, 1));
                       }),
      // The primary and the secondary colour are clamped each, then their sum.
      lit_sphere_scene("separate_specular_clamps_each",
                       [](const GlFunctions& gl) {
                         gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
                         gl.Materialfv(GL_FRONT, GL_EMISSION, vec(-0.8F, 0, 0));
                         gl.Materialfv(GL_FRONT, GL_SPECULAR, vec(1, 1, 1));
                       }),
      lit_sphere_scene("separate_specular_flat",
                       [](const GlFunctions& gl) {
                         gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
                         gl.ShadeModel(GL_FLAT);
                       }),
      lit_sphere_scene("local_viewer_with_all_terms",
                       [](const GlFunctions& gl) {
                         gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
                         gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
                         gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(0.3F, 0.4F, 0.2F));
                         gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(1, 1, 2));
                         gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.1F);
                         gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 70);
                         gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 2);
                       }),
  };
}

}  // namespace legacy_gl::test
