#include "support/egl_context.hpp"

#include <EGL/eglext.h>

#include <array>
#include <cstdlib>
#include <stdexcept>

namespace legacy_gl::test {

namespace {

// Linking libGLESv2 beside libOSMesa would give every gl name twice.
template <typename Function>
Function driver_function(const char* name) {
  const auto function = reinterpret_cast<Function>(eglGetProcAddress(name));
  if (function == nullptr) throw std::runtime_error(std::string("no ") + name);
  return function;
}

#define DRIVER(name) driver_function<decltype(&::name)>(#name)

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

EglContext::EglContext(int width, int height, PixelFormat color_format)
    : width_(width), height_(height), color_format_(color_format) {
  EGLDisplay the_display = display();
  eglBindAPI(EGL_OPENGL_ES_API);
  const std::array<EGLint, 3> attributes = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
  handle_ = eglCreateContext(the_display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
  if (handle_ == EGL_NO_CONTEXT) throw std::runtime_error("eglCreateContext failed for GLES 3.0");
  bind();
  create_framebuffer(width, height, color_format);
}

EglContext::~EglContext() {
  DRIVER(glDeleteFramebuffers)(1, &framebuffer_);
  DRIVER(glDeleteRenderbuffers)(1, &color_renderbuffer_);
  DRIVER(glDeleteRenderbuffers)(1, &depth_stencil_renderbuffer_);
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

void EglContext::create_framebuffer(int width, int height, PixelFormat color_format) {
  // RGBA32F is renderable by EXT_color_buffer_float, which Mesa has; without it the framebuffer is
  // incomplete and this throws.
  const GLenum color = color_format == PixelFormat::rgba8 ? GLenum{GL_RGBA8} : GLenum{GL_RGBA32F};
  DRIVER(glGenRenderbuffers)(1, &color_renderbuffer_);
  DRIVER(glBindRenderbuffer)(GL_RENDERBUFFER, color_renderbuffer_);
  DRIVER(glRenderbufferStorage)(GL_RENDERBUFFER, color, width, height);
  DRIVER(glGenRenderbuffers)(1, &depth_stencil_renderbuffer_);
  DRIVER(glBindRenderbuffer)(GL_RENDERBUFFER, depth_stencil_renderbuffer_);
  DRIVER(glRenderbufferStorage)(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width, height);
  DRIVER(glGenFramebuffers)(1, &framebuffer_);
  DRIVER(glBindFramebuffer)(GL_FRAMEBUFFER, framebuffer_);
  DRIVER(glFramebufferRenderbuffer)
  (GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_renderbuffer_);
  DRIVER(glFramebufferRenderbuffer)
  (GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_stencil_renderbuffer_);
  if (DRIVER(glCheckFramebufferStatus)(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("the framebuffer object is incomplete");
  // Without a surface the initial viewport is empty; a program sets both once.
  DRIVER(glViewport)(0, 0, width, height);
  DRIVER(glScissor)(0, 0, width, height);
}

Image EglContext::read() const {
  Image image(color_format_, width_, height_);
  DRIVER(glBindFramebuffer)(GL_READ_FRAMEBUFFER, framebuffer_);
  DRIVER(glReadPixels)
  (0, 0, width_, height_, GL_RGBA,
   color_format_ == PixelFormat::rgba8 ? GLenum{GL_UNSIGNED_BYTE} : GLenum{GL_FLOAT}, image.data());
  return image;
}

#undef DRIVER

}  // namespace legacy_gl::test
