#include "shadergen/emit.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

void emit_coverage_block(Writer& w, const FragmentKey& key) {
  if (key.coverage == Coverage::kPolygonStipple) w.raw(kPolygonStippleBlockText);
}

/// GL 2.1 spec 3.5.2. After texturing: a discarded neighbour leaves texels without derivatives.
void emit_coverage(Writer& w, const FragmentKey& key) {
  if (key.coverage != Coverage::kPolygonStipple) return;
  w.line("uvec2 stipple_at = uvec2(gl_FragCoord.xy) & 31u;");
  w.line("uint stipple_row = stipple_rows[stipple_at.y >> 2][stipple_at.y & 3u];");
  w.line("if ((stipple_row << stipple_at.x & 0x80000000u) == 0u) discard;");
}

}  // namespace legacy_gl
