// An off-screen OpenGL ES 3 context on EGL's surfaceless platform.
#pragma once

#include <EGL/egl.h>

#include "support/picture.hpp"

namespace samples {

class EglSurface {
 public:
  // Current after construction. Throws std::runtime_error when EGL refuses.
  EglSurface(int width, int height);
  ~EglSurface();
  EglSurface(const EglSurface&) = delete;
  EglSurface& operator=(const EglSurface&) = delete;

  // What was drawn.
  const Picture& picture();

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLSurface surface_ = EGL_NO_SURFACE;
  EGLContext context_ = EGL_NO_CONTEXT;
  Picture picture_;
};

}  // namespace samples
