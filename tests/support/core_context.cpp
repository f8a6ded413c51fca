#include <legacy_gl/context.hpp>

#include "support/contexts.hpp"
#include "support/osmesa_context.hpp"

namespace legacy_gl::test {

struct CoreContext::Data {
  legacy_gl_options options;
  std::unique_ptr<OsmesaContext> osmesa;
  std::unique_ptr<OwnedContext> context;
};

CoreContext::CoreContext(int width, int height, PixelFormat color_format,
                         const legacy_gl_options& options)
    : RenderContext(width, height, color_format),
      data_(std::make_unique<Data>(Data{test_options(options), nullptr, nullptr})) {
  gl = load_gl_functions(legacy_gl_get_proc_address);
  create();
  make_current();
}

CoreContext::~CoreContext() { shut_down(); }

legacy_gl_context* CoreContext::handle() const { return data_->context->get(); }

legacy_gl_proc CoreContext::driver_proc(const char* name) { return OSMesaGetProcAddress(name); }

void CoreContext::create() {
  data_->osmesa = std::make_unique<OsmesaContext>(width(), height(), color_format(), Profile::core);
}

void CoreContext::destroy() {
  data_->context.reset();
  OsmesaContext::release();
  data_->osmesa.reset();
}

void CoreContext::bind() {
  data_->osmesa->bind();
  // Here rather than in create(): the library asks the current driver context.
  if (!data_->context)
    data_->context = std::make_unique<OwnedContext>(OSMesaGetProcAddress, data_->options);
  data_->context->make_current();
}

void CoreContext::release() {
  legacy_gl_make_current(nullptr);
  OsmesaContext::release();
}

Image CoreContext::read() {
  legacy_gl_flush();
  return data_->osmesa->finish_and_read();
}

}  // namespace legacy_gl::test
