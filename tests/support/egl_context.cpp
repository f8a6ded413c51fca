#include "support/egl_context.hpp"

#include <EGL/eglext.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace legacy_gl::test {

namespace {

EGLDisplay initialize_display() {
  // Read by Mesa when the display is initialised. 3.0 is the oldest GLES that legacy_gl takes:
  // nothing newer may slip in.
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  setenv("MESA_GLES_VERSION_OVERRIDE", "3.0", 1);
  const auto get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_platform_display == nullptr) throw std::runtime_error("no eglGetPlatformDisplayEXT");
  EGLDisplay display =
      get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  EGLint major = 0;
  EGLint minor = 0;
  if (eglInitialize(display, &major, &minor) == EGL_FALSE)
    throw std::runtime_error("eglInitialize failed on the surfaceless platform");
  return display;
}

EGLDisplay display() {
  // Never terminated: contexts of other threads may outlive any one owner.
  static EGLDisplay the_display = initialize_display();
  return the_display;
}

}  // namespace

EglContext::EglContext(int width, int height, PixelFormat color_format) {
  EGLDisplay the_display = display();
  eglBindAPI(EGL_OPENGL_ES_API);
  const std::array<EGLint, 3> attributes = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
  handle_ = eglCreateContext(the_display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
  if (handle_ == EGL_NO_CONTEXT) throw std::runtime_error("eglCreateContext failed for GLES 3.0");
  bind();
  framebuffer_ = std::make_unique<Framebuffer>(eglGetProcAddress, width, height, color_format);
}

EglContext::~EglContext() {
  framebuffer_.reset();
  release();
  eglDestroyContext(display(), handle_);
}

void EglContext::bind() {
  eglBindAPI(EGL_OPENGL_ES_API);
  if (eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, handle_) == EGL_FALSE)
    throw std::runtime_error("eglMakeCurrent failed");
}

void EglContext::release() {
  eglBindAPI(EGL_OPENGL_ES_API);
  eglMakeCurrent(display(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

}  // namespace legacy_gl::test
