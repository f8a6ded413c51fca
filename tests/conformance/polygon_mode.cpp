// GL 2.1 spec 3.5.4: polygons as lines or points keep the colours and the facing of the polygon;
// edges between the triangles of a quad or polygon are not drawn, nor those flagged off.
#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

// Which face of a triangle without area is drawn, Mesa lets the framebuffer's orientation decide
// (row M11 of docs/deviations.md): a sphere has such triangles at its poles, a torus has none.
Scene torus_scene(std::string name, GLenum face, GLenum mode) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.PolygonMode(face, mode);
            gl.PointSize(3);
            gl.Rotatef(50, 1, 1, 0);
            draw_cube(gl, 0.3F);
            draw_torus(gl, 0.3F, 0.6F);
          }};
}

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

// Polygons beyond the near plane, beside the view and behind the eye.
void draw_clipped_lines(const GlFunctions& gl) {
  begin_lit_scene(gl);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.Translatef(0, 0, 1.5F);
  gl.Rotatef(40, 1, 2, 0);
  draw_torus(gl, 0.4F, 0.9F);
}

void draw_edge_flags(const GlFunctions& gl) {
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
}

// Edges of strips and fans are all drawn (GL 2.1 spec 2.6.2); Mesa heeds their edge flags.
void draw_strips_as_lines(const GlFunctions& gl, bool edge_flags) {
  begin_flat_scene(gl);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.Scalef(0.9F, 0.3F, 1);
  gl.Translatef(0, -2, 0);
  for (const GLenum mode :
       {GLenum{GL_TRIANGLE_STRIP}, GLenum{GL_QUAD_STRIP}, GLenum{GL_TRIANGLE_FAN}}) {
    gl.Begin(mode);
    for (int i = 0; i < 8; ++i) {
      const float x = 0.25F * static_cast<float>(i) - 0.9F;
      const float y = i % 2 == 0 ? -0.8F : 0.8F;
      gl.EdgeFlag(!edge_flags || i % 3 != 1);
      color_by_position(gl, x, y, 0);
      gl.Vertex2f(x, y);
    }
    gl.End();
    gl.Translatef(0, 2, 0);
  }
}

// Mesa joins the strips of a list into one, and draws what joins them.
void draw_tube_as_lines(const GlFunctions& gl, bool in_list) {
  begin_lit_scene(gl);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  if (!in_list) return draw_half_tube(gl);
  gl.NewList(1, GL_COMPILE);
  draw_half_tube(gl);
  gl.EndList();
  gl.CallList(1);
}

// Filled, and the same polygons as lines or points, nearer or farther by the offset.
Scene offset_scene(std::string name, GLenum mode, GLenum capability, float factor, float units) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.Rotatef(30, 1, 1, 0);
            draw_cube(gl, 0.5F);
            draw_torus(gl, 0.3F, 0.6F);
            gl.Disable(GL_LIGHTING);
            gl.Color3f(1, 0.9F, 0.1F);
            gl.PolygonMode(GL_FRONT_AND_BACK, mode);
            gl.PointSize(3);
            gl.PolygonOffset(factor, units);
            gl.Enable(capability);
            draw_cube(gl, 0.5F);
            draw_torus(gl, 0.3F, 0.6F);
          }};
}

// Rings before and behind a torus, with the offset of a mode that they are not drawn in.
void draw_with_offset_of_others(const GlFunctions& gl, GLenum mode, GLenum capability,
                                bool enabled) {
  begin_lit_scene(gl);
  gl.Rotatef(50, 1, 1, 0);
  draw_torus(gl, 0.3F, 0.6F);
  gl.Disable(GL_LIGHTING);
  gl.PolygonMode(GL_FRONT_AND_BACK, mode);
  gl.PointSize(3);
  gl.PolygonOffset(-4, -100000);
  if (enabled) gl.Enable(capability);
  gl.Scalef(0.7F, 0.7F, 0.7F);  // all of it in the view (row D10)
  for (GLenum primitive = GL_TRIANGLES; primitive <= GL_POLYGON; ++primitive) {
    gl.Rotatef(30, 0, 1, 0.5F);
    draw_ring(gl, primitive);
  }
}

// Mesa moves what is filled by any of the three.
Scene other_offset_scene(std::string name, GLenum mode, GLenum capability) {
  Scene scene{std::move(name), [=](const GlFunctions& gl) {
                draw_with_offset_of_others(gl, mode, capability, true);
              }};
  if (mode == GL_FILL)
    scene.traits = {.mesa_departure = "M25", .reference = [=](const GlFunctions& gl) {
                      draw_with_offset_of_others(gl, mode, capability, false);
                    }};
  return scene;
}

// Flat shading lights the provoking vertex where it is.
void light_from_nearby(const GlFunctions& gl) {
  gl.ShadeModel(GL_FLAT);
  use_positional_light(gl, GL_LIGHT0, vec(1, 1.5F, 1, 1), vec(1, 1, 1));
  gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.3F);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
}

void draw_edge_flag_array(const GlFunctions& gl) {
  begin_flat_scene(gl);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  std::array<std::array<GLfloat, 2>, 12> positions{};
  std::array<GLboolean, 12> flags{};
  std::array<GLushort, 12> elements{};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const float angle = 0.5236F * static_cast<float>(i);
    positions[i] = {0.9F * std::cos(angle), 0.9F * std::sin(angle)};
    flags[i] = i % 4 != 1;
    elements[i] = static_cast<GLushort>(11 - i);
  }
  gl.VertexPointer(2, GL_FLOAT, 0, positions.data());
  gl.EdgeFlagPointer(0, flags.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_EDGE_FLAG_ARRAY);
  gl.Color3f(0.9F, 0.4F, 0.2F);
  gl.DrawArrays(GL_POLYGON, 0, 12);
  gl.Scalef(0.8F, 0.8F, 1);
  gl.Color3f(0.2F, 0.7F, 0.9F);
  gl.DrawElements(GL_QUADS, 12, GL_UNSIGNED_SHORT, elements.data());
}

}  // namespace

std::vector<Scene> polygon_mode_scenes() {
  std::vector<Scene> scenes = {
      solid_scene("line_both_faces", GL_FRONT_AND_BACK, GL_LINE),
      solid_scene("point_both_faces", GL_FRONT_AND_BACK, GL_POINT),
      solid_scene("line_front", GL_FRONT, GL_LINE),
      torus_scene("line_back", GL_BACK, GL_LINE),
      torus_scene("point_front", GL_FRONT, GL_POINT),
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
  scenes.push_back({"edge_flags", draw_edge_flags});
  scenes.push_back({"edge_flags_in_a_list", [](const GlFunctions& gl) {
                      gl.NewList(1, GL_COMPILE);
                      draw_edge_flags(gl);
                      gl.EndList();
                      gl.CallList(1);
                    }});
  // What a list draws is filled or not by the mode of the time when it is called.
  scenes.push_back({"list_filled_and_as_lines", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.NewList(1, GL_COMPILE);
                      draw_cube(gl, 0.4F);
                      draw_torus(gl, 0.15F, 0.3F);
                      gl.EndList();
                      gl.Rotatef(30, 1, 1, 0);
                      gl.Translatef(-0.5F, 0, 0);
                      gl.CallList(1);
                      gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
                      gl.Translatef(1, 0, 0);
                      gl.CallList(1);
                    }});
  scenes.push_back({"list_of_strips_as_lines",
                    [](const GlFunctions& gl) { draw_tube_as_lines(gl, true); },
                    {.mesa_departure = "M13",
                     .reference = [](const GlFunctions& gl) { draw_tube_as_lines(gl, false); }}});
  scenes.push_back({"line_clipped", draw_clipped_lines});
  scenes.push_back(offset_scene("line_offset_nearer", GL_LINE, GL_POLYGON_OFFSET_LINE, -1, -1));
  scenes.push_back(offset_scene("line_offset_farther", GL_LINE, GL_POLYGON_OFFSET_LINE, 1, 4));
  scenes.push_back(offset_scene("point_offset_nearer", GL_POINT, GL_POLYGON_OFFSET_POINT, -2, 0));
  scenes.push_back(
      offset_scene("line_offset_not_for_points", GL_POINT, GL_POLYGON_OFFSET_LINE, -9, -9));
  scenes.push_back(
      solid_scene("line_flat_lit_from_nearby", GL_FRONT_AND_BACK, GL_LINE, light_from_nearby));
  scenes.push_back(
      solid_scene("point_flat_lit_from_nearby", GL_FRONT_AND_BACK, GL_POINT, light_from_nearby));
  scenes.push_back(
      solid_scene("line_flat_two_sided", GL_FRONT_AND_BACK, GL_LINE, [](const GlFunctions& gl) {
        light_from_nearby(gl);
        gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
        gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
        use_turquoise(gl, GL_BACK);
      }));
  scenes.push_back(
      solid_scene("line_blended", GL_FRONT_AND_BACK, GL_LINE, [](const GlFunctions& gl) {
        gl.Disable(GL_DEPTH_TEST);
        gl.Enable(GL_BLEND);
        gl.BlendFunc(GL_ONE, GL_ONE);
      }));
  scenes.push_back(
      solid_scene("point_blended", GL_FRONT_AND_BACK, GL_POINT, [](const GlFunctions& gl) {
        gl.Disable(GL_DEPTH_TEST);
        gl.Enable(GL_BLEND);
        gl.BlendFunc(GL_ONE, GL_ONE);
      }));
  scenes.push_back({"edge_flags_of_strips",
                    [](const GlFunctions& gl) { draw_strips_as_lines(gl, true); },
                    {.mesa_departure = "M12",
                     .reference = [](const GlFunctions& gl) { draw_strips_as_lines(gl, false); }}});
  scenes.push_back({"edge_flag_array", draw_edge_flag_array, {.few_colors = true}});
  scenes.push_back({"front_line_back_point", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.PolygonMode(GL_FRONT, GL_LINE);
                      gl.PolygonMode(GL_BACK, GL_POINT);
                      gl.PointSize(4);
                      draw_half_tube(gl);
                    }});
  scenes.push_back(
      other_offset_scene("filled_with_offset_of_lines", GL_FILL, GL_POLYGON_OFFSET_LINE));
  scenes.push_back(
      other_offset_scene("filled_with_offset_of_points", GL_FILL, GL_POLYGON_OFFSET_POINT));
  scenes.push_back(
      other_offset_scene("lines_with_offset_of_filled", GL_LINE, GL_POLYGON_OFFSET_FILL));
  scenes.push_back(
      other_offset_scene("points_with_offset_of_filled", GL_POINT, GL_POLYGON_OFFSET_FILL));
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
