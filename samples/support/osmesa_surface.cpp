#include "support/osmesa_surface.hpp"

#include <stdexcept>

namespace samples {

OsmesaSurface::OsmesaSurface(Profile profile, int width, int height) : picture_(width, height) {
  const bool core = profile == Profile::core;
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_PROFILE,
                            core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            core ? 3 : 2,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            core ? 3 : 1,
                            0};
  context_ = OSMesaCreateContextAttribs(attributes, nullptr);
  if (context_ == nullptr || OSMesaMakeCurrent(context_, picture_.rgba.data(), GL_UNSIGNED_BYTE,
                                               width, height) == GL_FALSE) {
    throw std::runtime_error("OSMesa refuses a context");
  }
}

OsmesaSurface::~OsmesaSurface() {
  OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  OSMesaDestroyContext(context_);
}

}  // namespace samples
