// Calls that raise errors and change nothing. Those that Mesa takes (M10) are left out.
#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

void call_wrongly(Builder& b) {
  switch (b.random.below(16)) {
    case 0: return b.call("Enable", "GL_AMBIENT");
    case 1: return b.call("Begin", "GL_AMBIENT");
    case 2: return b.call("End");
    case 3: return b.call("LineWidth", 0);
    case 4: return b.call("PointSize", -1);
    case 5: return b.call("Lightf", "GL_LIGHT0", "GL_SPOT_CUTOFF", 100);
    case 6: return b.call("Lightf", "GL_LIGHT0", "GL_LINEAR_ATTENUATION", -1);
    case 7: return b.call("Materialf", "GL_FRONT", "GL_SHININESS", 129);
    case 8: return b.call("Fogf", "GL_FOG_DENSITY", -1);
    case 9: return b.call("Viewport", 0, 0, -1, 4);
    case 10: return b.call("MatrixMode", "GL_LIGHT0");
    case 11: return b.call("Ortho", 1, 1, 0, 1, 0, 1);
    case 12: return b.call("Frustum", 0, 1, 0, 1, -1, 1);
    case 13: return b.call("BlendFunc", "GL_LIGHT0", "GL_ONE");
    case 14: return b.call("NewList", 0, "GL_COMPILE");
    default: return b.call("EndList");
  }
}

}  // namespace

void raise_error(Builder& b) {
  if (b.in_list || b.in_stack) return;
  call_wrongly(b);
  b.call("GetError");
}

}  // namespace legacy_gl::fuzz
