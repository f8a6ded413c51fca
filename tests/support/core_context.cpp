#include <legacy_gl/context.hpp>

#include "support/contexts.hpp"
#include "support/osmesa_context.hpp"

namespace legacy_gl::test {

struct CoreContext::Data {
  legacy_gl_options options;
  CoreDriver driver;
  std::unique_ptr<OsmesaContext> osmesa;
  std::unique_ptr<OwnedContext> context;
};

CoreContext::CoreContext(int width, int height, PixelFormat color_format,
                         const legacy_gl_options& options, const CoreDriver& driver)
    : RenderContext(width, height, color_format),
      data_(std::make_unique<Data>(Data{test_options(options), driver, nullptr, nullptr})) {
  if (!data_->driver.loader) data_->driver.loader = OSMesaGetProcAddress;
  if (driver.shares) data_->options.share = driver.shares->handle();
  gl = load_gl_functions(legacy_gl_get_proc_address);
  create();
  make_current();
}

CoreContext::~CoreContext() { shut_down(); }

legacy_gl_context* CoreContext::handle() const { return data_->context->get(); }

legacy_gl_proc CoreContext::driver_proc(const char* name) { return OSMesaGetProcAddress(name); }

void CoreContext::create() {
  const CoreContext* const shares = data_->driver.shares;
  data_->osmesa = std::make_unique<OsmesaContext>(width(), height(), color_format(), Profile::core,
                                                  shares ? shares->data_->osmesa.get() : nullptr);
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
    data_->context = std::make_unique<OwnedContext>(data_->driver.loader, data_->options);
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
