// A framebuffer object with a colour, a depth and a stencil buffer, as a program makes one that has
// no window surface.
#pragma once

#include <legacy_gl/context.h>

#include "support/image.hpp"

namespace legacy_gl::test {

class Framebuffer {
 public:
  // Creates it in the current driver context and leaves it bound, with the viewport and the scissor
  // rectangle over all of it.
  Framebuffer(legacy_gl_loader driver, int width, int height, PixelFormat color_format);
  // The same context must be current.
  ~Framebuffer();
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;

  Image read() const;

 private:
  template <typename Function>
  Function driver_function(const char* name) const;

  legacy_gl_loader driver_;
  int width_;
  int height_;
  PixelFormat color_format_;
  unsigned framebuffer_ = 0;
  unsigned color_renderbuffer_ = 0;
  unsigned depth_stencil_renderbuffer_ = 0;
};

}  // namespace legacy_gl::test
