#include "shadergen/emit_texture.hpp"

namespace legacy_gl {

bool has_secondary(const ProgramKey& key) {
  return key.separate_specular || key.secondary_from_vertex;
}

namespace {

void emit_color_varyings(Writer& w, const ProgramKey& key, Dialect dialect,
                         const std::string& direction) {
  // A driver may drop what only rounding makes of an expression, but not on the way to an invariant
  // output. GLSL 3.30 wants both ends to say so, OpenGL ES the output alone.
  const bool exact =
      key.quality == Quality::kPrecise && (direction == "out" || dialect == Dialect::kCore330);
  const std::string start =
      std::string(exact ? "invariant " : "") + (key.flat ? "flat " : "") + direction;
  w.line(start + " vec4 front_color;");
  if (key.two_side) w.line(start + " vec4 back_color;");
  if (has_secondary(key)) w.line(start + " vec3 front_secondary;");
  if (key.pixels != PixelSource::kNone) w.line(direction + " vec2 texel;");
  if (is_zoomed(key.pixels)) w.line("flat " + direction + " vec4 place;");
  if (has_secondary(key) && key.two_side) w.line(start + " vec3 back_secondary;");
}

}  // namespace

void emit_varyings(Writer& w, const ProgramKey& key, Dialect dialect,
                   const std::string& direction) {
  if (key.per_fragment) emit_per_fragment_varyings(w, key, direction);
  else emit_color_varyings(w, key, dialect, direction);
  if (key.point_fade) w.line(direction + " float point_fade;");
  if (key.point_distance && key.fragments.coverage == Coverage::kSmoothPoint)
    w.line(direction + " float point_side;");
  if (key.fragments.has_fog()) w.line(direction + " float fog_distance;");
  emit_clip_varyings(w, key.fragments, dialect, direction);
  emit_texture_varyings(w, key.textures, direction);
}

}  // namespace legacy_gl
