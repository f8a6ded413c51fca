// glDrawPixels, glCopyPixels, pixel transfer and textured bitmaps (GL 2.1 spec 3.6, 4.3.3).
#include <cstring>

#include "conformance/feature_scenes.hpp"
#include "conformance/texture_kit.hpp"

namespace legacy_gl::test {

namespace {

// The picture is read by glReadPixels, which pixel transfer concerns.
void end_transfer(const GlFunctions& gl) {
  constexpr GLenum ones[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
  constexpr GLenum zeros[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS,
                              GL_MAP_COLOR};
  for (const GLenum name : ones) gl.PixelTransferf(name, 1);
  for (const GLenum name : zeros) gl.PixelTransferf(name, 0);
}

// Of `eight_bits` Mesa keeps no more on the way to a framebuffer of floats.
Scene flat(std::string name, Draw draw, bool eight_bits = false) {
  return {std::move(name),
          [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            gl.Disable(GL_DEPTH_TEST);
            gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
            draw(gl);
            end_transfer(gl);
          },
          {.filtered = eight_bits}};
}

std::vector<GLubyte> noise(std::size_t count) {
  std::vector<GLubyte> bytes(count);
  GLuint state = 12345;
  for (GLubyte& byte : bytes) {
    state = state * 1664525U + 1013904223U;
    byte = static_cast<GLubyte>(state >> 24);
  }
  return bytes;
}

// Floats in [0, 1].
std::vector<GLfloat> ramp(std::size_t count) {
  std::vector<GLfloat> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>(i * 37 % 101) / 100.0F;
  return values;
}

void rgba_image(const GlFunctions& gl, int width = 20, int height = 14) {
  const std::vector<GLubyte> image = texture_colors(width, height);
  gl.DrawPixels(width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
}

// Each image at a place of its own.
Draw formats(std::vector<std::pair<GLenum, GLenum>> pairs) {
  return [=](const GlFunctions& gl) {
    const std::vector<GLubyte> bytes = noise(4096);
    const std::vector<GLfloat> floats = ramp(4096);
    int i = 0;
    for (const auto& [format, type] : pairs) {
      gl.WindowPos2i(3 + i % 6 * 20, 3 + i / 6 * 20);
      const void* const data = type == GL_FLOAT ? static_cast<const void*>(floats.data())
                                                : static_cast<const void*>(bytes.data());
      gl.DrawPixels(17, 15, format, type, data);
      ++i;
    }
  };
}

Draw with_store(GLenum name, GLint value, GLenum type = GL_UNSIGNED_BYTE) {
  return [=](const GlFunctions& gl) {
    const std::vector<GLubyte> bytes = noise(std::size_t{64} * 64 * 8);
    gl.PixelStorei(name, value);
    gl.WindowPos2i(7, 9);
    gl.DrawPixels(23, 19, GL_RGB, type, bytes.data());
  };
}

// No pixel's edge meets a centre, which Mesa's rounding may take for either side; and sizes are
// whole: to a framebuffer object Mesa rounds them.
Draw zoomed(float x, float y) {
  return [=](const GlFunctions& gl) {
    gl.PixelZoom(x, y);
    gl.WindowPos2i(64, 64);
    rgba_image(gl);
  };
}

void rectangles(const GlFunctions& gl) {
  for (int i = 0; i < 6; ++i) {
    const float at = -0.9F + 0.25F * static_cast<float>(i);
    gl.Color4f(0.15F * static_cast<float>(i), 0.9F - at * at, 0.4F, 0.2F * static_cast<float>(i));
    gl.Rectf(at, -0.8F + 0.1F * static_cast<float>(i), at + 0.3F, 0.2F + at * 0.3F);
  }
}

// Pixel maps of colours as the image itself: Mesa's drawing takes wrong blue and alpha from maps,
// and does not shift indices (M18).
void mapped_colors(const GlFunctions& gl, bool as_image) {
  constexpr std::array<GLfloat, 5> map{1, 0.6F, 0.2F, 0.8F, 0};
  std::vector<GLubyte> image = texture_colors(20, 14);
  gl.PixelZoom(3, 3);
  gl.WindowPos2i(20, 20);
  for (GLenum channel = 0; channel < 4; ++channel) {
    const GLsizei size = 5 - static_cast<GLsizei>(channel);
    if (!as_image) {
      gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R + channel, size, map.data());
      continue;
    }
    for (std::size_t i = channel; i < image.size(); i += 4) {
      const float at = static_cast<float>(image[i]) / 255 * static_cast<float>(size - 1);
      const float value = map[static_cast<std::size_t>(std::lround(at))];
      image[i] = static_cast<GLubyte>(std::lround(value * 255));
    }
  }
  gl.PixelTransferi(GL_MAP_COLOR, as_image ? 0 : 1);
  gl.DrawPixels(20, 14, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
}

void shifted_indices(const GlFunctions& gl, GLenum format, bool as_image) {
  std::vector<GLubyte> image = noise(400);
  constexpr std::array<GLint, 4> shifts{-2, 1, 0, -1}, offsets{3, 1, 7, 0};
  gl.PixelZoom(3, 3);
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<GLubyte> part(image.begin() + static_cast<std::ptrdiff_t>(20 * i), image.end());
    gl.PixelTransferi(GL_INDEX_SHIFT, as_image ? 0 : shifts[i]);
    gl.PixelTransferi(GL_INDEX_OFFSET, as_image ? 0 : offsets[i]);
    for (GLubyte& index : part) {
      if (!as_image) break;
      const int shifted = shifts[i] > 0 ? index << shifts[i] : index >> -shifts[i];
      index = static_cast<GLubyte>(shifted + offsets[i]);
    }
    gl.WindowPos2i(2 + 63 * static_cast<int>(i % 2), 2 + 63 * static_cast<int>(i / 2));
    gl.DrawPixels(20, 16, format, GL_UNSIGNED_BYTE, part.data());
  }
}

void use_index_maps(const GlFunctions& gl) {
  constexpr std::array<GLfloat, 8> red{0, 1, 0.2F, 0.4F, 0.6F, 0.8F, 1, 0},
      green{1, 0, 0.6F, 0.4F, 0.2F, 0, 0.8F, 1};
  gl.PixelMapfv(GL_PIXEL_MAP_I_TO_R, 8, red.data());
  gl.PixelMapfv(GL_PIXEL_MAP_I_TO_G, 8, green.data());
  gl.PixelMapfv(GL_PIXEL_MAP_I_TO_B, 4, red.data());
  gl.PixelMapfv(GL_PIXEL_MAP_I_TO_A, 2, green.data());
}

Scene transferred(std::string name, void (*draw)(const GlFunctions&, bool as_image)) {
  const auto drawn = [=](bool as_image) {
    return flat("", [=](const GlFunctions& gl) { draw(gl, as_image); }).draw;
  };
  return {std::move(name),
          drawn(false),
          {.mesa_departure = "M18", .reference = drawn(true), .filtered = true}};
}

// Stencil values become seen: a colour where a bit is set.
void show_stencil(const GlFunctions& gl) {
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  gl.Disable(GL_BLEND);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  for (GLuint bit = 0; bit < 8; ++bit) {
    gl.StencilFunc(GL_EQUAL, 0xff, 1U << bit);
    gl.Color4f(bit % 3 == 0 ? 0.2F : 0, bit % 3 == 1 ? 0.2F : 0, bit % 3 == 2 ? 0.2F : 0, 0.1F);
    gl.Rectf(-1, -1, 1, 1);
  }
}

// A pixel rectangle, or a point for each of its pixels with the raster position's values.
void pixels_or_points(const GlFunctions& gl, const Draw& set, bool as_points) {
  begin_flat_scene(gl);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  use_texture(gl, GL_RGBA, GL_NEAREST, GL_NEAREST);
  gl.Disable(GL_TEXTURE_2D);
  set(gl);
  const std::vector<GLubyte> image = texture_colors(8, 6);
  for (int i = 0; i < 5; ++i) {
    const float s = 0.03F + 0.2F * static_cast<float>(i);
    gl.TexCoord2f(s, 1 - s);
    gl.FogCoordf(0.5F + static_cast<float>(i));
    gl.SecondaryColor3f(0.1F * static_cast<float>(i), 0.05F, 0.2F);
    const int x = 10 + 20 * i, y = 20 + 15 * i;
    if (!as_points) {
      gl.Color3f(1, 0, 0);
      gl.WindowPos2i(x, y);
      gl.DrawPixels(8, 6, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
      continue;
    }
    gl.Begin(GL_POINTS);
    for (int k = 0; k < 48; ++k) {
      gl.Color4ubv(image.data() + std::ptrdiff_t{4} * k);
      gl.Vertex3f((static_cast<float>(x + k % 8) + 0.5F) / 64 - 1,
                  (static_cast<float>(y + k / 8) + 0.5F) / 64 - 1, 2);
    }
    gl.End();
  }
}

Scene departure(std::string name, Draw set) {
  return {std::move(name),
          [=](const GlFunctions& gl) { pixels_or_points(gl, set, false); },
          {.mesa_departure = "M17",
           .reference = [=](const GlFunctions& gl) { pixels_or_points(gl, set, true); }}};
}

// Bitmaps of one pixel, or points in their place.
void textured_bits(const GlFunctions& gl, const Draw& set, bool as_points) {
  begin_flat_scene(gl);
  gl.Disable(GL_DEPTH_TEST);
  use_texture(gl, GL_RGBA, GL_NEAREST, GL_NEAREST);
  set(gl);
  constexpr GLubyte pixel = 0x80;
  for (int i = 0; i < 100; ++i) {
    const float at = 0.0193F * static_cast<float>(i) - 0.95F;
    gl.Color3f(1, 0.01F * static_cast<float>(i), 0.6F);
    gl.TexCoord2f(0.5F + at, 0.3F - at);
    if (as_points) {
      gl.Begin(GL_POINTS);
      gl.Vertex2f(at, 0.7F * at);
      gl.End();
    } else {
      gl.RasterPos2f(at, 0.7F * at);
      gl.Bitmap(1, 1, 0, 0, 0, 0, &pixel);
    }
  }
}

Scene textured_bitmaps(std::string name, Draw set) {
  return {std::move(name),
          [=](const GlFunctions& gl) { textured_bits(gl, set, false); },
          {.mesa_departure = "M17",
           .reference = [=](const GlFunctions& gl) { textured_bits(gl, set, true); }}};
}

}  // namespace

std::vector<Scene> pixels_scenes() {
  return {
      flat("formats_of_bytes", formats({{GL_RED, GL_UNSIGNED_BYTE},
                                        {GL_GREEN, GL_UNSIGNED_BYTE},
                                        {GL_BLUE, GL_UNSIGNED_BYTE},
                                        {GL_ALPHA, GL_UNSIGNED_BYTE},
                                        {GL_LUMINANCE, GL_UNSIGNED_BYTE},
                                        {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE},
                                        {GL_RGB, GL_UNSIGNED_BYTE},
                                        {GL_BGR, GL_UNSIGNED_BYTE},
                                        {GL_RGBA, GL_UNSIGNED_BYTE},
                                        {GL_BGRA, GL_UNSIGNED_BYTE}})),
      flat("packed_types",
           formats({{GL_RGB, GL_UNSIGNED_BYTE_3_3_2},
                    {GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV},
                    {GL_RGB, GL_UNSIGNED_SHORT_5_6_5},
                    {GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV},
                    {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4},
                    {GL_BGRA, GL_UNSIGNED_SHORT_4_4_4_4_REV},
                    {GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1},
                    {GL_BGRA, GL_UNSIGNED_SHORT_1_5_5_5_REV},
                    {GL_RGBA, GL_UNSIGNED_INT_8_8_8_8},
                    {GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV}}),
           true),
      flat("wide_types", formats({{GL_RGBA, GL_UNSIGNED_SHORT},
                                  {GL_RGB, GL_FLOAT},
                                  {GL_RGBA, GL_FLOAT},
                                  {GL_LUMINANCE, GL_FLOAT},
                                  {GL_RGBA, GL_UNSIGNED_INT},
                                  {GL_BGRA, GL_UNSIGNED_SHORT}})),
      flat("unpack_row_length", with_store(GL_UNPACK_ROW_LENGTH, 41)),
      flat("unpack_alignment", with_store(GL_UNPACK_ALIGNMENT, 8)),
      flat("unpack_skip_pixels", with_store(GL_UNPACK_SKIP_PIXELS, 5)),
      flat("unpack_skip_rows", with_store(GL_UNPACK_SKIP_ROWS, 6)),
      flat("unpack_swap_bytes", with_store(GL_UNPACK_SWAP_BYTES, 1, GL_UNSIGNED_SHORT)),
      flat("zoom_4", zoomed(4, 3)),
      flat("zoom_mirrored", zoomed(-2, -3)),
      flat("zoom_flipped", zoomed(1, -1)),
      flat("zoom_fraction", zoomed(2.6F, 18 / 14.0F)),
      flat("zoom_smaller", zoomed(0.8F, 6 / 14.0F)),
      flat("zoom_of_parts_beyond_the_window",
           [](const GlFunctions& gl) {
             gl.PixelZoom(7, 9);
             gl.RasterPos2f(-1, -1);
             gl.Bitmap(0, 0, 0, 0, -30, -40, nullptr);
             rgba_image(gl);
           }),
      flat("positions",
           [](const GlFunctions& gl) {
             for (int i = 0; i < 9; ++i) {
               gl.RasterPos2f(-0.95F + 0.1913F * static_cast<float>(i),
                              -0.9F + 0.1479F * static_cast<float>(i));
               rgba_image(gl, 7, 9);
             }
             gl.RasterPos2f(2, 0);
             rgba_image(gl);
           }),
      flat("in_lists",
           [](const GlFunctions& gl) {
             gl.NewList(1, GL_COMPILE);
             gl.PixelZoom(2, 2);
             rgba_image(gl);
             gl.CopyPixels(10, 10, 12, 9, GL_COLOR);
             gl.EndList();
             gl.WindowPos2i(10, 10);
             gl.CallList(1);
             gl.WindowPos2i(60, 70);
             gl.CallList(1);
           }),
      flat("between_primitives",
           [](const GlFunctions& gl) {
             for (int i = 0; i < 4; ++i) {
               const float at = -0.8F + 0.4F * static_cast<float>(i);
               gl.Color3f(0.2F, 0.3F * static_cast<float>(i), 1);
               gl.Rectf(at, at, at + 0.3F, at + 0.3F);
               gl.RasterPos2f(at + 0.1F, at + 0.1F);
               rgba_image(gl, 12, 10);
             }
           }),
      flat("larger_than_a_tile",
           [](const GlFunctions& gl) {
             gl.PixelZoom(128 / 2100.0F, 44 / 60.0F);
             gl.WindowPos2i(0, 10);
             const std::vector<GLubyte> image = noise(std::size_t{2100} * 60);
             gl.DrawPixels(2100, 60, GL_LUMINANCE, GL_UNSIGNED_BYTE, image.data());
           }),
      flat("blend_alpha_test_and_masks",
           [](const GlFunctions& gl) {
             rectangles(gl);
             gl.Enable(GL_BLEND);
             gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
             gl.Enable(GL_ALPHA_TEST);
             gl.AlphaFunc(GL_GREATER, 0.3F);
             gl.ColorMask(1, 0, 1, 1);
             gl.PixelZoom(3, 3);
             gl.WindowPos2i(20, 20);
             rgba_image(gl);
           }),
      flat("depth_test",
           [](const GlFunctions& gl) {
             gl.Enable(GL_DEPTH_TEST);
             rectangles(gl);
             gl.PixelZoom(3, 3);
             gl.RasterPos3f(-0.7F, -0.7F, 0.5F);
             rgba_image(gl);
             gl.RasterPos3f(-0.1F, -0.1F, -0.5F);
             rgba_image(gl);
           }),
      flat("scissor",
           [](const GlFunctions& gl) {
             gl.Enable(GL_SCISSOR_TEST);
             gl.Scissor(30, 33, 22, 11);
             gl.PixelZoom(4, 4);
             gl.WindowPos2i(20, 20);
             rgba_image(gl);
           }),
      flat("scale_and_bias",
           [](const GlFunctions& gl) {
             gl.PixelTransferf(GL_RED_SCALE, 0.5F);
             gl.PixelTransferf(GL_GREEN_SCALE, -1);
             gl.PixelTransferf(GL_GREEN_BIAS, 1);
             gl.PixelTransferf(GL_BLUE_BIAS, 0.25F);
             gl.PixelTransferf(GL_BLUE_SCALE, 0.75F);
             gl.PixelTransferf(GL_ALPHA_SCALE, 0.25F);
             gl.PixelZoom(3, 3);
             gl.WindowPos2i(20, 20);
             rgba_image(gl);
           }),
      transferred("color_maps", mapped_colors),
      transferred("color_indices_shifted",
                  [](const GlFunctions& gl, bool as_image) {
                    use_index_maps(gl);
                    shifted_indices(gl, GL_COLOR_INDEX, as_image);
                  }),
      transferred("stencil_indices_shifted",
                  [](const GlFunctions& gl, bool as_image) {
                    shifted_indices(gl, GL_STENCIL_INDEX, as_image);
                    show_stencil(gl);
                  }),
      flat(
          "color_indices",
          [](const GlFunctions& gl) {
            use_index_maps(gl);
            // Each an image of its own: Mesa takes the last one's colours for an equal image.
            const std::vector<GLubyte> image = noise(1000);
            gl.PixelZoom(3, 3);
            gl.WindowPos2i(2, 2);
            gl.DrawPixels(20, 20, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, image.data());
          },
          true),
      flat("copy_color",
           [](const GlFunctions& gl) {
             rectangles(gl);
             gl.WindowPos2i(70, 75);
             gl.CopyPixels(10, 10, 40, 44, GL_COLOR);
             gl.PixelZoom(-1.5F, 2);
             gl.WindowPos2i(50, 90);
             gl.CopyPixels(30, 20, 30, 18, GL_COLOR);
           }),
      flat("copy_with_transfer",
           [](const GlFunctions& gl) {
             rectangles(gl);
             gl.PixelTransferf(GL_RED_BIAS, 0.3F);
             gl.PixelTransferf(GL_BLUE_SCALE, 0.5F);
             gl.WindowPos2i(40, 75);
             gl.CopyPixels(10, 10, 60, 44, GL_COLOR);
           }),
      flat(
          "texture_images_are_transferred",
          [](const GlFunctions& gl) {
            gl.PixelTransferf(GL_RED_SCALE, 0.5F);
            gl.PixelTransferf(GL_GREEN_BIAS, 0.2F);
            gl.PixelTransferf(GL_ALPHA_SCALE, 0.5F);
            use_texture(gl, GL_RGBA, GL_NEAREST, GL_NEAREST);
            gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
            draw_textured_quad(gl);
          },
          true),
      flat("texture_images_of_indices",
           [](const GlFunctions& gl) {
             use_index_maps(gl);
             const std::vector<GLubyte> image = noise(256);
             use_texture(gl, GL_RGBA, GL_NEAREST, GL_NEAREST);
             gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 8, 0, GL_COLOR_INDEX, GL_UNSIGNED_BYTE,
                           image.data());
             gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
             draw_textured_quad(gl);
           }),
      flat("depth_pixels",
           [](const GlFunctions& gl) {
             const std::vector<GLfloat> depths = ramp(600);
             gl.Enable(GL_DEPTH_TEST);
             gl.DepthFunc(GL_ALWAYS);
             gl.PixelZoom(3, 3);
             gl.Color3f(0.9F, 0.5F, 0.1F);
             gl.WindowPos2i(10, 10);
             gl.DrawPixels(20, 15, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
             gl.PixelTransferf(GL_DEPTH_SCALE, 0.5F);
             gl.PixelTransferf(GL_DEPTH_BIAS, 0.3F);
             gl.WindowPos2i(50, 60);
             gl.DrawPixels(20, 15, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data() + 7);
             gl.DepthFunc(GL_LESS);
             gl.DepthMask(GL_FALSE);
             for (int i = 0; i < 20; ++i) {
               gl.Color3f(0, 0.05F * static_cast<float>(i), 0.5F);
               const float z = 0.9F - 0.1F * static_cast<float>(i);
               gl.Begin(GL_TRIANGLES);
               gl.Vertex3f(-1, -1, z);
               gl.Vertex3f(1, -1, z);
               gl.Vertex3f(0, 1, z);
               gl.End();
             }
           }),
      flat("stencil_pixels",
           [](const GlFunctions& gl) {
             const std::vector<GLubyte> indices = noise(600);
             gl.StencilMask(0x7f);
             gl.PixelZoom(3, 2);
             gl.WindowPos2i(10, 10);
             gl.DrawPixels(20, 15, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, indices.data());
             gl.StencilMask(0xff);
             gl.PixelZoom(2, -3);
             gl.WindowPos2i(40, 100);
             gl.DrawPixels(20, 15, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, indices.data() + 50);
             show_stencil(gl);
           }),
      {"textured",
       [](const GlFunctions& gl) {
         pixels_or_points(
             gl, [](const GlFunctions& g) { g.Enable(GL_TEXTURE_2D); }, false);
       }},
      departure("fog",
                [](const GlFunctions& gl) {
                  gl.Enable(GL_FOG);
                  gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
                  gl.Fogf(GL_FOG_DENSITY, 0.3F);
                  gl.Fogfv(GL_FOG_COLOR, vec(0.2F, 0.4F, 0.8F));
                }),
      departure("color_sum", [](const GlFunctions& gl) { gl.Enable(GL_COLOR_SUM); }),
      textured_bitmaps("bitmaps_textured", [](const GlFunctions&) {}),
      textured_bitmaps("bitmaps_textured_by_a_matrix",
                       [](const GlFunctions& gl) {
                         gl.MatrixMode(GL_TEXTURE);
                         gl.Scalef(2, 1.5F, 1);
                         gl.Rotatef(30, 0, 0, 1);
                         gl.MatrixMode(GL_MODELVIEW);
                       }),
  };
}

}  // namespace legacy_gl::test
