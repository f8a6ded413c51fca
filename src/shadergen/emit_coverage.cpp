#include "shadergen/emit.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

void emit_coverage_block(Writer& w, const ProgramKey& key) {
  switch (key.fragments.coverage) {
    case Coverage::kWhole: break;
    case Coverage::kPolygonStipple: w.raw(kPolygonStippleBlockText); break;
    case Coverage::kSmoothPoint:
      if (!key.per_fragment && !key.point_distance) w.raw(kTransformBlockText);
      break;
  }
}

/// After texturing: a discarded neighbour leaves texels without derivatives.
void emit_coverage(Writer& w, const ProgramKey& key, FragmentColors& colors) {
  switch (key.fragments.coverage) {
    case Coverage::kWhole: break;
    case Coverage::kPolygonStipple:  // GL 2.1 spec 3.5.2
      w.line("uvec2 stipple_at = uvec2(gl_FragCoord.xy) & 31u;");
      w.line("uint stipple_row = stipple_rows[stipple_at.y >> 2][stipple_at.y & 3u];");
      w.line("if ((stipple_row << stipple_at.x & 0x80000000u) == 0u) discard;");
      break;
    case Coverage::kSmoothPoint:  // GL 2.1 spec 3.3.1, 3.11: a ramp of one pixel
      colors.make_variable(w);
      w.line(std::string("float coverage = ") + (key.point_distance ? "point_side" : "point.w") +
             " * (0.5 - length(gl_PointCoord - 0.5));");
      w.line("if (coverage <= 0.0) discard;");
      w.line("color.a *= min(coverage, 1.0);");
      break;
  }
}

}  // namespace legacy_gl
