// A GLES 3.0 context on EGL's surfaceless platform with a framebuffer object of its own.
#pragma once

#include <EGL/egl.h>

#include <memory>

#include "support/framebuffer.hpp"

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
  Image read() const { return framebuffer_->read(); }

 private:
  EGLContext handle_ = EGL_NO_CONTEXT;
  std::unique_ptr<Framebuffer> framebuffer_;
};

}  // namespace legacy_gl::test
