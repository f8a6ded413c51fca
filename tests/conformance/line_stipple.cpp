// GL 2.1 spec 3.4.2: the pattern goes along a line, in pixels of its major direction, anew for each
// segment of GL_LINES, and on along strips, loops and the edges of a polygon.
#include <initializer_list>
#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

void stipple(const GlFunctions& gl, int factor, unsigned pattern) {
  gl.LineStipple(factor, static_cast<GLushort>(pattern));
  gl.Enable(GL_LINE_STIPPLE);
}

void draw_star(const GlFunctions& gl, int count) {
  gl.Begin(GL_LINES);
  for (int i = 0; i < count; ++i) {
    const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(count) + 0.05F;
    const float x = std::cos(angle), y = std::sin(angle);
    color_by_position(gl, x, y, 0);
    gl.Normal3f(0, 0.28F, 0.96F);
    gl.Vertex2f(0.2F * x, 0.2F * y);
    color_by_position(gl, y, x, 0.5F);
    gl.Vertex2f(0.93F * x, 0.91F * y);
  }
  gl.End();
}

Scene star_scene(std::string name, int factor, unsigned pattern, float width, Draw set = {}) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            stipple(gl, factor, pattern);
            gl.LineWidth(width);
            if (set) set(gl);
            draw_star(gl, 17);
          }};
}

Scene mode_scene(std::string name, GLenum mode, int count, bool flat) {
  return {std::move(name),
          [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            stipple(gl, 2, 0x3f29);
            gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            gl.ShadeModel(flat ? GL_FLAT : GL_SMOOTH);
            draw_ring(gl, mode, count);
          },
          {.few_colors = flat}};
}

void corner(const GlFunctions& gl, GLenum mode, int i) {
  const float f = static_cast<float>(i), angle = 0.7854F * f + 0.1F;
  const bool strip = mode == GL_TRIANGLE_STRIP || mode == GL_QUAD_STRIP;
  const float x = strip ? -0.9F + 0.25F * f : 0.9F * std::cos(angle);
  const float y = strip ? (i % 2 == 0 ? -0.7F : 0.7F) : 0.85F * std::sin(angle);
  color_by_position(gl, x, y, 0.1F * f);
  gl.Vertex2f(x, y);
}

void draw_loop(const GlFunctions& gl, GLenum mode, std::initializer_list<int> corners) {
  gl.Begin(GL_LINE_LOOP);
  for (const int i : corners) corner(gl, mode, i);
  gl.End();
}

// The polygons that a primitive of 8 vertices has, from the first vertex of each on (GL 2.1 spec
// 2.6.1).
void draw_loops(const GlFunctions& gl, GLenum mode) {
  for (int i = 0; i < 8; ++i) {
    const bool has_triangle = i + 2 < 8, has_quad = i + 3 < 8;
    if (mode == GL_TRIANGLES && i % 3 == 0 && has_triangle) draw_loop(gl, mode, {i, i + 1, i + 2});
    if (mode == GL_TRIANGLE_STRIP && has_triangle)
      draw_loop(gl, mode, {i + i % 2, i + 1 - i % 2, i + 2});
    if (mode == GL_TRIANGLE_FAN && i > 0 && i + 1 < 8) draw_loop(gl, mode, {0, i, i + 1});
    if (mode == GL_QUADS && i % 4 == 0) draw_loop(gl, mode, {i, i + 1, i + 2, i + 3});
    if (mode == GL_QUAD_STRIP && i % 2 == 0 && has_quad)
      draw_loop(gl, mode, {i, i + 1, i + 3, i + 2});
  }
}

// Mesa begins the pattern of a triangle or a quad with its last edge.
Scene outline_scene(std::string name, GLenum mode) {
  const auto begin = [](const GlFunctions& gl) {
    begin_flat_scene(gl);
    stipple(gl, 2, 0x3f29);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  };
  return {std::move(name),
          [=](const GlFunctions& gl) {
            begin(gl);
            gl.Begin(mode);
            for (int i = 0; i < 8; ++i) corner(gl, mode, i);
            gl.End();
          },
          {.mesa_departure = "M26", .reference = [=](const GlFunctions& gl) {
             begin(gl);
             draw_loops(gl, mode);
           }}};
}

// glRect is GL_POLYGON (GL 2.1 spec 2.10); Mesa draws GL_QUADS.
void draw_rectangle(const GlFunctions& gl, bool by_rect) {
  begin_flat_scene(gl);
  stipple(gl, 2, 0x0f37);
  gl.Color3f(1, 0.5F, 0.2F);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  if (by_rect) return gl.Rectf(-0.7F, -0.6F, 0.8F, 0.75F);
  gl.Begin(GL_POLYGON);
  gl.Vertex2f(-0.7F, -0.6F);
  gl.Vertex2f(0.8F, -0.6F);
  gl.Vertex2f(0.8F, 0.75F);
  gl.Vertex2f(-0.7F, 0.75F);
  gl.End();
}

// Mesa makes separate lines of a list's strips where others come before.
void draw_strip_of_list(const GlFunctions& gl, bool in_list) {
  begin_flat_scene(gl);
  stipple(gl, 2, 0x3f29);
  if (in_list) gl.NewList(1, GL_COMPILE);
  draw_star(gl, 9);
  draw_ring(gl, GL_LINE_STRIP, 8);
  if (!in_list) return;
  gl.EndList();
  gl.CallList(1);
}

// Colours that are clamped before they are interpolated, on lines, strips and outlines.
Scene bright_scene(std::string name, float scale, GLenum shade_model, Draw set = {}) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            stipple(gl, 1, 0xeeee);
            gl.ShadeModel(shade_model);
            gl.Enable(GL_COLOR_SUM);
            gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            gl.Scalef(scale, scale, 1);
            if (set) set(gl);
            for (const GLenum mode : {GLenum{GL_LINES}, GLenum{GL_LINE_STRIP}, GLenum{GL_LINE_LOOP},
                                      GLenum{GL_POLYGON}}) {
              gl.Begin(mode);
              for (int i = 0; i < 8; ++i) {
                const float part = static_cast<float>(i) / 8, a = 6.2831853F * part;
                gl.Color4f(3 * std::cos(a), 1 - 2 * part, i % 2 ? 1.0F : -1.0F, 1);
                gl.SecondaryColor3f(i % 3 ? -2.0F : 0.5F, 0.25F - part, 0);
                gl.Vertex2f(0.95F * std::cos(a), 0.95F * std::sin(a));
              }
              gl.End();
              gl.Scalef(0.86F, 0.86F, 1);
            }
          }};
}

}  // namespace

std::vector<Scene> line_stipple_scenes() {
  std::vector<Scene> scenes = {
      star_scene("every_other_pixel", 1, 0x5555, 1),
      star_scene("dashes", 1, 0x00ff, 1),
      star_scene("uneven", 3, 0x1c47, 1),
      star_scene("wide", 2, 0x0f35, 3),
      star_scene("wide_even", 1, 0x3333, 4),
      star_scene("initial_pattern", 1, 0xffff, 1),
      star_scene("factor_below_one", -3, 0x5335, 1),
      star_scene("factor_beyond_256", 100000, 0x0001, 1),
      star_scene("flat", 1, 0x3c3c, 1, [](const GlFunctions& gl) { gl.ShadeModel(GL_FLAT); }),
      star_scene("clipped", 2, 0x6db6, 1, [](const GlFunctions& gl) { gl.Scalef(1.7F, 1.5F, 1); }),
      star_scene("clip_plane", 2, 0x4b4b, 1,
                 [](const GlFunctions& gl) {
                   const std::array<GLdouble, 4> plane{1, 0.4, 0, 0.2};
                   gl.ClipPlane(GL_CLIP_PLANE0, plane.data());
                   gl.Enable(GL_CLIP_PLANE0);
                 }),
      bright_scene("colors_beyond_one", 1, GL_SMOOTH),
      bright_scene("colors_beyond_one_cut", 1.6F, GL_SMOOTH),
      bright_scene("colors_beyond_one_flat", 1, GL_FLAT),
      bright_scene("colors_beyond_one_wide", 1, GL_SMOOTH,
                   [](const GlFunctions& gl) { gl.LineWidth(3); }),
      mode_scene("strip", GL_LINE_STRIP, 8, false),
      mode_scene("strip_flat", GL_LINE_STRIP, 8, true),
      mode_scene("loop", GL_LINE_LOOP, 7, false),
      outline_scene("triangles", GL_TRIANGLES),
      outline_scene("triangle_strip", GL_TRIANGLE_STRIP),
      outline_scene("triangle_fan", GL_TRIANGLE_FAN),
      outline_scene("quads", GL_QUADS),
      outline_scene("quad_strip", GL_QUAD_STRIP),
      mode_scene("polygon", GL_POLYGON, 7, false),
      mode_scene("polygon_flat", GL_POLYGON, 7, true),
  };
  scenes.push_back(star_scene("lit", 1, 0x3535, 1, [](const GlFunctions& gl) {
    gl.Enable(GL_LIGHTING);
    use_directional_light(gl, GL_LIGHT0, vec(0.6F, 0.5F, 0.7F));
    gl.Enable(GL_COLOR_MATERIAL);
  }));
  scenes.push_back(star_scene("lit_flat_by_position", 1, 0x3535, 1, [](const GlFunctions& gl) {
    gl.Enable(GL_LIGHTING);
    gl.ShadeModel(GL_FLAT);
    use_positional_light(gl, GL_LIGHT0, vec(0.3F, 0.5F, 1), vec(1, 0.8F, 0.6F));
  }));
  scenes.push_back({"perspective", [](const GlFunctions& gl) {
                      begin_scene(gl);
                      stipple(gl, 2, 0x2f4d);
                      gl.Rotatef(70, 1, 0.2F, 0);
                      for (int i = 0; i < 12; ++i) {
                        gl.Color3f(1 - 0.08F * static_cast<float>(i), 0.5F, 0.7F);
                        gl.Begin(GL_LINES);
                        gl.Vertex3f(0.15F * static_cast<float>(i) - 0.9F, -3, 0);
                        gl.Vertex3f(0.15F * static_cast<float>(i) - 0.8F, 3.5F, 0.1F);
                        gl.End();
                      }
                    }});
  // Lines of every slope, with ends at and between pixel centres.
  scenes.push_back({"line_ends", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.MatrixMode(GL_PROJECTION);
                      gl.LoadIdentity();
                      gl.Ortho(0, scene_size, 0, scene_size, -1, 1);
                      stipple(gl, 1, 0x6d35);
                      gl.Begin(GL_LINES);
                      for (int i = 0; i < 30; ++i) {
                        const float offset = 0.25F * static_cast<float>(i % 4);
                        const float x = 4.0F * static_cast<float>(i) + 3;
                        color_by_position(gl, 0.06F * static_cast<float>(i) - 1, 0.3F, 0);
                        gl.Vertex2f(x + offset, 5 + offset);
                        gl.Vertex2f(x + static_cast<float>(i % 7) - 3, 60 + 2 * offset);
                        gl.Vertex2f(5 + offset, x + offset);
                        gl.Vertex2f(70 + 2 * offset, x + static_cast<float>(i % 5));
                        gl.Vertex2f(123 - offset, x + offset);
                        gl.Vertex2f(80, x + offset);
                      }
                      gl.End();
                    }});
  // A viewport whose pixels no float has exactly. Lines on their edges Mesa rounds either way.
  scenes.push_back({"odd_viewport", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.Viewport(7, 3, 101, 113);
                      gl.MatrixMode(GL_PROJECTION);
                      gl.LoadIdentity();
                      gl.Ortho(0, 101, 0, 113, -1, 1);
                      stipple(gl, 1, 0x6d35);
                      gl.Begin(GL_LINES);
                      for (int i = 0; i < 25; ++i) {
                        const float y = 4.0F * static_cast<float>(i) + (i % 2 ? 0.5F : 0.2F);
                        color_by_position(gl, 0.08F * static_cast<float>(i) - 1, 0.3F, 0);
                        gl.Vertex2f(i % 3 ? 3.2F : 3.6F, y);
                        gl.Vertex2f(97.3F, y + 0.1F);
                      }
                      gl.End();
                    }});
  scenes.push_back({"rectangle",
                    [](const GlFunctions& gl) { draw_rectangle(gl, true); },
                    {.mesa_departure = "M26",
                     .reference = [](const GlFunctions& gl) { draw_rectangle(gl, false); },
                     .few_colors = true}});
  scenes.push_back({"turned_polygons",
                    [](const GlFunctions& gl) {
                      begin_scene(gl);
                      stipple(gl, 1, 0x3333);
                      gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
                      gl.Color3f(0.2F, 0.8F, 1);  // one: row M29
                      for (int i = 0; i < 5; ++i) {
                        gl.Rotatef(33, 1, 1, 0);
                        gl.Begin(GL_POLYGON);
                        for (const float angle : {0.1F, 1.0F, 2.2F, 3.5F, 4.1F, 5.2F})
                          gl.Vertex2f(0.9F * std::cos(angle), 0.85F * std::sin(angle));
                        gl.End();
                      }
                    },
                    {.few_colors = true}});
  scenes.push_back({"polygons_and_points_stay", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      stipple(gl, 1, 0x3333);
                      gl.PointSize(5);
                      draw_sphere(gl, 0.6F);
                      gl.Begin(GL_POINTS);
                      gl.Vertex3f(0.9F, 0.9F, 0);
                      gl.End();
                      gl.Disable(GL_LIGHTING);
                      gl.Begin(GL_LINES);
                      gl.Vertex3f(-1, -0.8F, 0.4F);
                      gl.Vertex3f(0.9F, 1, 0.9F);
                      gl.End();
                    }});
  scenes.push_back({"list", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.NewList(1, GL_COMPILE);
                      stipple(gl, 2, 0x2727);
                      draw_star(gl, 9);
                      gl.EndList();
                      gl.NewList(2, GL_COMPILE);
                      draw_star(gl, 7);
                      gl.EndList();
                      gl.CallList(1);
                      gl.Scalef(0.5F, 0.5F, 1);
                      gl.CallList(2);
                      gl.Disable(GL_LINE_STIPPLE);
                      gl.Scalef(0.5F, 0.5F, 1);
                      gl.CallList(2);
                    }});
  scenes.push_back({"strip_of_a_list",
                    [](const GlFunctions& gl) { draw_strip_of_list(gl, true); },
                    {.mesa_departure = "M22",
                     .reference = [](const GlFunctions& gl) { draw_strip_of_list(gl, false); }}});
  scenes.push_back({"arrays",
                    [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      stipple(gl, 1, 0x0f0f);
                      std::array<std::array<GLfloat, 2>, 600> positions{};
                      for (std::size_t i = 0; i < positions.size(); ++i) {
                        const float angle = 0.06F * static_cast<float>(i);
                        const float radius = 0.0016F * static_cast<float>(i);
                        positions[i] = {radius * std::cos(angle), radius * std::sin(angle)};
                      }
                      const std::array<GLushort, 4> elements{599, 300, 20, 450};
                      gl.VertexPointer(2, GL_FLOAT, 0, positions.data());
                      gl.EnableClientState(GL_VERTEX_ARRAY);
                      gl.Color3f(0.9F, 0.4F, 0.2F);
                      gl.DrawArrays(GL_LINE_STRIP, 0, 600);
                      gl.Color3f(0.2F, 0.7F, 0.9F);
                      gl.DrawElements(GL_LINE_LOOP, 4, GL_UNSIGNED_SHORT, elements.data());
                    },
                    {.few_colors = true}});
  scenes.push_back({"pattern_changes_between_lines", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.Enable(GL_LINE_STIPPLE);
                      for (int i = 0; i < 8; ++i) {
                        gl.LineStipple(1 + i % 3, static_cast<GLushort>(0x1111 * (i + 1)));
                        const float y = 0.23F * static_cast<float>(i) - 0.8F;
                        color_by_position(gl, y, 0.2F, 0);
                        gl.Begin(GL_LINES);
                        gl.Vertex2f(-0.9F, y);
                        gl.Vertex2f(0.87F, y + 0.1F);
                        gl.End();
                      }
                    }});
  scenes.push_back({"attribute_groups", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      stipple(gl, 2, 0x2727);
                      gl.PushAttrib(GL_LINE_BIT);
                      stipple(gl, 1, 0x5555);
                      gl.Disable(GL_LINE_STIPPLE);
                      gl.PushAttrib(GL_ENABLE_BIT);
                      gl.Enable(GL_LINE_STIPPLE);
                      gl.PopAttrib();
                      draw_star(gl, 5);
                      gl.PopAttrib();
                      gl.Scalef(-1, 1, 1);
                      draw_star(gl, 5);
                    }});
  return scenes;
}

}  // namespace legacy_gl::test
