#include "support/framebuffer.hpp"

#include <GLES3/gl3.h>

#include <stdexcept>
#include <string>

namespace legacy_gl::test {

// Only the types come from the GLES header: linking libGLESv2 beside libOSMesa would give every gl
// name twice.
template <typename Function>
Function Framebuffer::driver_function(const char* name) const {
  const auto function = reinterpret_cast<Function>(driver_(name));
  if (function == nullptr) throw std::runtime_error(std::string("no ") + name);
  return function;
}

#define DRIVER(name) driver_function<decltype(&::name)>(#name)

Framebuffer::Framebuffer(legacy_gl_loader driver, int width, int height, PixelFormat color_format)
    : driver_(driver), width_(width), height_(height), color_format_(color_format) {
  // On GLES RGBA32F is renderable by EXT_color_buffer_float, which Mesa has; without it the
  // framebuffer is incomplete and this throws.
  const GLenum color = color_format == PixelFormat::rgba8 ? GLenum{GL_RGBA8} : GLenum{GL_RGBA32F};
  DRIVER(glGenRenderbuffers)(1, &color_renderbuffer_);
  DRIVER(glBindRenderbuffer)(GL_RENDERBUFFER, color_renderbuffer_);
  DRIVER(glRenderbufferStorage)(GL_RENDERBUFFER, color, width, height);
  DRIVER(glGenRenderbuffers)(1, &depth_stencil_renderbuffer_);
  DRIVER(glBindRenderbuffer)(GL_RENDERBUFFER, depth_stencil_renderbuffer_);
  DRIVER(glRenderbufferStorage)(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width, height);
  DRIVER(glGenFramebuffers)(1, &framebuffer_);
  DRIVER(glBindFramebuffer)(GL_FRAMEBUFFER, framebuffer_);
  const auto attach = DRIVER(glFramebufferRenderbuffer);
  attach(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_renderbuffer_);
  attach(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_stencil_renderbuffer_);
  if (DRIVER(glCheckFramebufferStatus)(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("the framebuffer object is incomplete");
  // Without a surface the initial rectangles are empty; a program sets both once.
  DRIVER(glViewport)(0, 0, width, height);
  DRIVER(glScissor)(0, 0, width, height);
}

Framebuffer::~Framebuffer() {
  DRIVER(glDeleteFramebuffers)(1, &framebuffer_);
  DRIVER(glDeleteRenderbuffers)(1, &color_renderbuffer_);
  DRIVER(glDeleteRenderbuffers)(1, &depth_stencil_renderbuffer_);
}

Image Framebuffer::read() const {
  Image image(color_format_, width_, height_);
  DRIVER(glBindFramebuffer)(GL_READ_FRAMEBUFFER, framebuffer_);
  const GLenum type =
      color_format_ == PixelFormat::rgba8 ? GLenum{GL_UNSIGNED_BYTE} : GLenum{GL_FLOAT};
  DRIVER(glReadPixels)(0, 0, width_, height_, GL_RGBA, type, image.data());
  return image;
}

#undef DRIVER

}  // namespace legacy_gl::test
