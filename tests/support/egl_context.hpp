// A GLES 3.0 context on EGL's surfaceless platform with a framebuffer object of its own.
#pragma once

#include <EGL/egl.h>
#include <GLES3/gl3.h>

#include "support/image.hpp"

namespace legacy_gl::test {

class EglContext {
 public:
  // Makes the context current, creates the framebuffer object and leaves it bound.
  EglContext(int width, int height, PixelFormat color_format);
  // The context must be current; it is not afterwards.
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void bind();
  static void release();
  Image read() const;

 private:
  void create_framebuffer(int width, int height, PixelFormat color_format);

  EGLContext handle_ = EGL_NO_CONTEXT;
  GLuint framebuffer_ = 0;
  GLuint color_renderbuffer_ = 0;
  GLuint depth_stencil_renderbuffer_ = 0;
  int width_;
  int height_;
  PixelFormat color_format_;
};

}  // namespace legacy_gl::test
