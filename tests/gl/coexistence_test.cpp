// The contract of docs/coexistence.md: a program's own core OpenGL beside ours in one driver
// context.
#include <GL/glcorearb.h>
#include <gtest/gtest.h>

#include "scene_changes.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {
namespace {

template <typename Function>
Function driver(const char* name) {
  return reinterpret_cast<Function>(CoreContext::driver_proc(name));
}

/// A program's own drawing: a white triangle in the lower left corner, with states that ours would
/// not choose.
class OwnDrawing {
 public:
  OwnDrawing() {
    program_ = driver<PFNGLCREATEPROGRAMPROC>("glCreateProgram")();
    attach(GL_VERTEX_SHADER,
           "#version 330 core\nlayout(location = 0) in vec2 p;\n"
           "void main() { gl_Position = vec4(p, -0.9, 1.0); }\n");
    attach(GL_FRAGMENT_SHADER, "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n");
    driver<PFNGLLINKPROGRAMPROC>("glLinkProgram")(program_);
    driver<PFNGLGENVERTEXARRAYSPROC>("glGenVertexArrays")(1, &array_);
    driver<PFNGLBINDVERTEXARRAYPROC>("glBindVertexArray")(array_);
    driver<PFNGLGENBUFFERSPROC>("glGenBuffers")(1, &buffer_);
    driver<PFNGLBINDBUFFERPROC>("glBindBuffer")(GL_ARRAY_BUFFER, buffer_);
    const float positions[] = {-1, -1, -0.5f, -1, -1, -0.5f};
    driver<PFNGLBUFFERDATAPROC>("glBufferData")(GL_ARRAY_BUFFER, sizeof positions, positions,
                                                GL_STATIC_DRAW);
    driver<PFNGLVERTEXATTRIBPOINTERPROC>("glVertexAttribPointer")(0, 2, GL_FLOAT, GL_FALSE, 0,
                                                                  nullptr);
    driver<PFNGLENABLEVERTEXATTRIBARRAYPROC>("glEnableVertexAttribArray")(0);
  }

  void draw() const {
    driver<PFNGLUSEPROGRAMPROC>("glUseProgram")(program_);
    driver<PFNGLBINDVERTEXARRAYPROC>("glBindVertexArray")(array_);
    driver<PFNGLVIEWPORTPROC>("glViewport")(0, 0, 64, 64);
    for (const int off : {GL_CULL_FACE, GL_BLEND, GL_DEPTH_TEST, GL_SCISSOR_TEST})
      driver<PFNGLDISABLEPROC>("glDisable")(static_cast<GLenum>(off));
    driver<PFNGLDEPTHFUNCPROC>("glDepthFunc")(GL_NEVER);
    driver<PFNGLDRAWARRAYSPROC>("glDrawArrays")(GL_TRIANGLES, 0, 3);
    driver<PFNGLBINDBUFFERBASEPROC>("glBindBufferBase")(GL_UNIFORM_BUFFER, 0, 0);
    driver<PFNGLBINDBUFFERPROC>("glBindBuffer")(GL_ARRAY_BUFFER, 0);
    driver<PFNGLLINEWIDTHPROC>("glLineWidth")(1);
    driver<PFNGLCOLORMASKPROC>("glColorMask")(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }

 private:
  void attach(GLenum stage, const char* text) const {
    const GLuint shader = driver<PFNGLCREATESHADERPROC>("glCreateShader")(stage);
    driver<PFNGLSHADERSOURCEPROC>("glShaderSource")(shader, 1, &text, nullptr);
    driver<PFNGLCOMPILESHADERPROC>("glCompileShader")(shader);
    driver<PFNGLATTACHSHADERPROC>("glAttachShader")(program_, shader);
  }

  GLuint program_ = 0, array_ = 0, buffer_ = 0;
};

void draw_corner(const GlFunctions& gl) {
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(0.2f, 0.2f, 0);
  gl.Vertex3f(1, 0.2f, 0);
  gl.Vertex3f(1, 1, 0);
  gl.End();
}

TEST(Coexistence, OwnCallsBetweenOursLeaveOurPicture) {
  CoreContext alone(64, 64);
  set_up_scene(alone.gl);
  alone.gl.LineWidth(3);
  draw_scene(alone.gl);
  draw_corner(alone.gl);
  const Image expected = alone.read_rgba8();

  CoreContext context(64, 64);
  const GlFunctions& gl = context.gl;
  const OwnDrawing own;
  legacy_gl_reset_driver_state();
  set_up_scene(gl);
  gl.LineWidth(3);
  draw_scene(gl);
  legacy_gl_flush();
  own.draw();
  legacy_gl_reset_driver_state();
  draw_corner(gl);
  Image both = context.read_rgba8();

  // The program's triangle is where it drew it; everything else is as without it.
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const std::size_t at = 4 * (static_cast<std::size_t>(y) * 64 + static_cast<std::size_t>(x));
      if (x + y < 15) {
        ASSERT_EQ(both.bytes[at], 255) << x << ", " << y;
      } else if (x + y > 16) {
        for (std::size_t c = 0; c < 4; ++c)
          ASSERT_EQ(both.bytes[at + c], expected.bytes[at + c]) << x << ", " << y;
      }
    }
}

TEST(Coexistence, OwnStateIsNotOurs) {
  CoreContext context(16, 16);
  driver<PFNGLDEPTHFUNCPROC>("glDepthFunc")(GL_NEVER);
  legacy_gl_reset_driver_state();
  GLint function = 0;
  context.gl.GetIntegerv(GL_DEPTH_FUNC, &function);
  EXPECT_EQ(function, GL_LESS);
}

TEST(Coexistence, TheFramebufferBindingIsTheProgramsOwn) {
  CoreContext context(16, 16);
  GLuint framebuffer = 0, renderbuffer = 0;
  driver<PFNGLGENFRAMEBUFFERSPROC>("glGenFramebuffers")(1, &framebuffer);
  driver<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer")(GL_FRAMEBUFFER, framebuffer);
  driver<PFNGLGENRENDERBUFFERSPROC>("glGenRenderbuffers")(1, &renderbuffer);
  driver<PFNGLBINDRENDERBUFFERPROC>("glBindRenderbuffer")(GL_RENDERBUFFER, renderbuffer);
  driver<PFNGLRENDERBUFFERSTORAGEPROC>("glRenderbufferStorage")(GL_RENDERBUFFER, GL_RGBA8, 16, 16);
  driver<PFNGLFRAMEBUFFERRENDERBUFFERPROC>("glFramebufferRenderbuffer")(
      GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
  context.gl.Color3f(0, 1, 0);
  context.gl.Rectf(-1, -1, 1, 1);
  legacy_gl_flush();
  GLint bound = 0;
  driver<PFNGLGETINTEGERVPROC>("glGetIntegerv")(GL_FRAMEBUFFER_BINDING, &bound);
  EXPECT_EQ(static_cast<GLuint>(bound), framebuffer);
  GLubyte pixel[4] = {};
  driver<PFNGLREADPIXELSPROC>("glReadPixels")(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  EXPECT_EQ(pixel[1], 255);
  driver<PFNGLBINDFRAMEBUFFERPROC>("glBindFramebuffer")(GL_FRAMEBUFFER, 0);
  EXPECT_EQ(context.read_rgba8().bytes[1], 0) << "nothing was drawn to the window";
}

}  // namespace
}  // namespace legacy_gl::test
