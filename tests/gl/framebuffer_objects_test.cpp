// The driver's framebuffer objects with textures of ours (legacy_gl/framebuffer_objects.h), as the
// drop-in hands them on.
#include <GL/glcorearb.h>
#include <gtest/gtest.h>
#include <legacy_gl/framebuffer_objects.h>

#include <array>
#include <string>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 16;

template <typename Function>
Function driver(const char* name) {
  return reinterpret_cast<Function>(CoreContext::driver_proc(name));
}

GLuint make_texture(const GlFunctions& gl, GLint internal_format, GLenum format, GLenum type) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, internal_format, kSize, kSize, 0, format, type, nullptr);
  return texture;
}

void attach(GLenum attachment, GLuint texture) {
  const GLuint name = legacy_gl_driver_texture(texture);
  legacy_gl_flush();
  driver<PFNGLFRAMEBUFFERTEXTURE2DPROC>("glFramebufferTexture2D")(GL_FRAMEBUFFER, attachment,
                                                                  GL_TEXTURE_2D, name, 0);
  legacy_gl_reset_driver_state();
}

void bind(GLuint framebuffer) {
  legacy_gl_flush();
  driver<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer")(GL_FRAMEBUFFER, framebuffer);
  legacy_gl_reset_driver_state();
}

std::array<GLubyte, 4> pixel(const GlFunctions& gl, GLint x, GLint y) {
  std::array<GLubyte, 4> color{};
  gl.ReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
  return color;
}

using Color = std::array<GLubyte, 4>;

TEST(FramebufferObjects, TexturesAreDrawnIntoAndWith) {
  CoreContext context(kSize, kSize);
  const GlFunctions& gl = context.gl;
  GLuint framebuffer = 0;
  driver<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &framebuffer);
  bind(framebuffer);
  GLint bound = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  EXPECT_EQ(static_cast<GLuint>(bound), framebuffer);
  const GLuint color = make_texture(gl, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE);
  const GLuint depth = make_texture(gl, GL_DEPTH_STENCIL, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
  attach(GL_COLOR_ATTACHMENT0, color);
  attach(GL_DEPTH_STENCIL_ATTACHMENT, depth);
  EXPECT_EQ(driver<PFNGLCHECKFRAMEBUFFERSTATUSPROC>("glCheckFramebufferStatus")(GL_FRAMEBUFFER),
            static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  GLint bits = 0;
  gl.GetIntegerv(GL_STENCIL_BITS, &bits);
  EXPECT_EQ(bits, 8);
  gl.DrawBuffer(GL_COLOR_ATTACHMENT0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.Color3f(1, 0, 0);
  gl.Rectf(-1, -1, 0, 1);
  gl.Color3f(0, 0, 1);
  gl.Begin(GL_QUADS);  // behind it
  gl.Vertex3f(-1, -1, 0.5F);
  gl.Vertex3f(1, -1, 0.5F);
  gl.Vertex3f(1, 1, 0.5F);
  gl.Vertex3f(-1, 1, 0.5F);
  gl.End();
  EXPECT_EQ(pixel(gl, 3, 3), (Color{255, 0, 0, 255}));
  EXPECT_EQ(pixel(gl, 12, 3), (Color{0, 0, 255, 255}));
  bind(0);
  gl.DrawBuffer(GL_COLOR_ATTACHMENT0);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  gl.Disable(GL_DEPTH_TEST);
  gl.BindTexture(GL_TEXTURE_2D, color);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Begin(GL_QUADS);
  gl.TexCoord2f(0, 0);
  gl.Vertex2f(-1, -1);
  gl.TexCoord2f(1, 0);
  gl.Vertex2f(1, -1);
  gl.TexCoord2f(1, 1);
  gl.Vertex2f(1, 1);
  gl.TexCoord2f(0, 1);
  gl.Vertex2f(-1, 1);
  gl.End();
  EXPECT_EQ(pixel(gl, 3, 3), (Color{255, 0, 0, 255}));
  EXPECT_EQ(pixel(gl, 12, 3), (Color{0, 0, 255, 255}));
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(FramebufferObjects, MipmapsAreGenerated) {
  CoreContext context(kSize, kSize);
  const GlFunctions& gl = context.gl;
  legacy_gl_generate_mipmap(GL_TEXTURE_2D);  // without an image
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  legacy_gl_generate_mipmap(GL_TEXTURE_RECTANGLE);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  std::array<GLubyte, 64> texels{};
  for (std::size_t i = 0; i < 64; ++i) texels[i] = i % 8 < 4 ? 200 : 100;
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  legacy_gl_generate_mipmap(GL_TEXTURE_2D);
  GLubyte last = 0;
  gl.GetTexImage(GL_TEXTURE_2D, 2, GL_LUMINANCE, GL_UNSIGNED_BYTE, &last);
  EXPECT_NEAR(last, 150, 1);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

// GL_EXT_packed_depth_stencil: no test but the scissor concerns what is drawn.
TEST(FramebufferObjects, DepthAndStencilInOneWord) {
  CoreContext context(kSize, kSize);
  const GlFunctions& gl = context.gl;
  GLuint framebuffer = 0;
  driver<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &framebuffer);
  bind(framebuffer);
  attach(GL_DEPTH_STENCIL_ATTACHMENT,
         make_texture(gl, GL_DEPTH_STENCIL, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8));
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  gl.Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  gl.AlphaFunc(GL_NEVER, 0);
  gl.Enable(GL_ALPHA_TEST);
  gl.DepthFunc(GL_NEVER);
  gl.Enable(GL_DEPTH_TEST);
  gl.RasterPos2i(-1, -1);
  using Words = std::array<GLuint, 4>;
  const auto read = [&](GLint x) {
    Words words{};
    gl.ReadPixels(x, 0, 4, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, words.data());
    return words;
  };
  constexpr Words words{0x80000112, 0xFFFFFF34, 0x40000056, 0x00000078};
  gl.DrawPixels(4, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, words.data());
  EXPECT_EQ(read(0), words);
  EXPECT_EQ(read(4), (Words{0xFFFFFF00, 0xFFFFFF00, 0xFFFFFF00, 0xFFFFFF00})) << "beside it";
  gl.WindowPos2i(4, 0);
  gl.CopyPixels(0, 0, 4, 1, GL_DEPTH_STENCIL);
  EXPECT_EQ(read(4), words);
  gl.NewList(1, GL_COMPILE);
  gl.DrawPixels(4, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, words.data());
  gl.EndList();
  gl.WindowPos2i(8, 0);
  gl.CallList(1);
  EXPECT_EQ(read(8), words);
  gl.PixelTransferi(GL_INDEX_OFFSET, 1);
  gl.PixelTransferf(GL_DEPTH_SCALE, 0.5F);
  EXPECT_EQ(read(0), (Words{0x40000113, 0x80000035, 0x20000057, 0x00000079}));
  gl.PixelTransferi(GL_INDEX_OFFSET, 0);
  gl.PixelTransferf(GL_DEPTH_SCALE, 1);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  gl.DrawPixels(4, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_BYTE, words.data());
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  attach(GL_DEPTH_STENCIL_ATTACHMENT, 0);
  attach(GL_DEPTH_ATTACHMENT, make_texture(gl, GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT, GL_FLOAT));
  read(0);  // without stencil indices
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  bind(0);
}

TEST(FramebufferObjects, PixelsOfSeveralSamplesCannotBeRead) {
  CoreContext context(kSize, kSize);
  const GlFunctions& gl = context.gl;
  GLuint framebuffer = 0, renderbuffer = 0;
  driver<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &framebuffer);
  driver<PFNGLGENRENDERBUFFERSPROC>("glGenRenderbuffers")(1, &renderbuffer);
  driver<PFNGLBINDRENDERBUFFERPROC>("glBindRenderbuffer")(GL_RENDERBUFFER, renderbuffer);
  driver<PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC>("glRenderbufferStorageMultisample")(
      GL_RENDERBUFFER, 4, GL_RGBA8, kSize, kSize);
  bind(framebuffer);
  driver<PFNGLFRAMEBUFFERRENDERBUFFERPROC>("glFramebufferRenderbuffer")(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
  pixel(gl, 0, 0);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  gl.CopyPixels(0, 0, 1, 1, GL_COLOR);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  bind(0);
  pixel(gl, 0, 0);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(FramebufferObjects, NamesAndErrors) {
  CoreContext context(kSize, kSize);
  const GlFunctions& gl = context.gl;
  EXPECT_EQ(legacy_gl_driver_texture(0), 0U);
  EXPECT_EQ(legacy_gl_driver_texture(77), 0U);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, 4, 4, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_BYTE,
                nullptr);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                nullptr);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  constexpr std::array<GLuint, 4> words{0x80000012, 0xFFFFFF34, 0x40000056, 0x00000078};
  GLuint texture = 0, framebuffer = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, 4, 1, 0, GL_DEPTH_STENCIL,
                GL_UNSIGNED_INT_24_8, words.data());
  driver<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &framebuffer);
  bind(framebuffer);
  attach(GL_DEPTH_STENCIL_ATTACHMENT, texture);
  gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
  std::array<GLfloat, 4> depths{};
  std::array<GLubyte, 4> indices{};
  gl.ReadPixels(0, 0, 4, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  gl.ReadPixels(0, 0, 4, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, indices.data());
  EXPECT_EQ(indices, (std::array<GLubyte, 4>{0x12, 0x34, 0x56, 0x78}));
  bind(0);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(depths[i], static_cast<double>(words[i] >> 8) / 16777215, 1e-7);
  std::array<GLuint, 4> read{};
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, read.data());
  EXPECT_EQ(read, words);
  gl.PixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, read.data());
  EXPECT_EQ(read, (std::array<GLuint, 4>{0x12000080, 0x34FFFFFF, 0x56000040, 0x78000000}));
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  make_texture(gl, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE);
  gl.GetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, read.data());
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  const auto extensions = [&gl] {
    return ' ' + std::string(reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS))) + ' ';
  };
  EXPECT_EQ(extensions().find(" GL_ARB_framebuffer_object "), std::string::npos);
  legacy_gl_offer_extensions(
      "GL_ARB_framebuffer_object GL_NONE_such GL_EXT_framebuffer_object=GL_ARB_framebuffer_object "
      "GL_NONE_either=GL_NONE_such");
  EXPECT_NE(extensions().find(" GL_ARB_framebuffer_object "), std::string::npos);
  EXPECT_NE(extensions().find(" GL_EXT_framebuffer_object "), std::string::npos);
  EXPECT_EQ(extensions().find("GL_NONE"), std::string::npos);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace

}  // namespace legacy_gl::test
