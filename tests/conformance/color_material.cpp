// GL 2.1 spec 2.14.3. The order glColorMaterial, glEnable, glColor is used throughout but in
// departures.cpp, since Mesa misses the colour that was set before glEnable in another order.
#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

void track(const GlFunctions& gl, GLenum face, GLenum mode) {
  gl.ColorMaterial(face, mode);
  gl.Enable(GL_COLOR_MATERIAL);
}

Scene tracked_scene(std::string name, GLenum face, GLenum mode) {
  return {std::move(name), [face, mode](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(0.4F, 0.4F, 0.4F));
            track(gl, face, mode);
            draw_colored_sphere(gl);
          }};
}

Scene two_sided_scene(std::string name, GLenum face, GLenum mode) {
  return {std::move(name), [face, mode](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
            gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(0.4F, 0.4F, 0.4F));
            track(gl, face, mode);
            gl.Color4f(0.8F, 0.4F, 0.1F, 0.9F);
            draw_half_tube(gl);
            gl.Color4f(0.1F, 0.5F, 0.6F, 0.7F);
            draw_sphere(gl, 0.4F);
          }};
}

}  // namespace

std::vector<Scene> color_material_scenes() {
  std::vector<Scene> scenes;
  const std::pair<const char*, GLenum> modes[] = {{"ambient", GL_AMBIENT},
                                                  {"diffuse", GL_DIFFUSE},
                                                  {"specular", GL_SPECULAR},
                                                  {"emission", GL_EMISSION},
                                                  {"ambient_and_diffuse", GL_AMBIENT_AND_DIFFUSE}};
  for (const auto& [name, mode] : modes) {
    scenes.push_back(tracked_scene(std::string(name) + "_front", GL_FRONT, mode));
    scenes.push_back(tracked_scene(std::string(name) + "_both_faces", GL_FRONT_AND_BACK, mode));
    scenes.push_back(
        two_sided_scene(std::string(name) + "_two_sided_both_faces", GL_FRONT_AND_BACK, mode));
    scenes.push_back(two_sided_scene(std::string(name) + "_two_sided_front", GL_FRONT, mode));
  }
  scenes.push_back(two_sided_scene("emission_two_sided_back", GL_BACK, GL_EMISSION));
  scenes.push_back(lit_sphere_scene("disable_keeps_what_was_tracked", [](const GlFunctions& gl) {
    track(gl, GL_FRONT, GL_DIFFUSE);
    gl.Color4f(0.9F, 0.2F, 0.1F, 0.8F);
    gl.Disable(GL_COLOR_MATERIAL);
    gl.Color4f(0, 1, 0, 1);
  }));
  scenes.push_back(lit_sphere_scene("material_on_tracked_is_ignored", [](const GlFunctions& gl) {
    track(gl, GL_FRONT, GL_DIFFUSE);
    gl.Color4f(0.9F, 0.2F, 0.1F, 0.8F);
    gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0, 0, 1));
  }));
  scenes.push_back(lit_sphere_scene("material_on_untracked_counts", [](const GlFunctions& gl) {
    track(gl, GL_FRONT, GL_DIFFUSE);
    gl.Color4f(0.6F, 0.2F, 0.1F, 0.8F);
    gl.Materialfv(GL_FRONT, GL_EMISSION, vec(0, 0, 0.4F));
  }));
  scenes.push_back(lit_sphere_scene("mode_changed_while_enabled", [](const GlFunctions& gl) {
    track(gl, GL_FRONT, GL_DIFFUSE);
    gl.Color4f(0.8F, 0.2F, 0.1F, 1);
    gl.ColorMaterial(GL_FRONT, GL_EMISSION);
    gl.Color4f(0.1F, 0.1F, 0.3F, 1);
  }));
  // Tracks diffuse by default, and the default colour is white: enabling alone changes the
  // material.
  scenes.push_back(lit_sphere_scene("defaults", [](const GlFunctions& gl) {
    gl.Enable(GL_COLOR_MATERIAL);
    gl.Color3f(0.3F, 0.6F, 0.9F);
  }));
  scenes.push_back({"ignored_while_lighting_is_off", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      track(gl, GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
                      gl.Disable(GL_LIGHTING);
                      draw_colored_sphere(gl);
                    }});
  scenes.push_back({"toggled_between_draws", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.ColorMaterial(GL_FRONT, GL_AMBIENT_AND_DIFFUSE);
                      for (int i = 0; i < 4; ++i) {
                        if (i % 2 == 0) gl.Enable(GL_COLOR_MATERIAL);
                        else gl.Disable(GL_COLOR_MATERIAL);
                        gl.Color4f(0.2F + 0.2F * static_cast<float>(i), 0.8F, 0.3F, 1);
                        in_quarter(gl, i % 2, i / 2, [](const GlFunctions& g) { draw_sphere(g); });
                      }
                    }});
  scenes.push_back({"color_above_one", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      track(gl, GL_FRONT, GL_DIFFUSE);
                      gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, vec(0.4F, 0.4F, 0.4F));
                      gl.Color4f(2.0F, 1.5F, -1.0F, 1);
                      draw_sphere(gl);
                    }});
  return scenes;
}

}  // namespace legacy_gl::test
