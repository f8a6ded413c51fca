#include "shadergen/emit.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

void emit_fog_block(Writer& w, const FragmentKey& key) {
  if (key.has_fog() || key.has_alpha_test()) w.raw(kFragmentsBlockText);
}

/// GL 2.1 spec 3.10: the distance of a vertex along the eye's axis, or its fog coordinate.
void emit_fog_coordinate(Writer& w, const FragmentKey& key) {
  if (!key.has_fog()) return;
  w.line(key.fog_coordinate ? "fog_distance = fog_coordinate;"
                            : "fog_distance = abs(dot(eye_depth, position));");
}

void emit_fog(Writer& w, const FragmentKey& key, FragmentColors& colors) {
  if (!key.has_fog()) return;
  colors.make_variable(w);
  switch (key.fog) {
    case FogMode::kNone: break;
    case FogMode::kLinear:
      w.line("float fog = fog_parameters.y - fog_parameters.x * fog_distance;");
      break;
    case FogMode::kExp: w.line("float fog = exp2(-fog_parameters.x * fog_distance);"); break;
    case FogMode::kExp2:
      w.line("float fog_depth = fog_parameters.x * fog_distance;");
      w.line("float fog = exp2(-fog_depth * fog_depth);");
      break;
  }
  w.line("color.rgb = mix(fog_color.rgb, clamp(color.rgb, 0.0, 1.0), clamp(fog, 0.0, 1.0));");
}

}  // namespace legacy_gl
