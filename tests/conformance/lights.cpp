#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

void use_ring_light(const GlFunctions& gl, int index, int count) {
  const float angle = 6.2831853F * static_cast<float>(index) / static_cast<float>(count);
  const float red = 0.2F + 0.5F * static_cast<float>(index % 2);
  const float green = 0.2F + 0.5F * static_cast<float>(index / 2 % 2);
  use_positional_light(gl, GL_LIGHT0 + static_cast<GLenum>(index),
                       vec(3 * std::cos(angle), 3 * std::sin(angle), 1.5F, index % 3 == 0 ? 0 : 1),
                       vec(red, green, 0.6F - 0.2F * red));
}

Scene ring_scene(int count) {
  return {"ring_of_" + std::to_string(count), [count](const GlFunctions& gl) {
            begin_lit_scene(gl);
            for (int i = 0; i < count; ++i) use_ring_light(gl, i, count);
            draw_sphere(gl);
          }};
}

}  // namespace

std::vector<Scene> lights_scenes() {
  std::vector<Scene> scenes;
  for (int count = 1; count <= 8; ++count) scenes.push_back(ring_scene(count));
  scenes.push_back({"default_light", [](const GlFunctions& gl) {
                      begin_scene(gl);
                      gl.Enable(GL_LIGHTING);
                      gl.Enable(GL_LIGHT0);
                      draw_sphere(gl);
                    }});
  // Light 1 and up have black diffuse and specular colours by default.
  scenes.push_back(lit_sphere_scene("default_light_1_adds_nothing",
                                    [](const GlFunctions& gl) { gl.Enable(GL_LIGHT1); }));
  scenes.push_back({"no_light_enabled",
                    [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.Disable(GL_LIGHT0);
                      gl.Materialfv(GL_FRONT, GL_EMISSION, vec(0.1F, 0.2F, 0.3F));
                      draw_sphere(gl);
                    },
                    {.few_colors = true}});
  scenes.push_back(lit_sphere_scene("light_7_alone", [](const GlFunctions& gl) {
    gl.Disable(GL_LIGHT0);
    use_positional_light(gl, GL_LIGHT7, vec(-1, 1, 1, 0), vec(0.9F, 0.5F, 0.3F));
  }));
  scenes.push_back(lit_sphere_scene("lights_0_2_5", [](const GlFunctions& gl) {
    use_positional_light(gl, GL_LIGHT2, vec(-2, 0, 1), vec(0.5F, 0.1F, 0.1F));
    use_positional_light(gl, GL_LIGHT5, vec(0, -2, 1, 0), vec(0.1F, 0.5F, 0.1F));
  }));
  scenes.push_back(lit_sphere_scene("unnormalized_direction", [](const GlFunctions& gl) {
    gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(50, 80, 100, 0));
  }));
  scenes.push_back(lit_sphere_scene("position_w_2", [](const GlFunctions& gl) {
    gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(3, 3, 5, 2));
  }));
  scenes.push_back(lit_sphere_scene("position_w_minus_1", [](const GlFunctions& gl) {
    gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(-1.5F, -1.5F, -2.5F, -1));
  }));
  scenes.push_back(lit_sphere_scene("light_behind", [](const GlFunctions& gl) {
    gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0.6F, 0.5F, -1, 0));
  }));
  scenes.push_back(lit_sphere_scene("negative_light_subtracts", [](const GlFunctions& gl) {
    use_positional_light(gl, GL_LIGHT1, vec(1, 0, 0.5F, 0), vec(-0.4F, -0.3F, -0.2F));
  }));
  scenes.push_back(lit_sphere_scene("light_above_one_clamps", [](const GlFunctions& gl) {
    gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, vec(3, 2, 1));
    gl.Lightfv(GL_LIGHT0, GL_SPECULAR, vec(5, 5, 5));
  }));
  scenes.push_back(lit_sphere_scene("integer_parameters", [](const GlFunctions& gl) {
    // Colours map [-2^31, 2^31-1] to [-1, 1]; positions do not.
    const std::array<GLint, 4> color = {2000000000, 1000000000, 500000000, 2147483647};
    const std::array<GLint, 4> position = {-2, 1, 3, 1};
    gl.Lightiv(GL_LIGHT0, GL_DIFFUSE, color.data());
    gl.Lightiv(GL_LIGHT0, GL_POSITION, position.data());
    gl.Lighti(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1);
  }));
  scenes.push_back(lit_sphere_scene("position_takes_modelview_when_set", [](const GlFunctions& gl) {
    gl.PushMatrix();
    gl.LoadIdentity();
    gl.Rotatef(-70, 0, 1, 0);
    gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0, 0.3F, 1, 0));
    gl.PopMatrix();
  }));
  scenes.push_back(lit_sphere_scene("position_in_object_space", [](const GlFunctions& gl) {
    gl.Rotatef(50, 1, 0, 0);
    gl.Scalef(1, 1, 0.8F);
    gl.Enable(GL_NORMALIZE);
    gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(0, 0.5F, 2));
  }));
  scenes.push_back({"changed_between_draws", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      for (int i = 0; i < 4; ++i) {
                        const float offset = static_cast<float>(i);
                        gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(1.5F - offset, 1, 0.7F, 0));
                        gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, vec(1, 0.3F * offset, 0.5F));
                        in_quarter(gl, i % 2, i / 2, [](const GlFunctions& g) { draw_sphere(g); });
                      }
                    }});
  scenes.push_back({"enabled_and_disabled_between_draws", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      use_ring_light(gl, 1, 3);
                      use_ring_light(gl, 2, 3);
                      for (int i = 0; i < 4; ++i) {
                        if (i == 1) gl.Disable(GL_LIGHT1);
                        if (i == 2) gl.Disable(GL_LIGHT0);
                        if (i == 3) gl.Disable(GL_LIGHTING);
                        gl.Color4f(0.2F, 0.9F, 0.1F, 1);
                        in_quarter(gl, i % 2, i / 2, [](const GlFunctions& g) { draw_sphere(g); });
                      }
                    }});
  return scenes;
}

}  // namespace legacy_gl::test
