#include "support/contexts.hpp"
#include "support/osmesa_context.hpp"

namespace legacy_gl::test {

struct MesaContext::Data {
  std::unique_ptr<OsmesaContext> osmesa;
};

MesaContext::MesaContext(int width, int height, PixelFormat color_format)
    : RenderContext(width, height, color_format), data_(std::make_unique<Data>()) {
  gl = load_gl_functions(OSMesaGetProcAddress);
  create();
  make_current();
}

MesaContext::~MesaContext() { shut_down(); }

void MesaContext::create() {
  data_->osmesa =
      std::make_unique<OsmesaContext>(width(), height(), color_format(), Profile::compatibility);
}

void MesaContext::destroy() {
  OsmesaContext::release();
  data_->osmesa.reset();
}

void MesaContext::bind() { data_->osmesa->bind(); }
void MesaContext::release() { OsmesaContext::release(); }
Image MesaContext::read() { return data_->osmesa->finish_and_read(); }

}  // namespace legacy_gl::test
