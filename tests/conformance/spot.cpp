// Cones are placed so that no vertex lies exactly on one, and the shininess is not 0: both cases
// are in departures.cpp.
#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

// A patch under a spot light just above it, so that the cone's edge crosses many cells.
Scene spot_scene(std::string name, float cutoff_degrees, float exponent, Draw set = {}) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.Lightfv(GL_LIGHT0, GL_AMBIENT, vec(0.1F, 0.05F, 0));
            gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0.21F, 0.13F, 1.4F));
            gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, cutoff_degrees);
            gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, exponent);
            if (set) set(gl);
            draw_patch(gl, 24);
          }};
}

}  // namespace

std::vector<Scene> spot_scenes() {
  return {
      spot_scene("cutoff_5", 5, 0),
      spot_scene("cutoff_25", 25, 0),
      spot_scene("cutoff_60", 60, 0),
      spot_scene("cutoff_90", 90, 0),
      spot_scene("cutoff_180_is_no_spot", 180, 50),
      spot_scene("exponent_1", 40, 1),
      spot_scene("exponent_half", 40, 0.5F),
      spot_scene("exponent_30", 40, 30),
      spot_scene("exponent_128", 40, 128),
      spot_scene("tilted", 30, 4,
                 [](const GlFunctions& gl) {
                   gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, vec(0.3F, -0.2F, -1));
                 }),
      spot_scene(
          "unnormalized_direction", 30, 4,
          [](const GlFunctions& gl) { gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, vec(-3, 2, -10)); }),
      spot_scene("direction_takes_modelview_when_set", 30, 4,
                 [](const GlFunctions& gl) {
                   gl.PushMatrix();
                   gl.Rotatef(20, 1, 0, 0);
                   gl.Translatef(5, 6, 7);
                   gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, vec(0, 0, -1));
                   gl.PopMatrix();
                 }),
      spot_scene("direction_under_nonuniform_scale", 30, 4,
                 [](const GlFunctions& gl) {
                   gl.PushMatrix();
                   gl.Scalef(3, 1, 0.5F);
                   gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, vec(0.1F, 0.2F, -1));
                   gl.PopMatrix();
                 }),
      spot_scene("turned_away", 50, 2,
                 [](const GlFunctions& gl) {
                   gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, vec(0.9F, 0.1F, -0.4F));
                 }),
      spot_scene(
          "local_viewer", 35, 3,
          [](const GlFunctions& gl) { gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE); }),
      spot_scene("attenuated", 35, 3,
                 [](const GlFunctions& gl) {
                   gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 0.5F);
                   gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.2F);
                   gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.1F);
                 }),
      spot_scene("two_spots", 25, 2,
                 [](const GlFunctions& gl) {
                   use_positional_light(gl, GL_LIGHT1, vec(-0.43F, -0.31F, 1.1F),
                                        vec(0.9F, 0.3F, 0.2F));
                   gl.Lightf(GL_LIGHT1, GL_SPOT_CUTOFF, 33);
                   gl.Lightf(GL_LIGHT1, GL_SPOT_EXPONENT, 12);
                 }),
      // A spot with w = 0 has a direction to it as well: the angle is the same everywhere.
      spot_scene("directional_spot", 30, 5,
                 [](const GlFunctions& gl) {
                   gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0.2F, 0.1F, 1, 0));
                   draw_sphere(gl, 0.8F);
                 }),
  };
}

}  // namespace legacy_gl::test
