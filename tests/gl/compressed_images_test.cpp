// Compressed images (GL 2.1 spec 3.8.3), beside Mesa's.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 32;
constexpr GLenum kRgbDxt1 = 0x83F0, kRgbaDxt1 = 0x83F1, kRgbaDxt3 = 0x83F2, kRgbaDxt5 = 0x83F3;
constexpr GLenum kFormats[] = {kRgbDxt1, kRgbaDxt1, kRgbaDxt3, kRgbaDxt5};

GLsizei block_bytes(GLenum format) { return format == kRgbDxt1 || format == kRgbaDxt1 ? 8 : 16; }

/// Blocks of 8 by 8 texels that differ in all that a block has.
std::vector<GLubyte> blocks(GLenum format, unsigned count = 4) {
  std::vector<GLubyte> bytes(count * static_cast<std::size_t>(block_bytes(format)));
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<GLubyte>(i * 37 + 11);
  return bytes;
}

void define(const GlFunctions& gl, GLenum format) {
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const std::vector<GLubyte> data = blocks(format);
  gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, format, 8, 8, 0, static_cast<GLsizei>(data.size()),
                          data.data());
}

GLint level(const GlFunctions& gl, GLenum name, GLenum target = GL_TEXTURE_2D) {
  GLint value = -1;
  gl.GetTexLevelParameteriv(target, 0, name, &value);
  return value;
}

void draw(const GlFunctions& gl) {
  gl.ClearColor(0.2F, 0.4F, 0.6F, 0.8F);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Enable(GL_TEXTURE_2D);
  gl.Begin(GL_QUADS);
  for (int i = 0; i < 4; ++i) {
    const float x = i == 1 || i == 2 ? 1.0F : 0.0F, y = i >= 2 ? 1.0F : 0.0F;
    gl.TexCoord2f(x, y);
    gl.Vertex2f(2 * x - 1, 2 * y - 1);
  }
  gl.End();
}

class CompressedImages : public testing::Test {
 protected:
  template <typename Call>
  GLenum error_of(RenderContext& context, Call call) {
    context.recreate();
    call(context.gl);
    return context.gl.GetError();
  }
  template <typename Call>
  void expect_error(GLenum expected, Call call) {
    EXPECT_EQ(error_of(ours_, call), expected);
    EXPECT_EQ(error_of(mesa_, call), expected) << "Mesa";
  }

  MesaContext mesa_{kSize, kSize};
  CoreContext ours_{kSize, kSize};
};

}  // namespace

TEST_F(CompressedImages, Formats) {
  GLint count = -1;
  std::array<GLint, 3> formats{};
  ours_.make_current();
  ours_.gl.GetIntegerv(GL_NUM_COMPRESSED_TEXTURE_FORMATS, &count);
  ASSERT_EQ(count, 3);
  ours_.gl.GetIntegerv(GL_COMPRESSED_TEXTURE_FORMATS, formats.data());
  EXPECT_EQ(formats, (std::array<GLint, 3>{kRgbDxt1, kRgbaDxt3, kRgbaDxt5}));
  std::vector<GLint> of_mesa(64);
  mesa_.make_current();
  mesa_.gl.GetIntegerv(GL_COMPRESSED_TEXTURE_FORMATS, of_mesa.data());
  for (const GLint format : formats) EXPECT_TRUE(std::ranges::count(of_mesa, format)) << format;
}

TEST_F(CompressedImages, SetAndGet) {
  for (const GLenum format : kFormats)
    for (RenderContext* const context :
         {static_cast<RenderContext*>(&mesa_), static_cast<RenderContext*>(&ours_)}) {
      context->recreate();
      const GlFunctions& gl = context->gl;
      define(gl, format);
      EXPECT_EQ(level(gl, GL_TEXTURE_COMPRESSED), 1);
      EXPECT_EQ(level(gl, GL_TEXTURE_COMPRESSED_IMAGE_SIZE), 4 * block_bytes(format));
      EXPECT_EQ(level(gl, GL_TEXTURE_INTERNAL_FORMAT), static_cast<GLint>(format));
      EXPECT_EQ(level(gl, GL_TEXTURE_WIDTH), 8);
      std::vector<GLubyte> read(4 * static_cast<std::size_t>(block_bytes(format)));
      gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, read.data());
      EXPECT_EQ(read, blocks(format));
      gl.CompressedTexImage2D(GL_PROXY_TEXTURE_2D, 0, format, 8, 8, 0, 4 * block_bytes(format),
                              nullptr);
      EXPECT_EQ(level(gl, GL_TEXTURE_WIDTH, GL_PROXY_TEXTURE_2D), 8);
      EXPECT_EQ(level(gl, GL_TEXTURE_COMPRESSED, GL_PROXY_TEXTURE_2D), 1);
      EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
    }
}

TEST_F(CompressedImages, Renders) {
  for (const GLenum format : kFormats) {
    mesa_.recreate();
    define(mesa_.gl, format);
    draw(mesa_.gl);
    const Image expected = mesa_.read();
    ours_.recreate();
    define(ours_.gl, format);
    draw(ours_.gl);
    EXPECT_TRUE(compare(expected, ours_.read()).identical()) << format;
    GlesContext es(kSize, kSize);
    define(es.gl, format);
    draw(es.gl);
    EXPECT_TRUE(compare(expected, es.read()).identical()) << format;
  }
}

TEST_F(CompressedImages, PartsAndLists) {
  const auto calls = [](const GlFunctions& gl) {
    define(gl, kRgbaDxt5);
    std::vector<GLubyte> block(16, 0x5a);
    gl.NewList(1, GL_COMPILE);
    gl.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 0, 4, 4, kRgbaDxt5, 16, block.data());
    gl.EndList();
    block.assign(16, 0);
    gl.CallList(1);
    draw(gl);
  };
  mesa_.recreate();
  calls(mesa_.gl);
  const Image expected = mesa_.read();
  ours_.recreate();
  calls(ours_.gl);
  EXPECT_EQ(ours_.gl.GetError(), GLenum{GL_NO_ERROR});
  EXPECT_TRUE(compare(expected, ours_.read()).identical());
}

// glTexImage2D with a compressed internal format: the driver compresses, as Mesa does.
TEST_F(CompressedImages, CompressesTexels) {
  for (RenderContext* const context :
       {static_cast<RenderContext*>(&mesa_), static_cast<RenderContext*>(&ours_)}) {
    context->recreate();
    const GlFunctions& gl = context->gl;
    const std::vector<GLubyte> texels(std::size_t{8} * 8 * 4, 255);
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(kRgbaDxt5), 8, 8, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, texels.data());
    EXPECT_EQ(level(gl, GL_TEXTURE_COMPRESSED), 1);
    std::vector<GLubyte> read(texels.size());
    gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
    EXPECT_EQ(read, texels);
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  }
}

TEST_F(CompressedImages, Errors) {
  static const std::vector<GLubyte> data(256);
  expect_error(GL_INVALID_VALUE, [](const GlFunctions& gl) {  // not the size of 2 by 2 blocks
    gl.CompressedTexImage2D(GL_TEXTURE_2D, 0, kRgbDxt1, 8, 8, 0, 31, data.data());
  });
  expect_error(GL_INVALID_ENUM, [](const GlFunctions& gl) {
    gl.CompressedTexImage1D(GL_TEXTURE_1D, 0, kRgbDxt1, 8, 0, 16, data.data());
  });
  expect_error(GL_INVALID_VALUE, [](const GlFunctions& gl) {
    gl.CompressedTexImage2D(GL_TEXTURE_2D, -1, kRgbDxt1, 8, 8, 0, 32, data.data());
  });
  expect_error(GL_INVALID_OPERATION, [](const GlFunctions& gl) {  // another format
    define(gl, kRgbaDxt3);
    gl.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, kRgbaDxt5, 16, data.data());
  });
  expect_error(GL_INVALID_OPERATION, [](const GlFunctions& gl) {  // between blocks
    define(gl, kRgbaDxt5);
    gl.CompressedTexSubImage2D(GL_TEXTURE_2D, 0, 2, 0, 4, 4, kRgbaDxt5, 16, data.data());
  });
  expect_error(GL_INVALID_OPERATION, [](const GlFunctions& gl) {
    constexpr GLubyte texel[4] = {};
    std::array<GLubyte, 64> read{};
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
    gl.GetCompressedTexImage(GL_TEXTURE_2D, 0, read.data());
  });
}

}  // namespace legacy_gl::test
