#include <array>
#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

void draw_point_grid(const GlFunctions& gl, int count) {
  gl.Begin(GL_POINTS);
  for (int row = 0; row < count; ++row) {
    for (int column = 0; column < count; ++column) {
      // Not on pixel centres, nor all at one offset from them.
      const float x = -0.85F + 1.71F * static_cast<float>(column) / static_cast<float>(count - 1);
      const float y = -0.83F + 1.67F * static_cast<float>(row) / static_cast<float>(count - 1);
      color_by_position(gl, x, y, 0);
      gl.Normal3f(0.5F * x, 0.5F * y, 0.8F);
      gl.Vertex2f(x, y);
    }
  }
  gl.End();
}

void draw_line_star(const GlFunctions& gl, int count) {
  gl.Begin(GL_LINES);
  for (int i = 0; i < count; ++i) {
    const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(count) + 0.05F;
    const float x = std::cos(angle);
    const float y = std::sin(angle);
    color_by_position(gl, x, y, 0);
    gl.Normal3f(0.6F * x, 0.6F * y, 0.6F);
    gl.Vertex2f(0.2F * x, 0.2F * y);
    color_by_position(gl, y, x, 0.5F);
    gl.Vertex2f(0.93F * x, 0.91F * y);
  }
  gl.End();
}

Scene point_size_scene(const std::string& name, float size) {
  return {"point_size_" + name, [size](const GlFunctions& gl) {
            begin_flat_scene(gl);
            gl.PointSize(size);
            draw_point_grid(gl, 6);
          }};
}

Scene line_width_scene(const std::string& name, float width) {
  return {"line_width_" + name, [width](const GlFunctions& gl) {
            begin_flat_scene(gl);
            gl.LineWidth(width);
            draw_line_star(gl, 17);
          }};
}

/// Points along the eye's axis, each moved aside behind the projection: Mesa takes their depth for
/// their distance (row M21), which is the same there.
void draw_points_by_distance(const GlFunctions& gl, GLenum shape = GL_POINTS) {
  for (int i = 0; i < 16; ++i) {
    const float x = -0.75F + 0.5F * static_cast<float>(i % 4);
    const float y = -0.75F + 0.5F * static_cast<float>(i / 4);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadIdentity();
    gl.Translatef(x, y, 0);
    gl.Frustum(-0.5, 0.5, -0.5, 0.5, 1, 30);
    gl.MatrixMode(GL_MODELVIEW);
    gl.Begin(shape);
    color_by_position(gl, x, y, 0);
    gl.Normal3f(0.5F * x, 0.5F * y, 0.8F);
    for (int corner = 0; corner < 3; ++corner)
      gl.Vertex3f(0, 0, -1.3F - 0.9F * static_cast<float>(i));
    gl.End();
  }
}

Scene attenuation_scene(const std::string& name, std::array<float, 3> attenuation, float least,
                        float largest) {
  return {"points_attenuated_" + name, [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            gl.LoadIdentity();
            gl.PointSize(17);
            gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation.data());
            gl.PointParameterf(GL_POINT_SIZE_MIN, least);
            gl.PointParameterf(GL_POINT_SIZE_MAX, largest);
            draw_points_by_distance(gl);
          }};
}

}  // namespace

std::vector<Scene> points_lines_scenes() {
  std::vector<Scene> scenes = {
      point_size_scene("1", 1),      point_size_scene("2", 2),      point_size_scene("3", 3),
      point_size_scene("5", 5),      point_size_scene("8", 8),      point_size_scene("2_4", 2.4F),
      point_size_scene("3_5", 3.5F), point_size_scene("17", 17),    line_width_scene("1", 1),
      line_width_scene("2", 2),      line_width_scene("3", 3),      line_width_scene("5", 5),
      line_width_scene("1_6", 1.6F), line_width_scene("2_5", 2.5F), line_width_scene("8", 8),
  };
  scenes.push_back({"points_lit", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.PointSize(6);
                      draw_point_grid(gl, 8);
                    }});
  scenes.push_back({"lines_lit", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.LineWidth(2);
                      draw_line_star(gl, 23);
                    }});
  scenes.push_back({"lines_flat", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.ShadeModel(GL_FLAT);
                      draw_line_star(gl, 23);
                    }});
  scenes.push_back({"lines_lit_flat", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.ShadeModel(GL_FLAT);
                      gl.LineWidth(3);
                      draw_line_star(gl, 13);
                    }});
  scenes.push_back({"size_and_width_change_between_draws", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      for (int i = 0; i < 4; ++i) {
                        gl.PointSize(1 + 2 * static_cast<float>(i));
                        gl.LineWidth(1 + static_cast<float>(i));
                        in_quarter(gl, i % 2, i / 2, [](const GlFunctions& g) {
                          draw_line_star(g, 7);
                          draw_point_grid(g, 3);
                        });
                      }
                    }});
  scenes.push_back({"lines_clipped", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.LineWidth(3);
                      gl.Scalef(1.7F, 1.5F, 1);
                      draw_line_star(gl, 19);
                    }});
  scenes.push_back({"points_across_the_border", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.PointSize(14);
                      gl.Scalef(1.17F, 1.18F, 1);
                      draw_point_grid(gl, 4);
                    }});
  scenes.push_back({"thin_sphere_of_lines", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      const Mesh mesh = sphere_mesh(14, 9);
                      gl.Rotatef(30, 1, 0, 0);
                      for (std::size_t i = 0; i + 15 < mesh.vertices.size(); i += 15) {
                        gl.Begin(GL_LINE_STRIP);
                        for (std::size_t j = i; j < i + 15; ++j) {
                          gl.Normal3fv(mesh.vertices[j].normal.data());
                          gl.Vertex3fv(mesh.vertices[j].position.data());
                        }
                        gl.End();
                      }
                    }});
  scenes.push_back(attenuation_scene("constant", {4, 0, 0}, 0, 60));
  scenes.push_back(attenuation_scene("linear", {0.2F, 0.37F, 0}, 0, 60));
  scenes.push_back(attenuation_scene("quadratic", {0.1F, 0.03F, 0.11F}, 0, 60));
  scenes.push_back(attenuation_scene("clamped", {0, 0, 0.31F}, 5, 14));
  scenes.push_back(attenuation_scene("clamped_only", {1, 0, 0}, 0, 9));
  scenes.push_back({"points_attenuated_lit", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.LoadIdentity();
                      constexpr GLfloat attenuation[] = {0.1F, 0.03F, 0.11F};
                      gl.PointSize(15);
                      gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
                      draw_points_by_distance(gl);
                    }});
  // Lines of every slope, with ends at and between pixel centres.
  scenes.push_back({"line_ends", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.LoadIdentity();
                      gl.MatrixMode(GL_PROJECTION);
                      gl.LoadIdentity();
                      gl.Ortho(0, scene_size, 0, scene_size, -1, 1);
                      gl.Begin(GL_LINES);
                      for (int i = 0; i < 30; ++i) {
                        const float offset = 0.25F * static_cast<float>(i % 4);
                        const float x = 4.0F * static_cast<float>(i) + 3;
                        color_by_position(gl, 0.06F * static_cast<float>(i) - 1, 0.3F, 0);
                        gl.Vertex2f(x + offset, 5 + offset);
                        gl.Vertex2f(x + static_cast<float>(i % 7) - 3, 60 + 2 * offset);
                        gl.Vertex2f(5 + offset, x + offset);
                        gl.Vertex2f(70 + 2 * offset, x + static_cast<float>(i % 5));
                      }
                      gl.End();
                    }});
  return scenes;
}

}  // namespace legacy_gl::test
