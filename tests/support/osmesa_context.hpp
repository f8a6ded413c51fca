// An OSMesa context with its colour buffer in client memory.
#pragma once

#include <GL/osmesa.h>

#include "support/image.hpp"

namespace legacy_gl::test {

enum class Profile { compatibility, core };

class OsmesaContext {
 public:
  OsmesaContext(int width, int height, PixelFormat color_format, Profile profile,
                const OsmesaContext* shares = nullptr);
  ~OsmesaContext();
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  void bind();
  static void release();
  // The context must be current.
  const Image& finish_and_read();

 private:
  OSMesaContext handle_ = nullptr;
  Image color_buffer_;
};

}  // namespace legacy_gl::test
