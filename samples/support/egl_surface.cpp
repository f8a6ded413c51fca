#include "support/egl_surface.hpp"

#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <stdexcept>

namespace samples {

EglSurface::EglSurface(int width, int height) : picture_(width, height) {
  const auto get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_platform_display == nullptr) {
    throw std::runtime_error("EGL has no platform displays");
  }
  display_ = get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  const EGLint config_attributes[] = {EGL_SURFACE_TYPE,
                                      EGL_PBUFFER_BIT,
                                      EGL_RENDERABLE_TYPE,
                                      EGL_OPENGL_ES3_BIT,
                                      EGL_RED_SIZE,
                                      8,
                                      EGL_GREEN_SIZE,
                                      8,
                                      EGL_BLUE_SIZE,
                                      8,
                                      EGL_ALPHA_SIZE,
                                      8,
                                      EGL_DEPTH_SIZE,
                                      24,
                                      EGL_NONE};
  EGLConfig config = nullptr;
  EGLint config_count = 0;
  if (eglInitialize(display_, nullptr, nullptr) == EGL_FALSE ||
      eglChooseConfig(display_, config_attributes, &config, 1, &config_count) == EGL_FALSE ||
      config_count == 0) {
    throw std::runtime_error("EGL has no off-screen display for OpenGL ES 3");
  }
  const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
  surface_ = eglCreatePbufferSurface(display_, config, size);
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
  eglBindAPI(EGL_OPENGL_ES_API);
  context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
  if (eglMakeCurrent(display_, surface_, surface_, context_) == EGL_FALSE) {
    throw std::runtime_error("EGL refuses a context");
  }
}

EglSurface::~EglSurface() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglDestroySurface(display_, surface_);
  eglTerminate(display_);
}

const Picture& EglSurface::picture() {
  // By address: linking libGLESv2 beside libOSMesa would give this name twice.
  const auto read_pixels =
      reinterpret_cast<decltype(&glReadPixels)>(eglGetProcAddress("glReadPixels"));
  read_pixels(0, 0, picture_.width, picture_.height, GL_RGBA, GL_UNSIGNED_BYTE,
              picture_.rgba.data());
  return picture_;
}

}  // namespace samples
