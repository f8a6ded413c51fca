// glBitmap at a raster position (GL 2.1 spec 3.7).
#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

// An F of 8 × 8 pixels, the bottom row first.
constexpr std::array<GLubyte, 8> kLetter{0xC0, 0xC0, 0xC0, 0xFC, 0xFC, 0xC0, 0xFE, 0xFE};

void letter(const GlFunctions& gl, float move = 10) {
  gl.Bitmap(8, 8, 0, 0, move, 0, kLetter.data());
}

// 19 × 7 pixels whose rows need padding.
std::vector<GLubyte> wide_pattern() {
  std::vector<GLubyte> bits(64 * 16);
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = static_cast<GLubyte>(i * 73 + i / 5);
  return bits;
}

Scene flat(std::string name, Draw draw) {
  return {std::move(name),
          [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
            draw(gl);
          },
          {.few_colors = true}};
}

// Lit bitmaps of one pixel each, or points in their place.
void lit_pixels(const GlFunctions& gl, const Draw& set, bool as_points) {
  begin_lit_scene(gl);
  set(gl);
  constexpr GLubyte pixel = 0x80;
  for (int i = 0; i < 60; ++i) {
    const float at = 0.02F * static_cast<float>(i) - 0.6F;
    gl.Normal3f(at, 0.4F - at, 0.7F);
    gl.FogCoordf(3 + 4 * at);
    if (as_points) {
      gl.Begin(GL_POINTS);
      gl.Vertex3f(at, 0.3F * at, 0.2F);
      gl.End();
    } else {
      gl.RasterPos3f(at, 0.3F * at, 0.2F);
      gl.Bitmap(1, 1, 0, 0, 0, 0, &pixel);
    }
  }
}

Scene departure(std::string name, Draw set) {
  return {std::move(name),
          [=](const GlFunctions& gl) { lit_pixels(gl, set, false); },
          {.mesa_departure = "M17",
           .reference = [=](const GlFunctions& gl) { lit_pixels(gl, set, true); }}};
}

Draw with_store(GLenum name, GLint value) {
  return [=](const GlFunctions& gl) {
    const std::vector<GLubyte> bits = wide_pattern();
    gl.PixelStorei(name, value);
    gl.RasterPos2f(-0.8F, -0.5F);
    gl.Bitmap(19, 7, 0, 0, 30, 11, bits.data());
    gl.Color3f(0.2F, 0.6F, 0.9F);
    gl.RasterPos2f(0.1F, 0.3F);
    gl.Bitmap(19, 7, 0, 0, 0, 0, bits.data());
  };
}

}  // namespace

std::vector<Scene> bitmap_scenes() {
  return {
      flat("color_is_taken_with_the_position",
           [](const GlFunctions& gl) {
             gl.Color4f(0.9F, 0.4F, 0.1F, 0.5F);
             gl.RasterPos2f(-0.9F, 0);
             letter(gl);
             gl.Color3f(0, 1, 0);
             letter(gl);
             gl.RasterPos2f(-0.5F, -0.5F);
             for (int i = 0; i < 6; ++i) letter(gl, 9.25F);
           }),
      flat("positions_between_pixels",
           [](const GlFunctions& gl) {
             for (int i = 0; i < 12; ++i) {
               gl.Color3f(1, 0.08F * static_cast<float>(i), 0.3F);
               gl.RasterPos2f(-0.95F + 0.1513F * static_cast<float>(i),
                              -0.9F + 0.1479F * static_cast<float>(i));
               letter(gl);
             }
           }),
      flat("origin_and_move",
           [](const GlFunctions& gl) {
             gl.RasterPos2f(0, 0);
             gl.Bitmap(8, 8, 3.5F, -2.25F, -12.5F, 7.75F, kLetter.data());
             gl.Bitmap(8, 8, 0, 4, 20, -30, kLetter.data());
             gl.Bitmap(0, 0, 0, 0, 9, 9, nullptr);
             letter(gl);
           }),
      flat("partly_outside_the_viewport",
           [](const GlFunctions& gl) {
             gl.Viewport(30, 30, 60, 60);
             gl.RasterPos2f(0.95F, 0.95F);
             letter(gl);
             gl.RasterPos2f(-0.95F, -0.95F);
             gl.Bitmap(8, 8, 6, 6, 0, 0, kLetter.data());
             gl.WindowPos2i(0, 124);
             gl.Bitmap(8, 8, 3, 0, 0, 0, kLetter.data());
           }),
      flat("invalid_position_draws_and_moves_nothing",
           [](const GlFunctions& gl) {
             gl.RasterPos2f(0, 0);
             letter(gl);
             gl.RasterPos2f(2, 0);
             letter(gl);
             gl.RasterPos2f(-0.5F, 0.5F);
             letter(gl);
           }),
      flat("window_positions",
           [](const GlFunctions& gl) {
             gl.Color3f(0.3F, 0.9F, 0.5F);
             gl.WindowPos2f(20.5F, 30.75F);
             letter(gl);
             gl.WindowPos3i(70, 90, 0);
             letter(gl);
           }),
      flat("unpack_lsb_first", with_store(GL_UNPACK_LSB_FIRST, 1)),
      flat("unpack_row_length", with_store(GL_UNPACK_ROW_LENGTH, 45)),
      flat("unpack_alignment", with_store(GL_UNPACK_ALIGNMENT, 8)),
      flat("unpack_skip_pixels", with_store(GL_UNPACK_SKIP_PIXELS, 5)),
      flat("unpack_skip_rows", with_store(GL_UNPACK_SKIP_ROWS, 3)),
      flat("depth_test_and_range",
           [](const GlFunctions& gl) {
             gl.DepthRange(0.2, 0.7);
             gl.Color3f(0.2F, 0.2F, 0.8F);
             gl.Rectf(-0.5F, -0.5F, 0.5F, 0.5F);
             gl.Color3f(1, 1, 0);
             for (int i = 0; i < 8; ++i) {
               gl.RasterPos3f(-0.9F + 0.2F * static_cast<float>(i), 0.1F, i % 2 ? 0.4F : -0.4F);
               letter(gl);
             }
           }),
      flat("blend",
           [](const GlFunctions& gl) {
             gl.Color3f(0.2F, 0.5F, 0.8F);
             gl.Rectf(-0.5F, -0.5F, 0.5F, 0.5F);
             gl.Disable(GL_DEPTH_TEST);
             gl.Enable(GL_BLEND);
             gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
             gl.Color4f(1, 0.9F, 0.1F, 0.4F);
             gl.RasterPos2f(-0.2F, 0);
             letter(gl);
           }),
      flat("between_primitives",
           [](const GlFunctions& gl) {
             gl.Disable(GL_DEPTH_TEST);
             for (int i = 0; i < 5; ++i) {
               const float at = -0.8F + 0.3F * static_cast<float>(i);
               gl.Color3f(0.2F * static_cast<float>(i), 0.5F, 0.9F);
               gl.Rectf(at, at, at + 0.2F, at + 0.2F);
               gl.Color3f(1, 0.6F, 0.2F * static_cast<float>(i));
               gl.RasterPos2f(at, at);
               letter(gl);
             }
           }),
      flat("culling_and_polygon_modes_do_not_matter",
           [](const GlFunctions& gl) {
             gl.Enable(GL_CULL_FACE);
             gl.CullFace(GL_FRONT_AND_BACK);
             gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
             gl.ShadeModel(GL_FLAT);
             gl.RasterPos2f(-0.2F, 0);
             letter(gl);
             letter(gl);
           }),
      flat("font_of_lists",
           [](const GlFunctions& gl) {
             const std::vector<GLubyte> bits = wide_pattern();
             const GLuint base = gl.GenLists(32);
             for (GLuint i = 0; i < 32; ++i) {
               gl.NewList(base + i, GL_COMPILE);
               gl.Bitmap(6, 10, 0, 2, 7, 0, bits.data() + 3 * i);
               gl.EndList();
             }
             gl.ListBase(base);
             for (int line = 0; line < 5; ++line) {
               gl.Color3f(1, 0.2F * static_cast<float>(line), 0.4F);
               gl.RasterPos2f(-0.9F, 0.7F - 0.3F * static_cast<float>(line));
               gl.CallLists(12, GL_UNSIGNED_BYTE, "\1\2\3\4\5\6\7\10\11\12\13\14");
             }
           }),
      flat("larger_than_a_part",
           [](const GlFunctions& gl) {
             std::vector<GLubyte> bits(1200 / 8 * 700);
             for (std::size_t i = 0; i < bits.size(); ++i)
               bits[i] = static_cast<GLubyte>(i * 37 + i / 150);
             gl.WindowPos2i(0, 0);
             gl.Bitmap(1200, 700, 450, 460, 0, 0, bits.data());
           }),
      flat("scissor_and_color_mask",
           [](const GlFunctions& gl) {
             gl.Enable(GL_SCISSOR_TEST);
             gl.Scissor(60, 60, 12, 7);
             gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
             gl.RasterPos2f(-0.05F, -0.05F);
             for (int i = 0; i < 2; ++i) letter(gl, 4);
           }),
      {"lit",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
         for (int i = 0; i < 10; ++i) {
           const float at = 0.22F * static_cast<float>(i) - 1;
           gl.Normal3f(at, 0.4F, 0.8F);
           gl.RasterPos3f(at, 0.3F * at, 0.2F);
           letter(gl);
         }
       }},
      departure("lit_by_point_lights_and_scaled_normals",
                [](const GlFunctions& gl) {
                  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
                  use_positional_light(gl, GL_LIGHT1, vec(1, 2, 1), vec(0.9F, 0.5F, 0.3F));
                  gl.Lightf(GL_LIGHT1, GL_LINEAR_ATTENUATION, 0.2F);
                  gl.Lightf(GL_LIGHT1, GL_SPOT_CUTOFF, 80);
                  gl.Enable(GL_NORMALIZE);
                  gl.Scalef(1.5F, 0.75F, 2);
                }),
      departure("separate_specular_color",
                [](const GlFunctions& gl) {
                  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
                }),
      flat("alpha_test",
           [](const GlFunctions& gl) {
             gl.Enable(GL_ALPHA_TEST);
             gl.AlphaFunc(GL_GREATER, 0.5F);
             for (int i = 0; i < 8; ++i) {
               gl.Color4f(1, 0.5F, 0, 0.125F * static_cast<float>(i));
               gl.RasterPos2f(-0.9F + 0.2F * static_cast<float>(i), 0);
               letter(gl);
             }
           }),
      flat("clip_planes_do_not_cut",
           [](const GlFunctions& gl) {
             constexpr GLdouble plane[] = {1, 0, 0, 0};
             gl.ClipPlane(GL_CLIP_PLANE0, plane);
             gl.Enable(GL_CLIP_PLANE0);
             gl.Color3f(0.2F, 0.5F, 0.9F);
             gl.Rectf(-0.5F, -0.5F, 0.5F, -0.2F);
             gl.RasterPos2f(0.01F, 0);
             gl.Bitmap(8, 8, 4, 0, 0, 0, kLetter.data());
             gl.Rectf(-0.5F, 0.2F, 0.5F, 0.5F);
           }),
      departure("fog",
                [](const GlFunctions& gl) {
                  gl.Enable(GL_FOG);
                  gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
                  gl.Fogf(GL_FOG_DENSITY, 0.3F);
                  gl.Fogfv(GL_FOG_COLOR, vec(0.2F, 0.4F, 0.8F));
                }),
      flat("color_sum",
           [](const GlFunctions& gl) {
             gl.Enable(GL_COLOR_SUM);
             gl.Color3f(0.5F, 0.1F, 0);
             gl.SecondaryColor3f(0.2F, 0.3F, 0.4F);
             gl.RasterPos2f(0, 0);
             letter(gl);
             letter(gl);
           }),
  };
}

}  // namespace legacy_gl::test
