// The fragment stage, in the specification's order: the face's colours, texturing (GL 2.1
// spec 3.8), colour sum (3.9), fog (3.10), coverage (3.12), alpha test (4.1.4).
#include "shadergen/emit_texture.hpp"

namespace legacy_gl {

namespace {

/// Chooses the colours of the face that is drawn.
FragmentColors emit_face(Writer& w, const ProgramKey& key) {
  if (key.two_side && key.back_only) return {"back_color", "back_secondary"};
  // Points face front (GL 2.1 spec 2.14.1); softpipe's gl_FrontFacing has them face back.
  if (!key.two_side || key.points) return {"front_color", "front_secondary"};
  w.line("vec4 color = gl_FrontFacing ? front_color : back_color;");
  if (has_secondary(key))
    w.line("vec3 secondary = gl_FrontFacing ? front_secondary : back_secondary;");
  return {"color", "secondary", true};
}

/// The pixel of a pixel rectangle that the fragment belongs to (GL 2.1 spec 3.6.4, 3.7).
void emit_pixel(Writer& w, const ProgramKey& key, FragmentColors& colors) {
  if (is_zoomed(key.pixels)) {
    // A pixel of the image belongs to the fragments whose centres are in its rectangle, or on the
    // left or bottom edge of it. `place` has the image's corner and the zoom.
    w.line("vec2 at = (gl_FragCoord.xy - place.xy) / place.zw;");
    w.line("vec2 pixel = mix(ceil(at) - 1.0, floor(at), greaterThan(place.zw, vec2(0.0)));");
  }
  const std::string pixel_value = "texelFetch(pixel_texture, ivec2(" +
                                  std::string(is_zoomed(key.pixels) ? "pixel" : "texel") + "), 0)";
  switch (key.pixels) {
    case PixelSource::kNone: break;
    case PixelSource::kBitmap: w.line("if (" + pixel_value + ".r == 0.0) discard;"); break;
    case PixelSource::kColors: colors.primary = pixel_value; break;
    case PixelSource::kDepths: w.line("gl_FragDepth = " + pixel_value + ".r;"); break;
    case PixelSource::kStencil:  // texel: the bit's value, or 0 for all fragments
      w.line("float index = floor(" + pixel_value + ".r * 255.0 + 0.5);");
      w.line("float value = floor(texel.x + 0.5);");
      w.line("if (value > 0.0 && mod(floor(index / value), 2.0) == 0.0) discard;");
      break;
  }
}

/// GL 2.1 spec 3.9; a fixed-point framebuffer clamps.
void emit_color_sum(Writer&, const ProgramKey& key, FragmentColors& colors) {
  if (!has_secondary(key)) return;
  colors.primary =
      "vec4(" + colors.primary + ".rgb + " + colors.secondary + ", " + colors.primary + ".a)";
}

/// GL 2.1 spec 3.3, 3.12.
void emit_point_fade(Writer& w, const ProgramKey& key, FragmentColors& colors) {
  if (!key.point_fade) return;
  colors.make_variable(w);
  w.line("color.a *= point_fade;");
}

}  // namespace

void FragmentColors::make_variable(Writer& w) {
  if (primary == "color") return;
  w.line((declared ? "color = " : "vec4 color = ") + primary + ";");
  declared = true;
  primary = "color";
}

std::string emit_fragment(const ProgramKey& key, Dialect dialect) {
  Writer w;
  emit_header(w, key, dialect, "fragment");
  emit_fog_block(w, key.fragments);
  emit_coverage_block(w, key);
  if (key.per_fragment) emit_per_fragment_blocks(w, key);
  if (fragment_reads_texture_block(key.textures)) emit_texture_block(w, key.textures);
  emit_varyings(w, key, dialect, "in");
  emit_samplers(w, key.textures, dialect);
  w.blank();
  if (key.per_fragment) emit_lighting_functions(w, key);
  if (key.pixels != PixelSource::kNone)
    w.line(std::string("uniform ") + (dialect == Dialect::kEs300 ? "highp " : "") +
           "sampler2D pixel_texture;");
  w.line("layout(location = 0) out vec4 fragment_color;");
  w.blank();
  w.open("void main() {");
  emit_clip_discard(w, key.fragments, dialect);
  if (key.per_fragment) emit_per_fragment_colors(w, key);
  FragmentColors colors = emit_face(w, key);
  emit_pixel(w, key, colors);
  emit_textures(w, key.textures, colors);
  emit_color_sum(w, key, colors);
  emit_fog(w, key.fragments, colors);
  emit_point_fade(w, key, colors);
  emit_coverage(w, key, colors);
  emit_alpha_test(w, key.fragments, colors);
  w.line("fragment_color = " + colors.primary + ";");
  w.close();
  return w.text();
}

}  // namespace legacy_gl
