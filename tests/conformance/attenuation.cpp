#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

Scene attenuated_scene(std::string name, float constant, float linear, float quadratic,
                       Draw set = {}) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.Lightfv(GL_LIGHT0, GL_AMBIENT, vec(0.3F, 0.2F, 0.1F));
            gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0.7F, 0.4F, 1.1F));
            gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, constant);
            gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, linear);
            gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, quadratic);
            if (set) set(gl);
            draw_patch(gl);
            draw_sphere(gl, 0.4F);
          }};
}

}  // namespace

std::vector<Scene> attenuation_scenes() {
  return {
      attenuated_scene("constant_half", 0.5F, 0, 0),
      attenuated_scene("constant_3", 3, 0, 0),
      attenuated_scene("linear", 0, 0.8F, 0),
      attenuated_scene("quadratic", 0, 0, 0.9F),
      attenuated_scene("constant_and_linear", 1, 0.5F, 0),
      attenuated_scene("constant_and_quadratic", 1, 0, 0.5F),
      attenuated_scene("linear_and_quadratic", 0, 0.5F, 0.5F),
      attenuated_scene("all_three", 0.4F, 0.3F, 0.2F),
      attenuated_scene("steep", 0.01F, 0, 6),
      attenuated_scene("amplifying", 0.2F, 0.05F, 0.05F),
      attenuated_scene("ignored_for_a_directional_light", 2, 1, 1,
                       [](const GlFunctions& gl) {
                         gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0.3F, 0.2F, 1, 0));
                         draw_sphere(gl, 0.7F);
                       }),
      attenuated_scene("two_lights", 1, 0.2F, 0,
                       [](const GlFunctions& gl) {
                         use_positional_light(gl, GL_LIGHT1, vec(-0.6F, -0.5F, 0.8F),
                                              vec(0.8F, 0.3F, 0.1F));
                         gl.Lightf(GL_LIGHT1, GL_QUADRATIC_ATTENUATION, 1.5F);
                       }),
      attenuated_scene("distance_is_in_eye_coordinates", 0.5F, 0.5F, 0,
                       [](const GlFunctions& gl) {
                         gl.Scalef(0.8F, 0.8F, 1.5F);
                         gl.Enable(GL_NORMALIZE);
                       }),
  };
}

}  // namespace legacy_gl::test
