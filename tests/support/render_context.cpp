#include <stdexcept>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

// OSMesa and EGL share Mesa's notion of the thread's current context but each believes to be its
// only owner: eglMakeCurrent of the context it made current last does nothing, whatever OSMesa did
// meanwhile. So the one that is current is released before another becomes current.
thread_local RenderContext* current_context = nullptr;

}  // namespace

void RenderContext::make_current() {
  if (current_context == this) return;
  if (current_context != nullptr) current_context->release();
  current_context = nullptr;
  bind();
  current_context = this;
}

void RenderContext::recreate() {
  shut_down();
  create();
  make_current();
}

void RenderContext::shut_down() {
  make_current();
  destroy();
  current_context = nullptr;
}

Image RenderContext::read_rgba8() {
  if (color_format_ != PixelFormat::rgba8)
    throw std::runtime_error("read_rgba8: the colour buffer is not RGBA8");
  return read();
}

Image RenderContext::read_float() {
  Image image = read();
  if (image.format == PixelFormat::rgba32f) return image;
  Image result(PixelFormat::rgba32f, image.width, image.height);
  for (std::size_t i = 0; i < image.bytes.size(); ++i)
    result.floats[i] = static_cast<float>(image.bytes[i]) / 255.0F;
  return result;
}

}  // namespace legacy_gl::test
