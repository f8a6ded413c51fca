// S9: calls alone.
#include <array>
#include <utility>

#include "benchmark/speed_scenes.hpp"

namespace legacy_gl::test {

namespace {

// Something to see, so that a frame that lost its state is noticed.
void draw_witness(const GlFunctions& gl) {
  gl.Begin(GL_TRIANGLES);
  gl.Normal3f(0, 0, 1);
  gl.Vertex3f(-1, -1, 0);
  gl.Vertex3f(1, -1, 0);
  gl.Vertex3f(0, 1, 0.3F);
  gl.End();
}

SpeedScene call_scene(std::string name, std::string what,
                      std::function<void(const GlFunctions&)> calls) {
  SpeedScene scene;
  scene.name = std::move(name);
  scene.what = std::move(what);
  scene.goal_steady = 0.5;
  scene.prepare = [](const GlFunctions& gl) {
    set_up_view(gl);
    set_up_light(gl);
    set_up_material(gl);
  };
  scene.frame = [calls = std::move(calls)](const GlFunctions& gl) {
    clear_frame(gl);
    calls(gl);
    draw_witness(gl);
  };
  return scene;
}

void clipped_vertices(const GlFunctions& gl) {
  constexpr int kCalls = 1000000;
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < kCalls; ++i) {
    const float f = static_cast<float>(i & 1023) * (1.0F / 1024);
    gl.Color3f(f, 0.5F, 0.5F);
    gl.Normal3f(f, 0, 1);
    gl.Vertex3f(f, f, 100);  // behind the eye
  }
  gl.End();
}

void materials(const GlFunctions& gl) {
  constexpr int kCalls = 100000;
  for (int i = 0; i < kCalls; ++i) {
    const float f = static_cast<float>(i & 255) * (1.0F / 256);
    const std::array<GLfloat, 4> color{f, 0.5F, 1 - f, 1};
    gl.Materialfv(GL_FRONT, GL_DIFFUSE, color.data());
  }
}

void matrices(const GlFunctions& gl) {
  constexpr int kCalls = 100000;
  for (int i = 0; i < kCalls; ++i) {
    gl.PushMatrix();
    gl.Rotatef(static_cast<float>(i & 255), 0.3F, 0.5F, 0.8F);
    gl.PopMatrix();
  }
}

}  // namespace

std::vector<SpeedScene> call_scenes() {
  std::vector<SpeedScene> scenes;
  scenes.push_back(call_scene("S9e", "what S9 has besides its calls: clear, one triangle, finish",
                              [](const GlFunctions&) {}));
  scenes.back().goal_steady = 0;
  scenes.push_back(call_scene("S9v", "a million glColor, glNormal, glVertex of a clipped primitive",
                              clipped_vertices));
  scenes.push_back(call_scene("S9m", "100,000 glMaterialfv", materials));
  scenes.push_back(call_scene("S9p", "100,000 glPushMatrix, glRotatef, glPopMatrix", matrices));
  return scenes;
}

}  // namespace legacy_gl::test
