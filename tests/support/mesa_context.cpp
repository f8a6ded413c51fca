#include "support/contexts.hpp"
#include "support/framebuffer.hpp"
#include "support/osmesa_context.hpp"

namespace legacy_gl::test {

struct MesaContext::Data {
  Target target;
  std::unique_ptr<OsmesaContext> osmesa;
  std::unique_ptr<Framebuffer> framebuffer;
};

MesaContext::MesaContext(int width, int height, PixelFormat color_format, Target target)
    : RenderContext(width, height, color_format),
      data_(std::make_unique<Data>(Data{target, nullptr, nullptr})) {
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
  data_->framebuffer.reset();
  OsmesaContext::release();
  data_->osmesa.reset();
}

void MesaContext::bind() {
  data_->osmesa->bind();
  if (data_->target == Target::framebuffer_object && !data_->framebuffer)
    data_->framebuffer =
        std::make_unique<Framebuffer>(OSMesaGetProcAddress, width(), height(), color_format());
}

void MesaContext::release() { OsmesaContext::release(); }

Image MesaContext::read() {
  return data_->framebuffer ? data_->framebuffer->read() : data_->osmesa->finish_and_read();
}

}  // namespace legacy_gl::test
