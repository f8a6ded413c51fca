// Per-fragment operations and face culling around lit and unlit drawing, and glClear.
#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

Scene depth_function_scene(std::string name, GLenum function) {
  return {std::move(name), [function](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.Rotatef(20, 1, 1, 0);
            draw_torus(gl);
            gl.DepthFunc(function);
            use_brass(gl, GL_FRONT);
            gl.Translatef(0.25F, 0.2F, 0);
            draw_sphere(gl, 0.7F);
          }};
}

Scene blend_scene(std::string name, GLenum source, GLenum destination) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            gl.Disable(GL_DEPTH_TEST);
            gl.Begin(GL_TRIANGLES);
            gl.Color4f(0.9F, 0.1F, 0.2F, 0.9F);
            gl.Vertex2f(-0.9F, -0.8F);
            gl.Color4f(0.2F, 0.8F, 0.1F, 0.6F);
            gl.Vertex2f(0.9F, -0.7F);
            gl.Color4f(0.1F, 0.2F, 0.9F, 0.4F);
            gl.Vertex2f(0, 0.9F);
            gl.End();
            gl.Enable(GL_BLEND);
            gl.BlendFunc(source, destination);
            gl.Begin(GL_TRIANGLES);
            gl.Color4f(0.1F, 0.7F, 0.8F, 0.3F);
            gl.Vertex2f(-0.9F, 0.8F);
            gl.Color4f(0.9F, 0.6F, 0.1F, 0.8F);
            gl.Vertex2f(0, -0.9F);
            gl.Color4f(0.6F, 0.1F, 0.7F, 0.5F);
            gl.Vertex2f(0.9F, 0.7F);
            gl.End();
          }};
}

Scene cull_scene(std::string name, GLenum face, GLenum front) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.Enable(GL_CULL_FACE);
            gl.CullFace(face);
            gl.FrontFace(front);
            draw_half_tube(gl);
            draw_sphere(gl, 0.5F);
          }};
}

}  // namespace

std::vector<Scene> depth_blend_cull_scenes() {
  std::vector<Scene> scenes;
  const std::pair<const char*, GLenum> functions[] = {
      {"never", GL_NEVER},   {"less", GL_LESS},       {"equal", GL_EQUAL},
      {"lequal", GL_LEQUAL}, {"greater", GL_GREATER}, {"notequal", GL_NOTEQUAL},
      {"gequal", GL_GEQUAL}, {"always", GL_ALWAYS}};
  for (const auto& [name, function] : functions)
    scenes.push_back(depth_function_scene(std::string("depth_") + name, function));
  const std::tuple<const char*, GLenum, GLenum> blends[] = {
      {"alpha", GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA},
      {"add", GL_ONE, GL_ONE},
      {"modulate", GL_DST_COLOR, GL_ZERO},
      {"one_minus_colors", GL_ONE_MINUS_DST_COLOR, GL_ONE_MINUS_SRC_COLOR},
      {"destination_alpha", GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA},
      {"saturate", GL_SRC_ALPHA_SATURATE, GL_ONE},
      {"keep", GL_ZERO, GL_ONE}};
  for (const auto& [name, source, destination] : blends)
    scenes.push_back(blend_scene(std::string("blend_") + name, source, destination));
  scenes.push_back(cull_scene("cull_back", GL_BACK, GL_CCW));
  scenes.push_back(cull_scene("cull_front", GL_FRONT, GL_CCW));
  scenes.push_back(cull_scene("cull_back_clockwise", GL_BACK, GL_CW));
  scenes.push_back({"cull_both_leaves_lines", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.Enable(GL_CULL_FACE);
                      gl.CullFace(GL_FRONT_AND_BACK);
                      draw_sphere(gl);
                      gl.Begin(GL_LINE_LOOP);
                      for (int i = 0; i < 10; ++i) {
                        const float angle = 0.628F * static_cast<float>(i);
                        gl.Normal3f(std::cos(angle), std::sin(angle), 0.3F);
                        gl.Vertex2f(std::cos(angle), std::sin(angle));
                      }
                      gl.End();
                    }});
  // The same geometry twice must pass GL_EQUAL everywhere: positions are invariant between a lit
  // and an unlit pass (GL 2.1 spec appendix A, rule for multi-pass algorithms).
  scenes.push_back({"multipass_equal_lit_then_unlit", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.Rotatef(33, 1, 2, 3);
                      draw_torus(gl);
                      gl.DepthFunc(GL_EQUAL);
                      gl.Disable(GL_LIGHTING);
                      gl.Enable(GL_BLEND);
                      gl.BlendFunc(GL_ONE, GL_ONE);
                      gl.Color4f(0.2F, 0, 0.1F, 0);
                      draw_torus(gl);
                    }});
  scenes.push_back({"multipass_one_light_each", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      draw_torus(gl);
                      gl.DepthFunc(GL_EQUAL);
                      gl.Enable(GL_BLEND);
                      gl.BlendFunc(GL_ONE, GL_ONE);
                      gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(0, 0, 0));
                      for (int i = 0; i < 3; ++i) {
                        const float x = static_cast<float>(i) - 1;
                        gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(x, -1, 1));
                        gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, vec(0.3F, 0.1F, 0.2F));
                        draw_torus(gl);
                      }
                    }});
  scenes.push_back({"blend_lit_alpha", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      draw_cube(gl, 0.4F);
                      gl.Enable(GL_BLEND);
                      gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                      gl.DepthMask(GL_FALSE);
                      gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0.9F, 0.4F, 0.1F, 0.4F));
                      draw_sphere(gl);
                    }});
  scenes.push_back({"depth_mask_off", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.DepthMask(GL_FALSE);
                      draw_cube(gl, 0.5F);
                      gl.DepthMask(GL_TRUE);
                      use_brass(gl, GL_FRONT);
                      gl.Translatef(0.1F, 0.1F, -1);
                      draw_sphere(gl, 0.6F);
                    }});
  scenes.push_back({"color_mask", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.ColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
                      draw_sphere(gl);
                      gl.ColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
                      gl.Translatef(0.3F, 0.2F, 0.1F);
                      draw_sphere(gl, 0.8F);
                    }});
  scenes.push_back({"scissor", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.Enable(GL_SCISSOR_TEST);
                      gl.Scissor(20, 35, 71, 53);
                      draw_sphere(gl);
                    }});
  scenes.push_back({"clear_with_scissor_and_mask",
                    [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.Enable(GL_SCISSOR_TEST);
                      gl.Scissor(10, 20, 60, 70);
                      gl.ClearColor(0.2F, 0.5F, 0.7F, 0.4F);
                      gl.Clear(GL_COLOR_BUFFER_BIT);
                      gl.Scissor(40, 40, 80, 80);
                      gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
                      gl.ClearColor(0.9F, 0.9F, 0.1F, 0.8F);
                      gl.Clear(GL_COLOR_BUFFER_BIT);
                    },
                    {.few_colors = true}});
  scenes.push_back({"clear_depth_value", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.ClearDepth(0.68);
                      gl.Clear(GL_DEPTH_BUFFER_BIT);
                      gl.Rotatef(40, 1, 0, 0);
                      draw_torus(gl);
                    }});
  scenes.push_back({"clear_between_draws", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      draw_cube(gl, 0.9F);
                      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
                      draw_sphere(gl, 0.6F);
                    }});
  scenes.push_back({"depth_test_off", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.Disable(GL_DEPTH_TEST);
                      draw_sphere(gl);
                      gl.Translatef(0, 0, -2);
                      draw_cube(gl, 0.6F);
                    }});
  return scenes;
}

}  // namespace legacy_gl::test
