// GL 2.1 spec 3.5.2: the pattern lies on the window, and concerns filled polygons alone.
#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

using Mask = std::array<GLubyte, 128>;

// No symmetry: rows, columns and the order of bits all show.
Mask uneven_mask() {
  Mask mask{};
  unsigned seed = 12345;
  for (GLubyte& byte : mask) {
    seed = seed * 1103515245U + 12345U;
    byte = static_cast<GLubyte>(seed >> 16);
  }
  for (std::size_t i = 0; i < 8; ++i) mask[i] = 0xff;
  for (std::size_t row = 0; row < 32; ++row) mask[4 * row] |= 0xe0;
  return mask;
}

Mask checks() {
  Mask mask{};
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = i / 4 % 2 == 0 ? 0x55 : 0xaa;
  return mask;
}

void stipple(const GlFunctions& gl, const Mask& mask) {
  gl.PolygonStipple(mask.data());
  gl.Enable(GL_POLYGON_STIPPLE);
}

void draw_solids(const GlFunctions& gl) {
  gl.Rotatef(30, 1, 1, 0);
  draw_cube(gl, 0.6F);
  draw_sphere(gl, 0.85F, 9, 6);
}

Scene solids_scene(std::string name, Draw set) {
  return {std::move(name), [set = std::move(set)](const GlFunctions& gl) {
            begin_lit_scene(gl);
            stipple(gl, checks());
            set(gl);
            draw_solids(gl);
          }};
}

void draw_bytes_of(const GlFunctions& gl, const Mask& mask) {
  std::array<GLubyte, 128> got{};
  gl.GetPolygonStipple(got.data());
  if (got != mask) gl.Color3f(0, 0, 1);
  gl.Rectf(-0.9F, -0.8F, 0.7F, 0.9F);
}

void draw_one_face_after_the_other(const GlFunctions& gl) {
  begin_lit_scene(gl);
  stipple(gl, checks());
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_FRONT);
  draw_half_tube(gl);
  gl.CullFace(GL_BACK);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  draw_half_tube(gl);
}

}  // namespace

std::vector<Scene> polygon_stipple_scenes() {
  return {
      {"uneven",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         stipple(gl, uneven_mask());
         gl.Color3f(0.9F, 0.4F, 0.1F);
         gl.Rectf(-1, -1, 1, 1);
       },
       {.few_colors = true}},
      {"initial_pattern",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         gl.Enable(GL_POLYGON_STIPPLE);
         gl.Rectf(-0.5F, -1, 1, 0.5F);
       },
       {.few_colors = true}},
      {"stays_on_the_window",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         stipple(gl, uneven_mask());
         for (int i = 0; i < 4; ++i)
           in_quarter(gl, i % 2, i / 2, [i](const GlFunctions& g) {
             g.Viewport(64 * (i % 2) + 5 * i, 64 * (i / 2) + 3 * i, 50, 45);
             color_by_position(g, 0.3F * static_cast<float>(i), 0.2F, 0.5F);
             g.Rectf(-0.9F, -0.9F, 0.9F, 0.9F);
           });
       }},
      solids_scene("lit", [](const GlFunctions&) {}),
      solids_scene("two_sided",
                   [](const GlFunctions& gl) {
                     gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
                     use_brass(gl, GL_BACK);
                   }),
      solids_scene("flat", [](const GlFunctions& gl) { gl.ShadeModel(GL_FLAT); }),
      solids_scene("with_fog_and_alpha_test",
                   [](const GlFunctions& gl) {
                     gl.Enable(GL_FOG);
                     gl.Fogf(GL_FOG_DENSITY, 0.2F);
                     gl.Enable(GL_ALPHA_TEST);
                     gl.AlphaFunc(GL_GREATER, 0.1F);
                   }),
      // Lines and points of polygons have no pattern; the other face has.
      solids_scene("polygons_as_lines",
                   [](const GlFunctions& gl) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); }),
      solids_scene("polygons_as_points",
                   [](const GlFunctions& gl) {
                     gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
                     gl.PointSize(5);
                   }),
      {"front_as_lines",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         stipple(gl, checks());
         gl.PolygonMode(GL_FRONT, GL_LINE);
         draw_half_tube(gl);
       },
       {.mesa_departure = "M19", .reference = draw_one_face_after_the_other}},
      {"not_on_lines_and_points",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         stipple(gl, checks());
         gl.LineWidth(3);
         gl.PointSize(8);
         gl.Color3f(1, 0.5F, 0);
         gl.Begin(GL_LINES);
         gl.Vertex2f(-0.9F, -0.8F);
         gl.Vertex2f(0.8F, 0.5F);
         gl.End();
         gl.Begin(GL_POINTS);
         gl.Vertex2f(-0.5F, 0.5F);
         gl.End();
         gl.Begin(GL_TRIANGLES);
         gl.Vertex2f(0.2F, -0.9F);
         gl.Vertex2f(0.9F, -0.9F);
         gl.Vertex2f(0.9F, 0.2F);
         gl.End();
       },
       {.few_colors = true}},
      {"not_on_pixel_rectangles",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         stipple(gl, checks());
         std::array<GLubyte, 16 * 16 * 4> pixels{};
         for (std::size_t i = 0; i < pixels.size(); ++i)
           pixels[i] = static_cast<GLubyte>(128 + i % 100);
         gl.RasterPos2f(-0.5F, -0.5F);
         gl.PixelZoom(3, 3);
         gl.DrawPixels(16, 16, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
         gl.PixelZoom(1, 1);
         gl.Bitmap(32, 30, 20, 20, 0, 0, pixels.data());
         gl.Rectf(0.3F, 0.4F, 0.9F, 0.8F);
       }},
      {"list",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.NewList(1, GL_COMPILE);
         stipple(gl, uneven_mask());
         draw_solids(gl);
         gl.Disable(GL_POLYGON_STIPPLE);
         draw_sphere(gl, 0.3F);
         gl.EndList();
         gl.CallList(1);
       }},
      {"list_called_with_and_without",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.NewList(1, GL_COMPILE);
         draw_sphere(gl, 0.4F);
         gl.EndList();
         gl.Translatef(-0.5F, 0, 0);
         gl.CallList(1);
         stipple(gl, checks());
         gl.Translatef(1, 0, 0);
         gl.CallList(1);
       }},
      // Small objects of one batch: their pattern is the time's when each is drawn.
      {"pattern_changes_between_small_objects",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.Enable(GL_POLYGON_STIPPLE);
         for (int i = 0; i < 16; ++i) {
           Mask mask = checks();
           for (GLubyte& byte : mask) byte = static_cast<GLubyte>(byte << i % 3);
           if (i % 4 == 0) gl.PolygonStipple(mask.data());
           gl.PushMatrix();
           gl.Translatef(-0.9F + 0.6F * static_cast<float>(i % 4),
                         -0.9F + 0.6F * static_cast<float>(i / 4), 0);
           gl.Rotatef(20.0F * static_cast<float>(i), 1, 1, 0);
           draw_cube(gl, 0.2F);
           gl.PopMatrix();
         }
       }},
      {"textured",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         stipple(gl, uneven_mask());
         std::array<GLubyte, 4 * 4 * 4> texels{};
         for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<GLubyte>(i * 4);
         gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                       texels.data());
         gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
         gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
         gl.Enable(GL_TEXTURE_2D);
         gl.Begin(GL_QUADS);
         for (int i = 0; i < 4; ++i) {
           const float x = i == 1 || i == 2 ? 0.9F : -0.8F;
           const float y = i >= 2 ? 0.8F : -0.9F;
           gl.TexCoord2f(x, y);
           gl.Vertex2f(x, y);
         }
         gl.End();
       }},
      {"attribute_groups",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         stipple(gl, uneven_mask());
         gl.PushAttrib(GL_POLYGON_STIPPLE_BIT);  // the pattern
         stipple(gl, checks());
         gl.PushAttrib(GL_ENABLE_BIT);
         gl.Disable(GL_POLYGON_STIPPLE);
         gl.PopAttrib();
         gl.PushAttrib(GL_POLYGON_BIT);
         gl.Disable(GL_POLYGON_STIPPLE);
         gl.PopAttrib();
         gl.Color3f(1, 1, 0);
         gl.Rectf(-1, -1, 0, 1);
         gl.PopAttrib();
         gl.Color3f(0, 1, 1);
         gl.Rectf(0, -1, 1, 1);
       },
       {.few_colors = true}},
      {"pixel_store",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         std::array<GLubyte, 1024> memory{};
         for (std::size_t i = 0; i < memory.size(); ++i)
           memory[i] = static_cast<GLubyte>(i * 37 + i / 8 * 11);
         gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 75);
         gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 8);  // not 5: M24
         gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 3);
         gl.PixelStorei(GL_UNPACK_LSB_FIRST, 1);
         gl.PixelStorei(GL_UNPACK_ALIGNMENT, 8);
         gl.PolygonStipple(memory.data());
         gl.Enable(GL_POLYGON_STIPPLE);
         gl.Color3f(0.8F, 0.9F, 0.2F);
         gl.Rectf(-1, -1, 1, 1);
       },
       {.few_colors = true}},
      {"returned_pattern",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         stipple(gl, uneven_mask());
         draw_bytes_of(gl, uneven_mask());
       },
       {.few_colors = true}},
  };
}

}  // namespace legacy_gl::test
