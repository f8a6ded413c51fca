#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

Scene torus_scene(std::string name, GLenum shade_model, Draw set) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.ShadeModel(shade_model);
            set(gl);
            gl.Rotatef(-40, 1, 0, 0);
            draw_torus(gl);
          }};
}

void two_sided(const GlFunctions& gl) {
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  use_turquoise(gl, GL_BACK);
  gl.FrontFace(GL_CW);
}

void tracked(const GlFunctions& gl) {
  gl.ColorMaterial(GL_FRONT, GL_DIFFUSE);
  gl.Enable(GL_COLOR_MATERIAL);
  gl.Color3f(0.9F, 0.2F, 0.4F);
}

}  // namespace

std::vector<Scene> shade_model_scenes() {
  std::vector<Scene> scenes;
  for (const auto& [name, model] : {std::pair<const char*, GLenum>{"flat", GL_FLAT},
                                    std::pair<const char*, GLenum>{"smooth", GL_SMOOTH}}) {
    const std::string prefix = name;
    scenes.push_back(torus_scene(prefix + "_lit", model, [](const GlFunctions&) {}));
    scenes.push_back(torus_scene(prefix + "_two_sided", model, two_sided));
    scenes.push_back(torus_scene(prefix + "_color_material", model, tracked));
    scenes.push_back({prefix + "_unlit", [model = model](const GlFunctions& gl) {
                        begin_scene(gl);
                        gl.ShadeModel(model);
                        draw_colored_sphere(gl);
                      }});
    scenes.push_back({prefix + "_clipped", [model = model](const GlFunctions& gl) {
                        begin_scene(gl);
                        gl.ShadeModel(model);
                        gl.Translatef(0.7F, 0.5F, 1.3F);
                        draw_colored_sphere(gl);
                      }});
    scenes.push_back({prefix + "_alpha", [model = model](const GlFunctions& gl) {
                        begin_flat_scene(gl);
                        gl.ShadeModel(model);
                        gl.Begin(GL_TRIANGLE_STRIP);
                        for (int i = 0; i < 8; ++i) {
                          const float f = static_cast<float>(i);
                          gl.Color4f(1 - 0.1F * f, 0.1F * f, 0.5F, 0.1F + 0.12F * f);
                          gl.Vertex2f(-0.9F + 0.25F * f, i % 2 == 0 ? -0.8F : 0.8F);
                        }
                        gl.End();
                      }});
  }
  scenes.push_back({"changed_between_draws", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      for (int i = 0; i < 4; ++i) {
                        gl.ShadeModel(i % 2 == 0 ? GL_FLAT : GL_SMOOTH);
                        in_quarter(gl, i % 2, i / 2, [](const GlFunctions& g) { draw_sphere(g); });
                      }
                    }});
  return scenes;
}

}  // namespace legacy_gl::test
