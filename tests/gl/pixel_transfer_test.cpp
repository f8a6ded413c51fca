// glPixelTransfer, glPixelMap, glPixelZoom (GL 2.1 spec 3.6.3 to 3.6.5), and what glReadPixels,
// glCopyPixels and glCopyTexImage make of them, beside Mesa's.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 16;

constexpr GLenum kReal[] = {GL_RED_SCALE,   GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE,
                            GL_RED_BIAS,    GL_GREEN_BIAS,  GL_BLUE_BIAS,  GL_ALPHA_BIAS,
                            GL_DEPTH_SCALE, GL_DEPTH_BIAS};
constexpr GLenum kWhole[] = {GL_INDEX_SHIFT, GL_INDEX_OFFSET};
constexpr GLenum kFlags[] = {GL_MAP_COLOR, GL_MAP_STENCIL};

std::vector<GLfloat> all_values(const GlFunctions& gl) {
  std::vector<GLfloat> values;
  const auto add = [&](GLenum name) {
    GLfloat value = -77;
    gl.GetFloatv(name, &value);
    values.push_back(value);
  };
  for (const GLenum name : kReal) add(name);
  for (const GLenum name : kWhole) add(name);
  for (const GLenum name : kFlags) add(name);
  add(GL_ZOOM_X);
  add(GL_ZOOM_Y);
  for (GLenum i = 0; i < 10; ++i) {
    add(GL_PIXEL_MAP_I_TO_I_SIZE + i);
    std::array<GLfloat, 256> map{};
    gl.GetPixelMapfv(GL_PIXEL_MAP_I_TO_I + i, map.data());
    values.insert(values.end(), map.begin(), map.begin() + 20);
    std::array<GLuint, 256> uints{};
    gl.GetPixelMapuiv(GL_PIXEL_MAP_I_TO_I + i, uints.data());
    // Of indices Mesa gives the bits of floats. Beside a float's 24 bits both round in their ways.
    for (std::size_t k = 0; k < 20 && i > 1; ++k)
      values.push_back(static_cast<float>(uints[k] >> 8));
    std::array<GLushort, 256> ushorts{};
    gl.GetPixelMapusv(GL_PIXEL_MAP_I_TO_I + i, ushorts.data());
    for (std::size_t k = 0; k < 20; ++k) values.push_back(ushorts[k]);
  }
  values.push_back(static_cast<float>(gl.GetError()));
  return values;
}

class PixelTransfer : public testing::Test {
 protected:
  void compare_state(void (*calls)(const GlFunctions&)) {
    mesa_.recreate();
    calls(mesa_.gl);
    const std::vector<GLfloat> mesa = all_values(mesa_.gl);
    ours_.recreate();
    calls(ours_.gl);
    const std::vector<GLfloat> ours = all_values(ours_.gl);
    ASSERT_EQ(ours.size(), mesa.size());
    for (std::size_t i = 0; i < ours.size(); ++i)
      EXPECT_NEAR(ours[i], mesa[i], mesa[i] > 2 ? 1 : 1e-6F) << i;  // halves may round either way
  }

  /// The bytes that `read` leaves, from a framebuffer of many values.
  void compare_bytes(void (*set)(const GlFunctions&), void (*read)(const GlFunctions&, GLubyte*),
                     int tolerance = 0) {
    const auto run = [&](RenderContext& context) {
      context.recreate();
      fill(context.gl);
      set(context.gl);
      std::vector<GLubyte> bytes(4096, 0x5A);
      read(context.gl, bytes.data());
      EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
      return bytes;
    };
    const std::vector<GLubyte> mesa = run(mesa_), ours = run(ours_);
    for (std::size_t i = 0; i < ours.size(); ++i)
      ASSERT_LE(std::abs(int{ours[i]} - int{mesa[i]}), tolerance) << "byte " << i;
    EXPECT_NE(ours, std::vector<GLubyte>(4096, 0x5A));
  }

  static void fill(const GlFunctions& gl) {
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl.Enable(GL_SCISSOR_TEST);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        gl.Scissor(x, y, 1, 1);
        gl.ClearColor(static_cast<float>(x) / 15, static_cast<float>(y) / 15,
                      static_cast<float>(x * y % 7) / 6, static_cast<float>(x + y) / 30);
        gl.ClearDepth(static_cast<double>(x * 16 + y) / 255);
        gl.ClearStencil(16 * y + x);
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
      }
    gl.Disable(GL_SCISSOR_TEST);
  }

  MesaContext mesa_{kSize, kSize};
  CoreContext ours_{kSize, kSize};
};

void scale_and_bias(const GlFunctions& gl) {
  gl.PixelTransferf(GL_RED_SCALE, 0.5F);
  gl.PixelTransferf(GL_GREEN_SCALE, -1);
  gl.PixelTransferf(GL_GREEN_BIAS, 1);
  gl.PixelTransferf(GL_BLUE_SCALE, 2);
  gl.PixelTransferf(GL_ALPHA_BIAS, -0.25F);
}

void use_maps(const GlFunctions& gl) {
  constexpr GLfloat map[] = {1, 0.5F, 0.25F, 0.75F, 0};
  gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 5, map);
  gl.PixelMapfv(GL_PIXEL_MAP_G_TO_G, 3, map);
  gl.PixelMapfv(GL_PIXEL_MAP_B_TO_B, 2, map);
  gl.PixelMapfv(GL_PIXEL_MAP_A_TO_A, 4, map);
  gl.PixelTransferi(GL_MAP_COLOR, 1);
}

void transfer_stencil(const GlFunctions& gl) {
  constexpr GLuint map[] = {7, 5, 200, 1, 0, 99, 3, 4};
  gl.PixelMapuiv(GL_PIXEL_MAP_S_TO_S, 8, map);
  gl.PixelTransferi(GL_MAP_STENCIL, 1);
  gl.PixelTransferi(GL_INDEX_SHIFT, -1);
  gl.PixelTransferi(GL_INDEX_OFFSET, 3);
}

template <GLenum Format, GLenum Type>
void read(const GlFunctions& gl, GLubyte* bytes) {
  gl.ReadPixels(1, 2, 13, 11, Format, Type, bytes);
}

}  // namespace

TEST_F(PixelTransfer, InitialState) {
  compare_state([](const GlFunctions&) {});
}

TEST_F(PixelTransfer, SetAndGet) {
  compare_state([](const GlFunctions& gl) {
    float value = 0.25F;
    for (const GLenum name : kReal) gl.PixelTransferf(name, value += 0.5F);
    for (const GLenum name : kWhole) gl.PixelTransferi(name, 3);
    for (const GLenum name : kFlags) gl.PixelTransferf(name, 2);
    gl.PixelZoom(-2.5F, 0.75F);
  });
  compare_state([](const GlFunctions& gl) {
    std::array<GLfloat, 16> floats{};
    std::array<GLuint, 16> uints{};
    std::array<GLushort, 16> ushorts{};
    for (std::size_t i = 0; i < 16; ++i) {
      floats[i] = static_cast<float>(i) / 12 - 0.1F;
      uints[i] = static_cast<GLuint>(i * 0x0FFFFFFF);
      ushorts[i] = static_cast<GLushort>(i * 4000);
    }
    gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 13, floats.data());
    gl.PixelMapuiv(GL_PIXEL_MAP_G_TO_G, 16, uints.data());
    gl.PixelMapusv(GL_PIXEL_MAP_B_TO_B, 7, ushorts.data());
    gl.PixelMapfv(GL_PIXEL_MAP_I_TO_A, 8, floats.data());
    gl.PixelMapusv(GL_PIXEL_MAP_S_TO_S, 4, ushorts.data());
  });
}

TEST_F(PixelTransfer, IndicesOfMaps) {
  ours_.recreate();
  const GlFunctions& gl = ours_.gl;
  constexpr GLuint given[] = {0, 3, 70000, 255};
  for (const GLuint map : {0U, 1U}) {
    gl.PixelMapuiv(GL_PIXEL_MAP_I_TO_I + map, 4, given);
    std::array<GLuint, 4> uints{};
    std::array<GLushort, 4> ushorts{};
    gl.GetPixelMapuiv(GL_PIXEL_MAP_I_TO_I + map, uints.data());
    gl.GetPixelMapusv(GL_PIXEL_MAP_I_TO_I + map, ushorts.data());
    EXPECT_EQ(uints, (std::array<GLuint, 4>{0, 3, 70000, 255}));
    EXPECT_EQ(ushorts, (std::array<GLushort, 4>{0, 3, 65535, 255}));
  }
}

TEST_F(PixelTransfer, BelongsToThePixelModeGroup) {
  compare_state([](const GlFunctions& gl) {
    constexpr GLfloat map[] = {1, 0.5F};
    gl.PixelTransferf(GL_RED_SCALE, 2);
    gl.PushAttrib(GL_PIXEL_MODE_BIT);
    gl.PixelTransferf(GL_RED_SCALE, 3);
    gl.PixelTransferf(GL_MAP_COLOR, 1);
    gl.PixelZoom(4, 5);
    gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, map);  // no group has the maps
    gl.PopAttrib();
  });
}

TEST_F(PixelTransfer, InLists) {
  compare_state([](const GlFunctions& gl) {
    GLfloat map[] = {1, 0.5F};
    gl.NewList(1, GL_COMPILE);
    gl.PixelTransferi(GL_INDEX_SHIFT, 2);
    gl.PixelZoom(2, 3);
    gl.PixelMapfv(GL_PIXEL_MAP_R_TO_R, 2, map);
    gl.EndList();
    map[0] = 0;
    gl.CallList(1);
  });
}

TEST_F(PixelTransfer, ColorsThatAreRead) {
  compare_bytes(scale_and_bias, read<GL_RGBA, GL_UNSIGNED_BYTE>, 1);  // 62.5 rounds either way
  compare_bytes(scale_and_bias, read<GL_BGR, GL_UNSIGNED_BYTE>, 1);
  compare_bytes(use_maps, read<GL_RGBA, GL_UNSIGNED_BYTE>, 1);
  compare_bytes(use_maps, read<GL_ALPHA, GL_UNSIGNED_BYTE>, 1);
}

TEST_F(PixelTransfer, DepthsThatAreRead) {
  compare_bytes(
      [](const GlFunctions& gl) {
        gl.PixelTransferf(GL_DEPTH_SCALE, 0.5F);
        gl.PixelTransferf(GL_DEPTH_BIAS, 0.125F);
      },
      read<GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE>, 1);
}

TEST_F(PixelTransfer, StencilIndicesThatAreRead) {
  compare_bytes(transfer_stencil, read<GL_STENCIL_INDEX, GL_UNSIGNED_BYTE>);
  compare_bytes(transfer_stencil, read<GL_STENCIL_INDEX, GL_FLOAT>);
  compare_bytes(transfer_stencil, read<GL_STENCIL_INDEX, GL_UNSIGNED_SHORT>);
}

/// GL 2.1 spec table 4.8: of a bitmap's index one bit is left; Mesa takes any index but 0 for 1.
TEST_F(PixelTransfer, StencilBitmapsThatAreRead) {
  ours_.recreate();
  fill(ours_.gl);
  for (const bool lsb_first : {false, true}) {
    ours_.gl.PixelStorei(GL_PACK_LSB_FIRST, lsb_first);
    std::vector<GLubyte> bits(64, 0);
    ours_.gl.ReadPixels(1, 2, 13, 11, GL_STENCIL_INDEX, GL_BITMAP, bits.data());
    for (std::size_t y = 0; y < 11; ++y)
      for (std::size_t x = 0; x < 13; ++x) {
        const unsigned shift = static_cast<unsigned>(lsb_first ? x % 8 : 7 - x % 8);
        EXPECT_EQ(bits[2 * y + x / 8] >> shift & 1, static_cast<int>((16 * (y + 2) + x + 1) & 1));
      }
  }
  EXPECT_EQ(ours_.gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_F(PixelTransfer, CopiesOfDepth) {
  compare_bytes(
      [](const GlFunctions& gl) {
        gl.Enable(GL_DEPTH_TEST);
        gl.DepthFunc(GL_ALWAYS);
        gl.WindowPos2i(3, 2);
        gl.PixelZoom(2, 1);
        gl.CopyPixels(4, 5, 5, 6, GL_DEPTH);
      },
      read<GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE>, 1);
}

TEST_F(PixelTransfer, CopiesOfStencil) {
  compare_bytes(
      [](const GlFunctions& gl) {
        gl.StencilMask(0xfd);
        gl.WindowPos2i(3, 9);
        gl.PixelZoom(2, -1);
        gl.CopyPixels(4, 5, 5, 6, GL_STENCIL);
      },
      read<GL_STENCIL_INDEX, GL_UNSIGNED_BYTE>);
}

/// Mesa copies them as they are (M18).
TEST_F(PixelTransfer, CopiesOfDepthAndStencilAreTransferred) {
  ours_.recreate();
  const GlFunctions& gl = ours_.gl;
  fill(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  gl.PixelTransferf(GL_DEPTH_SCALE, 0.5F);
  gl.PixelTransferf(GL_DEPTH_BIAS, 0.25F);
  gl.PixelTransferi(GL_INDEX_SHIFT, 1);
  gl.PixelTransferi(GL_INDEX_OFFSET, 1);
  gl.WindowPos2i(0, 0);
  gl.CopyPixels(4, 5, 5, 6, GL_DEPTH);
  gl.CopyPixels(4, 5, 5, 6, GL_STENCIL);
  gl.PixelTransferf(GL_DEPTH_SCALE, 1);
  gl.PixelTransferf(GL_DEPTH_BIAS, 0);
  gl.PixelTransferi(GL_INDEX_SHIFT, 0);
  gl.PixelTransferi(GL_INDEX_OFFSET, 0);
  std::array<GLfloat, 30> depths{};
  std::array<GLubyte, 30> indices{};
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, 5, 6, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  gl.ReadPixels(0, 0, 5, 6, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, indices.data());
  for (int y = 0; y < 6; ++y)
    for (int x = 0; x < 5; ++x) {
      const auto at = static_cast<std::size_t>(5 * y + x);
      EXPECT_NEAR(depths[at], 0.5F * static_cast<float>((x + 4) * 16 + y + 5) / 255 + 0.25F, 1e-6F);
      EXPECT_EQ(indices[at], static_cast<GLubyte>((16 * (y + 5) + x + 4) * 2 + 1));
    }
}

/// Neither the stencil test nor depth test nor blending concern them, but the scissor does.
TEST_F(PixelTransfer, StencilIndicesPassAllTests) {
  compare_bytes(
      [](const GlFunctions& gl) {
        const std::vector<GLubyte> indices(256, 0xA5);
        gl.Enable(GL_STENCIL_TEST);
        gl.StencilFunc(GL_NEVER, 0, 0xff);
        gl.Enable(GL_DEPTH_TEST);
        gl.DepthFunc(GL_NEVER);
        gl.Enable(GL_ALPHA_TEST);
        gl.AlphaFunc(GL_NEVER, 0);
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(3, 3, 6, 5);
        gl.WindowPos2i(1, 1);
        gl.DrawPixels(12, 12, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, indices.data());
      },
      [](const GlFunctions& gl, GLubyte* bytes) {
        read<GL_STENCIL_INDEX, GL_UNSIGNED_BYTE>(gl, bytes);
        gl.ReadPixels(1, 2, 13, 11, GL_RGBA, GL_UNSIGNED_BYTE, bytes + 1000);
      });
}

/// Every pixel of a zoomed image belongs to the fragments whose centres are in its rectangle or on
/// its left or bottom edge (GL 2.1 spec 3.6.4).
TEST_F(PixelTransfer, CentresOnEdges) {
  ours_.recreate();
  const GlFunctions& gl = ours_.gl;
  std::array<GLubyte, 16> image{};
  for (std::size_t i = 0; i < 16; ++i) image[i] = static_cast<GLubyte>(10 * i + 10);
  std::array<GLubyte, 16> row{};
  gl.PixelZoom(0.5F, 1);
  gl.WindowPos2i(0, 0);
  gl.DrawPixels(16, 1, GL_RED, GL_UNSIGNED_BYTE, image.data());
  gl.ReadPixels(0, 0, 16, 1, GL_RED, GL_UNSIGNED_BYTE, row.data());
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(row[i], image[2 * i + 1]) << i;
  EXPECT_EQ(row[8], 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.PixelZoom(-0.5F, 1);
  gl.WindowPos2i(8, 0);
  gl.DrawPixels(16, 1, GL_RED, GL_UNSIGNED_BYTE, image.data());
  gl.ReadPixels(0, 0, 16, 1, GL_RED, GL_UNSIGNED_BYTE, row.data());
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(row[7 - i], image[2 * i]) << i;
  EXPECT_EQ(row[8], 0);
}

/// Mesa draws garbage here.
TEST_F(PixelTransfer, BitsAreIndices) {
  ours_.recreate();
  const GlFunctions& gl = ours_.gl;
  constexpr GLfloat map[] = {0.2F, 1};
  for (const GLenum channel : {0U, 1U, 2U, 3U})
    gl.PixelMapfv(GL_PIXEL_MAP_I_TO_R + channel, 2, map);
  constexpr GLubyte bits[] = {0x35, 0x9c, 0xe2, 0x47, 0xa1, 0x7e};
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 3);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 14);
  for (const bool lsb_first : {false, true})
    for (const bool in_list : {false, true}) {
      gl.PixelStorei(GL_UNPACK_LSB_FIRST, lsb_first);
      if (in_list) gl.NewList(1, GL_COMPILE);
      gl.DrawPixels(9, 3, GL_COLOR_INDEX, GL_BITMAP, bits);
      if (in_list) gl.EndList();
      if (in_list) gl.CallList(1);
      std::array<GLubyte, 27> red{};
      gl.ReadPixels(0, 0, 9, 3, GL_RED, GL_UNSIGNED_BYTE, red.data());
      for (std::size_t i = 0; i < 27; ++i) {
        const std::size_t at = i % 9 + 3;
        const std::size_t shift = lsb_first ? at % 8 : 7 - at % 8;
        EXPECT_EQ(red[i], bits[i / 9 * 2 + at / 8] >> shift & 1 ? 255 : 51) << i;
      }
      gl.Clear(GL_COLOR_BUFFER_BIT);
    }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

/// Mesa leaves garbage here.
TEST_F(PixelTransfer, TextureCopiesAreTransferred) {
  ours_.recreate();
  const GlFunctions& gl = ours_.gl;
  fill(gl);
  gl.PixelTransferf(GL_RED_SCALE, 0.5F);
  gl.PixelTransferf(GL_GREEN_BIAS, 0.2F);
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 4, 4, 8, 8, 0);
  std::array<GLubyte, 256> texels{};
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const GLubyte* const texel = &texels[static_cast<std::size_t>(4 * (8 * y + x))];
      EXPECT_NEAR(texel[0], 17.0 * (x + 4) / 2, 1);
      EXPECT_NEAR(texel[1], std::min(17 * (y + 4) + 51, 255), 1);
    }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

/// OpenGL ES reads neither depth nor stencil.
TEST(PixelTransferOnEs, CopiesOfDepthAndStencilAreRefused) {
  GlesContext context(kSize, kSize);
  constexpr GLenum kTypes[] = {GL_DEPTH, GL_STENCIL};
  for (const GLenum type : kTypes) {
    context.gl.CopyPixels(0, 0, 4, 4, type);
    EXPECT_EQ(context.gl.GetError(), GLenum{GL_INVALID_OPERATION});
  }
}

TEST_F(PixelTransfer, AnImageIsOneDrawAndNoNewProgram) {
  ours_.recreate();
  const GlFunctions& gl = ours_.gl;
  const std::vector<GLubyte> image(400, 99);
  gl.DrawPixels(10, 10, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  legacy_gl_statistics before{}, after{};
  legacy_gl_get_statistics(&before);
  gl.PixelZoom(2, 2);
  gl.PixelTransferf(GL_RED_SCALE, 0.5F);
  gl.DrawPixels(10, 10, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
  legacy_gl_get_statistics(&after);
  EXPECT_EQ(after.draws - before.draws, 1U);
  EXPECT_EQ(after.programs_compiled, before.programs_compiled);
}

}  // namespace legacy_gl::test
