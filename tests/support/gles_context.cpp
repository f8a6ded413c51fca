#include <legacy_gl/context.hpp>

#include "support/contexts.hpp"
#include "support/egl_context.hpp"

namespace legacy_gl::test {

struct GlesContext::Data {
  legacy_gl_options options;
  std::unique_ptr<EglContext> egl;
  std::unique_ptr<OwnedContext> context;
};

GlesContext::GlesContext(int width, int height, PixelFormat color_format,
                         const legacy_gl_options& options)
    : RenderContext(width, height, color_format),
      data_(std::make_unique<Data>(Data{test_options(options), nullptr, nullptr})) {
  gl = load_gl_functions(legacy_gl_get_proc_address);
  make_current();
}

GlesContext::~GlesContext() { shut_down(); }

legacy_gl_context* GlesContext::handle() const { return data_->context->get(); }

legacy_gl_proc GlesContext::driver_proc(const char* name) { return eglGetProcAddress(name); }

// bind() does it: an EGL context is made current to get its framebuffer object.
void GlesContext::create() {}

void GlesContext::destroy() {
  data_->context.reset();
  data_->egl.reset();
}

void GlesContext::bind() {
  if (!data_->egl) data_->egl = std::make_unique<EglContext>(width(), height(), color_format());
  else data_->egl->bind();
  if (!data_->context)
    data_->context = std::make_unique<OwnedContext>(eglGetProcAddress, data_->options);
  data_->context->make_current();
}

void GlesContext::release() {
  legacy_gl_make_current(nullptr);
  EglContext::release();
}

Image GlesContext::read() {
  legacy_gl_flush();
  return data_->egl->read();
}

}  // namespace legacy_gl::test
