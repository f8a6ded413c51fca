// Polygon modes, stipples, widths, culling, offsets, clip planes.
#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

void change_stipple(Builder& b) {
  auto& random = b.random;
  if (b.traits.line_stipple && random.chance(50)) {
    if (random.chance(50))
      return b.call("LineStipple", random.between(1, 4), random.between(1, 65535));
    return b.enable("GL_LINE_STIPPLE", random.chance(80));
  }
  if (!b.traits.polygon_stipple) return;
  // M24: of whole bytes.
  if (random.chance(40))
    return b.call("PolygonStipple", input("GLubyte", random.whole(128, 0, 255)));
  b.enable("GL_POLYGON_STIPPLE", random.chance(80));
}

void change_unfilled(Builder& b) {
  // M19 does not concern these: stipple and unfilled polygons exclude each other.
  b.call("PolygonMode", b.random.pick({"GL_FRONT", "GL_BACK", "GL_FRONT_AND_BACK"}),
         b.random.pick({"GL_LINE", "GL_POINT", "GL_FILL"}));
}

void change_width(Builder& b) {
  if (b.random.chance(50))
    return b.call("LineWidth",
                  b.random.chance(50) ? b.random.between(1, 6) : b.random.real(0.5, 5));
  b.call("PointSize", b.random.chance(50) ? b.random.between(1, 8) : b.random.real(0.5, 8));
}

void change_clip_plane(Builder& b) {
  const char* plane = b.random.pick({"GL_CLIP_PLANE0", "GL_CLIP_PLANE1"});
  if (b.random.chance(50)) return b.enable(plane, b.random.chance(70));
  auto equation = b.random.reals(4, -1, 1);
  equation[3] = b.random.real(0, 0.6);
  b.call("ClipPlane", plane, input("GLdouble", equation));
}

}  // namespace

void change_rasterization(Builder& b) {
  auto& random = b.random;
  const Traits& traits = b.traits;
  switch (random.below(9)) {
    case 0: return b.enable("GL_CULL_FACE", random.chance(40));
    case 1: return b.call("CullFace", random.pick({"GL_FRONT", "GL_BACK"}));
    case 2: return b.call("FrontFace", random.pick({"GL_CW", "GL_CCW"}));
    case 3:
      if (random.chance(50))
        return b.call("PolygonOffset", random.real(-2, 2), random.between(-8, 8));
      // Offsets of the other modes: R2.
      return b.enable("GL_POLYGON_OFFSET_FILL", random.chance(60));
    case 4:
      if (traits.smooth_lines && !traits.line_stipple)
        return b.enable("GL_LINE_SMOOTH", random.chance(70));
      return b.call("ShadeModel",
                    traits.flat ? random.pick({"GL_FLAT", "GL_SMOOTH"}) : "GL_SMOOTH");
    case 5:
      if (traits.clip_planes) return change_clip_plane(b);
      [[fallthrough]];
    case 6:
      if (traits.unfilled) return change_unfilled(b);
      [[fallthrough]];
    case 7:
      if (traits.wide) return change_width(b);
      [[fallthrough]];
    default: return change_stipple(b);
  }
}

}  // namespace legacy_gl::fuzz
