#include "support/osmesa_context.hpp"

#include <array>
#include <stdexcept>

namespace legacy_gl::test {

OsmesaContext::OsmesaContext(int width, int height, PixelFormat color_format, Profile profile,
                             const OsmesaContext* shares)
    : color_buffer_(color_format, width, height) {
  // A compatibility context is asked for without a version: Mesa gives the newest.
  const bool core = profile == Profile::core;
  const std::array<int, 16> attributes = {OSMESA_FORMAT,
                                          OSMESA_RGBA,
                                          OSMESA_DEPTH_BITS,
                                          24,
                                          OSMESA_STENCIL_BITS,
                                          8,
                                          OSMESA_ACCUM_BITS,
                                          core ? 0 : 16,
                                          OSMESA_PROFILE,
                                          core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE,
                                          core ? OSMESA_CONTEXT_MAJOR_VERSION : 0,
                                          3,
                                          OSMESA_CONTEXT_MINOR_VERSION,
                                          3,
                                          0};
  handle_ = OSMesaCreateContextAttribs(attributes.data(), shares ? shares->handle_ : nullptr);
  if (handle_ == nullptr) throw std::runtime_error("OSMesaCreateContextAttribs failed");
}

OsmesaContext::~OsmesaContext() { OSMesaDestroyContext(handle_); }

void OsmesaContext::bind() {
  const GLenum type =
      color_buffer_.format == PixelFormat::rgba8 ? GLenum{GL_UNSIGNED_BYTE} : GLenum{GL_FLOAT};
  if (OSMesaMakeCurrent(handle_, color_buffer_.data(), type, color_buffer_.width,
                        color_buffer_.height) == GL_FALSE)
    throw std::runtime_error("OSMesaMakeCurrent failed");
}

void OsmesaContext::release() { OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }

const Image& OsmesaContext::finish_and_read() {
  // OSMesa copies its surface to the client's memory at glFinish.
  reinterpret_cast<void (*)()>(OSMesaGetProcAddress("glFinish"))();
  return color_buffer_;
}

}  // namespace legacy_gl::test
