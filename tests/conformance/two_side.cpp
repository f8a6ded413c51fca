// GL 2.1 spec 2.14.1: the sign of the window area chooses the face. Both faces have a shininess
// that is not 0 (Mesa departs from the specification when just one has: departures.cpp).
#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

void begin_two_sided(const GlFunctions& gl) {
  begin_lit_scene(gl);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  use_brass(gl, GL_FRONT);
  use_turquoise(gl, GL_BACK);
}

Scene tube_scene(std::string name, Draw set) {
  return {std::move(name), [set = std::move(set)](const GlFunctions& gl) {
            begin_two_sided(gl);
            set(gl);
            draw_half_tube(gl);
          }};
}

}  // namespace

std::vector<Scene> two_side_scenes() {
  return {
      tube_scene("two_materials", [](const GlFunctions&) {}),
      tube_scene("off_uses_the_front_for_both",
                 [](const GlFunctions& gl) { gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_FALSE); }),
      tube_scene("front_face_clockwise", [](const GlFunctions& gl) { gl.FrontFace(GL_CW); }),
      tube_scene("mirrored_modelview", [](const GlFunctions& gl) { gl.Scalef(-1, 1, 1); }),
      tube_scene("mirrored_modelview_clockwise",
                 [](const GlFunctions& gl) {
                   gl.Scalef(1, -1, 1);
                   gl.FrontFace(GL_CW);
                 }),
      tube_scene("cull_back", [](const GlFunctions& gl) { gl.Enable(GL_CULL_FACE); }),
      tube_scene("cull_front",
                 [](const GlFunctions& gl) {
                   gl.Enable(GL_CULL_FACE);
                   gl.CullFace(GL_FRONT);
                 }),
      tube_scene("flat", [](const GlFunctions& gl) { gl.ShadeModel(GL_FLAT); }),
      tube_scene(
          "local_viewer",
          [](const GlFunctions& gl) { gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE); }),
      tube_scene("separate_specular",
                 [](const GlFunctions& gl) {
                   gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
                 }),
      tube_scene("alpha_of_each_face",
                 [](const GlFunctions& gl) {
                   gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0.7F, 0.5F, 0.1F, 0.4F));
                   gl.Materialfv(GL_BACK, GL_DIFFUSE, vec(0.2F, 0.7F, 0.6F, 0.8F));
                 }),
      tube_scene(
          "emission_of_the_back",
          [](const GlFunctions& gl) { gl.Materialfv(GL_BACK, GL_EMISSION, vec(0.4F, 0, 0.1F)); }),
      tube_scene(
          "positional_inside",
          [](const GlFunctions& gl) { gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0.1F, 0.2F, 0.1F)); }),
      tube_scene("five_lights",
                 [](const GlFunctions& gl) {
                   for (int i = 1; i < 5; ++i) {
                     const float x = static_cast<float>(i) - 2.5F;
                     use_positional_light(gl, GL_LIGHT0 + static_cast<GLenum>(i),
                                          vec(x, 1 - x, i % 2 == 0 ? 1.0F : -1.0F, 0),
                                          vec(0.3F, 0.1F * static_cast<float>(i), 0.2F));
                   }
                 }),
      {"quads",
       [](const GlFunctions& gl) {
         begin_two_sided(gl);
         gl.Rotatef(20, 0, 0, 1);
         for (int i = 0; i < 2; ++i) {
           gl.Rotatef(180.0F * static_cast<float>(i), 0, 1, 0);
           gl.Begin(GL_QUADS);
           gl.Normal3f(0.3F, 0.1F, 0.95F);
           gl.Vertex3f(0.1F, -0.9F, 0.2F);
           gl.Normal3f(-0.3F, 0.1F, 0.95F);
           gl.Vertex3f(0.9F, -0.9F, 0.2F);
           gl.Normal3f(0.3F, 0.4F, 0.87F);
           gl.Vertex3f(0.9F, 0.9F, 0.2F);
           gl.Normal3f(0, 0, 1);
           gl.Vertex3f(0.1F, 0.9F, 0.2F);
           gl.End();
         }
       }},
      // Lines and points have no faces: always the front.
      {"lines_and_points_use_the_front",
       [](const GlFunctions& gl) {
         begin_two_sided(gl);
         gl.PointSize(5);
         for (const GLenum mode : {GLenum{GL_LINES}, GLenum{GL_POINTS}}) {
           gl.Begin(mode);
           for (int i = 0; i < 24; ++i) {
             const float angle = 0.2618F * static_cast<float>(i);
             gl.Normal3f(std::cos(angle), std::sin(angle), i % 4 < 2 ? 0.5F : -0.5F);
             gl.Vertex3f(std::cos(angle), std::sin(angle), 0);
           }
           gl.End();
         }
       }},
  };
}

}  // namespace legacy_gl::test
