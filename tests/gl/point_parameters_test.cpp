// glPointParameter (GL 2.1 spec 3.3). Pictures of attenuated points are compared with Mesa's in
// tests/conformance/points_lines.cpp.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 32;

// Of later versions.
constexpr GLenum kRenderbuffer = 0x8D41, kFramebuffer = 0x8D40, kDrawFramebuffer = 0x8CA9,
                 kColorAttachment0 = 0x8CE0;
using GenNames = void (*)(GLsizei, GLuint*);
using Bind = void (*)(GLenum, GLuint);
using RenderbufferStorageMultisample = void (*)(GLenum, GLsizei, GLenum, GLsizei, GLsizei);
using FramebufferRenderbuffer = void (*)(GLenum, GLenum, GLenum, GLuint);
using BlitFramebuffer = void (*)(GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield,
                                 GLenum);

template <typename Function>
Function driver(const char* name) {
  return reinterpret_cast<Function>(CoreContext::driver_proc(name));
}

GLfloat get(const GlFunctions& gl, GLenum name) {
  GLfloat value = -1;
  gl.GetFloatv(name, &value);
  return value;
}

using Floats3 = std::array<GLfloat, 3>;

Floats3 get_attenuation(const GlFunctions& gl) {
  Floats3 values{};
  gl.GetFloatv(GL_POINT_DISTANCE_ATTENUATION, values.data());
  return values;
}

/// How many pixels have this alpha.
int count(const GlFunctions& gl, GLubyte alpha) {
  std::vector<GLubyte> pixels(std::size_t{kSize} * kSize * 4);
  gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  int found = 0;
  for (std::size_t i = 3; i < pixels.size(); i += 4) found += pixels[i] == alpha;
  return found;
}

void draw_point(const GlFunctions& gl, float x, float y, float z) {
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Begin(GL_POINTS);
  gl.Vertex3f(x, y, z);
  gl.End();
}

/// A framebuffer object with one colour buffer.
GLuint make_framebuffer(GLsizei samples) {
  GLuint framebuffer = 0, buffer = 0;
  driver<GenNames>("glGenRenderbuffers")(1, &buffer);
  driver<Bind>("glBindRenderbuffer")(kRenderbuffer, buffer);
  driver<RenderbufferStorageMultisample>("glRenderbufferStorageMultisample")(
      kRenderbuffer, samples, GL_RGBA8, kSize, kSize);
  driver<GenNames>("glGenFramebuffers")(1, &framebuffer);
  driver<Bind>("glBindFramebuffer")(kFramebuffer, framebuffer);
  driver<FramebufferRenderbuffer>("glFramebufferRenderbuffer")(kFramebuffer, kColorAttachment0,
                                                               kRenderbuffer, buffer);
  return framebuffer;
}

void bind_framebuffer(GLenum target, GLuint framebuffer) {
  legacy_gl_flush();
  driver<Bind>("glBindFramebuffer")(target, framebuffer);
  legacy_gl_reset_driver_state();
}

}  // namespace

TEST(PointParameters, InitialState) {
  CoreContext context(kSize, kSize);
  std::array<GLfloat, 2> range{};
  context.gl.GetFloatv(GL_ALIASED_POINT_SIZE_RANGE, range.data());
  EXPECT_EQ(get(context.gl, GL_POINT_SIZE_MIN), 0);
  EXPECT_EQ(get(context.gl, GL_POINT_SIZE_MAX), range[1]);
  EXPECT_EQ(get(context.gl, GL_POINT_FADE_THRESHOLD_SIZE), 1);
  EXPECT_EQ(get_attenuation(context.gl), (Floats3{1, 0, 0}));
}

TEST(PointParameters, SetAndGet) {
  CoreContext context(kSize, kSize);
  const GlFunctions& gl = context.gl;
  constexpr GLint attenuation[] = {2, 3, 4};
  gl.PushAttrib(GL_POINT_BIT);
  gl.PointParameterf(GL_POINT_SIZE_MIN, 2.5F);
  gl.PointParameteri(GL_POINT_SIZE_MAX, 7);
  gl.NewList(1, GL_COMPILE);
  gl.PointParameteriv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  gl.EndList();
  EXPECT_EQ(get_attenuation(gl), (Floats3{1, 0, 0}));
  gl.CallList(1);
  EXPECT_EQ(get(gl, GL_POINT_SIZE_MIN), 2.5F);
  EXPECT_EQ(get(gl, GL_POINT_SIZE_MAX), 7);
  EXPECT_EQ(get_attenuation(gl), (Floats3{2, 3, 4}));
  gl.PopAttrib();
  EXPECT_EQ(get(gl, GL_POINT_SIZE_MIN), 0);
  EXPECT_EQ(get_attenuation(gl), (Floats3{1, 0, 0}));
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

// 20 / sqrt(d^2 / 4) at d = 5; by depth alone, row M21, it would be 10.
TEST(PointParameters, DistanceIsThatFromTheEye) {
  CoreContext context(kSize, kSize);
  const GlFunctions& gl = context.gl;
  constexpr GLfloat attenuation[] = {0, 0, 0.25F};
  gl.MatrixMode(GL_PROJECTION);
  gl.Ortho(-8, 8, -8, 8, 0, 8);
  gl.PointSize(20);
  gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
  draw_point(gl, 3, 0, -4);
  EXPECT_EQ(count(gl, 255), 8 * 8);
}

// A point of 2 pixels under a threshold of 4 has 4, and (2 / 4)^2 of its alpha.
TEST(PointParameters, SmallPointsFadeUnderMultisampling) {
  CoreContext context(kSize, kSize);
  const GlFunctions& gl = context.gl;
  const GLuint single = make_framebuffer(0), multiple = make_framebuffer(4);
  gl.PointSize(2);
  gl.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 4);
  bind_framebuffer(kFramebuffer, single);
  draw_point(gl, 0, 0, 0);
  EXPECT_EQ(count(gl, 255), 2 * 2);
  bind_framebuffer(kFramebuffer, multiple);
  draw_point(gl, 0, 0, 0);
  bind_framebuffer(kDrawFramebuffer, single);
  driver<BlitFramebuffer>("glBlitFramebuffer")(0, 0, kSize, kSize, 0, 0, kSize, kSize,
                                               GL_COLOR_BUFFER_BIT, GL_NEAREST);
  bind_framebuffer(kFramebuffer, single);
  EXPECT_EQ(count(gl, 64), 4 * 4);
  EXPECT_EQ(count(gl, 0), kSize * kSize - 4 * 4);
}

}  // namespace legacy_gl::test
