// An off-screen OpenGL context with its picture in memory.
#pragma once

#include <GL/osmesa.h>

#include "support/picture.hpp"

namespace samples {

class OsmesaSurface {
 public:
  enum class Profile { compatibility, core };

  // Current after construction. Throws std::runtime_error when Mesa refuses.
  OsmesaSurface(Profile profile, int width, int height);
  ~OsmesaSurface();
  OsmesaSurface(const OsmesaSurface&) = delete;
  OsmesaSurface& operator=(const OsmesaSurface&) = delete;

  // What was drawn, after glFinish.
  const Picture& picture() const { return picture_; }

 private:
  OSMesaContext context_ = nullptr;
  Picture picture_;
};

}  // namespace samples
