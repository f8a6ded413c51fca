// GL 2.1 spec 3.5.4: polygons as lines or points keep the colours and the facing of the polygon;
// edges between the triangles of a quad or polygon are not drawn, nor those flagged off.
#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

Scene solid_scene(std::string name, GLenum face, GLenum mode, Draw set = {}) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.PolygonMode(face, mode);
            gl.PointSize(3);
            if (set) set(gl);
            gl.Rotatef(30, 1, 1, 0);
            draw_cube(gl, 0.6F);
            draw_sphere(gl, 0.85F, 9, 6);
          }};
}

void draw_ring(const GlFunctions& gl, GLenum primitive) {
  gl.Begin(primitive);
  for (int i = 0; i < 8; ++i) {
    const float f = static_cast<float>(i);
    const bool strip = primitive == GL_TRIANGLE_STRIP || primitive == GL_QUAD_STRIP;
    const float angle = 0.7854F * f + 0.1F;
    const float x = strip ? -0.9F + 0.25F * f : 0.9F * std::cos(angle);
    const float y = strip ? (i % 2 == 0 ? -0.7F : 0.7F) : 0.85F * std::sin(angle);
    color_by_position(gl, x, y, 0.1F * f);
    gl.Vertex2f(x, y);
  }
  gl.End();
}

Scene primitive_scene(std::string name, GLenum primitive, GLenum mode, bool flat) {
  return {std::move(name),
          [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            gl.PolygonMode(GL_FRONT_AND_BACK, mode);
            gl.PointSize(5);
            gl.LineWidth(2);
            gl.ShadeModel(flat ? GL_FLAT : GL_SMOOTH);
            draw_ring(gl, primitive);
          },
          {.few_colors = flat}};
}

}  // namespace

std::vector<Scene> polygon_mode_scenes() {
  std::vector<Scene> scenes = {
      solid_scene("line_both_faces", GL_FRONT_AND_BACK, GL_LINE),
      solid_scene("point_both_faces", GL_FRONT_AND_BACK, GL_POINT),
      solid_scene("line_front", GL_FRONT, GL_LINE),
      solid_scene("line_back", GL_BACK, GL_LINE),
      solid_scene("point_front", GL_FRONT, GL_POINT),
      solid_scene("line_culled", GL_FRONT_AND_BACK, GL_LINE,
                  [](const GlFunctions& gl) { gl.Enable(GL_CULL_FACE); }),
      solid_scene("line_two_sided", GL_FRONT_AND_BACK, GL_LINE,
                  [](const GlFunctions& gl) {
                    gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
                    use_brass(gl, GL_BACK);
                  }),
      solid_scene("line_flat", GL_FRONT_AND_BACK, GL_LINE,
                  [](const GlFunctions& gl) { gl.ShadeModel(GL_FLAT); }),
      solid_scene("line_wide", GL_FRONT_AND_BACK, GL_LINE,
                  [](const GlFunctions& gl) { gl.LineWidth(3); }),
      solid_scene("back_to_fill", GL_FRONT_AND_BACK, GL_LINE,
                  [](const GlFunctions& gl) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL); }),
  };
  const std::pair<const char*, GLenum> primitives[] = {
      {"triangles", GL_TRIANGLES},       {"triangle_strip", GL_TRIANGLE_STRIP},
      {"triangle_fan", GL_TRIANGLE_FAN}, {"quads", GL_QUADS},
      {"quad_strip", GL_QUAD_STRIP},     {"polygon", GL_POLYGON}};
  for (const auto& [name, primitive] : primitives) {
    scenes.push_back(primitive_scene(std::string(name) + "_as_lines", primitive, GL_LINE, false));
    scenes.push_back(
        primitive_scene(std::string(name) + "_as_lines_flat", primitive, GL_LINE, true));
    scenes.push_back(primitive_scene(std::string(name) + "_as_points", primitive, GL_POINT, false));
  }
  scenes.push_back(
      {"edge_flags", [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
         int index = 0;
         for (const GLenum mode : {GLenum{GL_TRIANGLES}, GLenum{GL_QUADS}, GLenum{GL_POLYGON}}) {
           gl.LoadIdentity();
           gl.Translatef(-0.6F + 0.6F * static_cast<float>(index++), 0, 0);
           gl.Scalef(0.28F, 0.9F, 1);
           gl.Begin(mode);
           for (int i = 0; i < 12; ++i) {
             const float angle = 0.5236F * static_cast<float>(i);
             gl.EdgeFlag(i % 3 != 1);
             color_by_position(gl, std::cos(angle), std::sin(angle), 0);
             gl.Vertex2f(std::cos(angle), std::sin(angle));
           }
           gl.End();
         }
       }});
  scenes.push_back({"front_line_back_point", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.PolygonMode(GL_FRONT, GL_LINE);
                      gl.PolygonMode(GL_BACK, GL_POINT);
                      gl.PointSize(4);
                      draw_half_tube(gl);
                    }});
  scenes.push_back({"filled_then_lines_with_offset", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.Rotatef(30, 1, 1, 0);
                      gl.Enable(GL_POLYGON_OFFSET_FILL);
                      gl.PolygonOffset(1, 1);
                      draw_cube(gl, 0.6F);
                      gl.Disable(GL_POLYGON_OFFSET_FILL);
                      gl.Disable(GL_LIGHTING);
                      gl.Color3f(1, 0.9F, 0.1F);
                      gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
                      draw_cube(gl, 0.6F);
                    }});
  return scenes;
}

}  // namespace legacy_gl::test
