#include "shadergen/emit_texture.hpp"

namespace legacy_gl {

namespace {

std::string texel_of(unsigned unit) { return "texel" + std::to_string(unit); }

const char* sampler_type(const TextureStageKey& stage) {
  switch (stage.kind) {
    case TextureKind::k3D: return "sampler3D";
    case TextureKind::kCube: return "samplerCube";
    default: return stage.shadow ? "sampler2DShadow" : "sampler2D";
  }
}

unsigned dimensions(const TextureStageKey& stage) {
  return stage.kind == TextureKind::k3D || stage.kind == TextureKind::kCube ? 3 : 2;
}

/// GL_CLAMP is gone from the core profile: the coordinate is clamped here, and the border's colour
/// is the driver's (GL 2.1 spec table 3.19).
std::string clamped(const TextureStageKey& stage, const std::string& coordinate) {
  const unsigned size = dimensions(stage);
  std::string text;
  for (unsigned i = 0; i < size; ++i) {
    const std::string part = coordinate + "." + "xyz"[i];
    text += (i ? ", " : "") + (stage.clamp & 1u << i ? "clamp(" + part + ", 0.0, 1.0)" : part);
  }
  return "vec" + std::to_string(size) + "(" + text + ")";
}

void emit_sample(Writer& w, const TextureStageKey& stage, unsigned unit) {
  const std::string i = std::to_string(unit);
  const std::string bias_value = "units[" + i + "].parameters.x";
  const std::string bias = stage.lod_bias ? ", " + bias_value : "";
  const std::string result =
      stage.shadow ? "vec4 " + texel_of(unit) + " = vec4(" : "vec4 " + texel_of(unit) + " = ";
  const std::string end = stage.shadow ? ");" : ";";
  if (!stage.clamp) {
    w.line(result +
           (stage.projective && stage.kind != TextureKind::kCube ? "textureProj" : "texture") +
           "(texture" + i + ", coordinate" + i +
           (stage.projective && stage.kind == TextureKind::kCube ? ".xyz" : "") + bias + ")" + end);
    return;
  }
  const unsigned size = dimensions(stage);
  const std::string vec = "vec" + std::to_string(size);
  const std::string swizzle = size == 2 ? ".xy" : ".xyz";
  const std::string q = "coordinate" + i + (size + stage.shadow == 2 ? ".z" : ".w");
  const std::string at = "at" + i;
  w.line(vec + " " + at + " = coordinate" + i + swizzle + (stage.projective ? " / " + q : "") +
         ";");
  std::string where = clamped(stage, at);
  if (stage.shadow)
    where = "vec3(" + where + ", coordinate" + i + ".z" + (stage.projective ? " / " + q : "") + ")";
  if (!stage.mipmap) {
    w.line(result + "texture(texture" + i + ", " + where + bias + ")" + end);
    return;
  }
  const std::string scale = stage.lod_bias ? " * exp2(" + bias_value + ")" : "";
  w.line(result + "textureGrad(texture" + i + ", " + where + ", dFdx(" + at + ")" + scale +
         ", dFdy(" + at + ")" + scale + ")" + end);
}

std::string rgb_of(TextureBase base, const std::string& texel) {
  switch (base) {
    case TextureBase::kAlpha: return "vec3(0.0)";
    case TextureBase::kLuminance:
    case TextureBase::kLuminanceAlpha:
    case TextureBase::kIntensity: return texel + ".rrr";
    case TextureBase::kRgb:
    case TextureBase::kRgba: return texel + ".rgb";
  }
  return texel;
}

/// "" where the base format has no alpha.
std::string alpha_of(TextureBase base, const std::string& texel) {
  switch (base) {
    case TextureBase::kAlpha:
    case TextureBase::kIntensity: return texel + ".r";
    case TextureBase::kLuminanceAlpha: return texel + ".g";
    case TextureBase::kRgba: return texel + ".a";
    case TextureBase::kLuminance:
    case TextureBase::kRgb: return "";
  }
  return "";
}

/// GL 2.1 spec tables 3.22, 3.23.
void emit_environment(Writer& w, const TextureStageKey& stage, unsigned unit) {
  const std::string texel = texel_of(unit);
  const std::string environment = "units[" + std::to_string(unit) + "].color";
  const std::string rgb = rgb_of(stage.base, texel), alpha = alpha_of(stage.base, texel);
  const bool colors = stage.base != TextureBase::kAlpha;
  const bool intensity = stage.base == TextureBase::kIntensity;
  switch (stage.mode) {
    case TextureMode::kReplace:
      if (colors) w.line("color.rgb = " + rgb + ";");
      if (!alpha.empty()) w.line("color.a = " + alpha + ";");
      break;
    case TextureMode::kModulate:
      if (colors) w.line("color.rgb *= " + rgb + ";");
      if (!alpha.empty()) w.line("color.a *= " + alpha + ";");
      break;
    case TextureMode::kDecal:  // undefined but for RGB and RGBA: the colour passes unchanged
      if (stage.base == TextureBase::kRgb) w.line("color.rgb = " + rgb + ";");
      if (stage.base == TextureBase::kRgba)
        w.line("color.rgb = mix(color.rgb, " + rgb + ", " + alpha + ");");
      break;
    case TextureMode::kBlend:
      if (colors) w.line("color.rgb = mix(color.rgb, " + environment + ".rgb, " + rgb + ");");
      if (intensity) w.line("color.a = mix(color.a, " + environment + ".a, " + alpha + ");");
      else if (!alpha.empty()) w.line("color.a *= " + alpha + ";");
      break;
    case TextureMode::kAdd:
      if (colors) w.line("color.rgb = min(color.rgb + " + rgb + ", 1.0);");
      if (intensity) w.line("color.a = min(color.a + " + alpha + ", 1.0);");
      else if (!alpha.empty()) w.line("color.a *= " + alpha + ";");
      break;
    case TextureMode::kCombine: break;
  }
}

std::string combine_source(const TextureKey& key, std::uint8_t source, unsigned unit) {
  switch (static_cast<CombineSource>(source)) {
    case CombineSource::kConstant: return "units[" + std::to_string(unit) + "].color";
    case CombineSource::kPrimaryColor: return "primary_color";
    case CombineSource::kPrevious: return "color";
    default: break;
  }
  const unsigned other = source - static_cast<unsigned>(CombineSource::kTexture0);
  if (other >= key.count || key.stages[other].kind == TextureKind::kNone) return "vec4(0.0)";
  const TextureBase base = key.stages[other].base;
  std::string texel = texel_of(other);
  switch (base) {
    case TextureBase::kAlpha: return "vec4(vec3(0.0), " + texel + ".r)";
    case TextureBase::kLuminance: return "vec4(" + texel + ".rrr, 1.0)";
    case TextureBase::kLuminanceAlpha: return texel + ".rrrg";
    case TextureBase::kIntensity: return texel + ".rrrr";
    case TextureBase::kRgb: return "vec4(" + texel + ".rgb, 1.0)";
    case TextureBase::kRgba: return texel;
  }
  return texel;
}

std::string combine_argument(const TextureKey& key, const CombineKey& combine, unsigned unit,
                             unsigned argument, bool alpha) {
  std::string source = combine_source(key, combine.sources[argument], unit);
  switch (combine.operands[argument]) {
    case CombineOperand::kColor: return source + ".rgb";
    case CombineOperand::kOneMinusColor: return "(1.0 - " + source + ".rgb)";
    case CombineOperand::kAlpha: return source + (alpha ? ".a" : ".aaa");
    case CombineOperand::kOneMinusAlpha: return "(1.0 - " + source + (alpha ? ".a)" : ".aaa)");
  }
  return source;
}

std::string scaled(const std::string& text, std::uint8_t scale) {
  return "clamp(" + (scale > 1 ? std::to_string(scale) + ".0 * (" + text + ")" : text) +
         ", 0.0, 1.0)";
}

/// GL 2.1 spec tables 3.24, 3.25.
std::string unscaled(const TextureKey& key, const CombineKey& combine, unsigned unit, bool alpha) {
  const auto argument = [&](unsigned i) { return combine_argument(key, combine, unit, i, alpha); };
  std::string text;
  switch (combine.function) {
    case CombineFunction::kReplace: text = argument(0); break;
    case CombineFunction::kModulate: text = argument(0) + " * " + argument(1); break;
    case CombineFunction::kAdd: text = argument(0) + " + " + argument(1); break;
    case CombineFunction::kAddSigned: text = argument(0) + " + " + argument(1) + " - 0.5"; break;
    case CombineFunction::kInterpolate:
      text = "mix(" + argument(1) + ", " + argument(0) + ", " + argument(2) + ")";
      break;
    case CombineFunction::kSubtract: text = argument(0) + " - " + argument(1); break;
    case CombineFunction::kDot3Rgb:
    case CombineFunction::kDot3Rgba:
      text = "4.0 * dot(" + argument(0) + " - 0.5, " + argument(1) + " - 0.5)";
      break;
  }
  return text;
}

std::string combined(const TextureKey& key, const CombineKey& combine, unsigned unit, bool alpha) {
  return scaled(unscaled(key, combine, unit, alpha), combine.scale);
}

void emit_combine(Writer& w, const TextureKey& key, unsigned unit) {
  const TextureStageKey& stage = key.stages[unit];
  if (stage.rgb.function == CombineFunction::kDot3Rgba && stage.rgb.scale != stage.alpha.scale) {
    // One product, of which each half has its own scale.
    const std::string value = "dot" + std::to_string(unit);
    w.line("float " + value + " = " + unscaled(key, stage.rgb, unit, false) + ";");
    w.line("color = vec4(vec3(" + scaled(value, stage.rgb.scale) + "), " +
           scaled(value, stage.alpha.scale) + ");");
    return;
  }
  const bool dot = stage.rgb.function == CombineFunction::kDot3Rgb ||
                   stage.rgb.function == CombineFunction::kDot3Rgba;
  const std::string rgb = combined(key, stage.rgb, unit, false);
  if (stage.rgb.function == CombineFunction::kDot3Rgba) {
    w.line("color = vec4(" + rgb + ");");
    return;
  }
  const std::string alpha = combined(key, stage.alpha, unit, true);
  w.line("color = vec4(" + (dot ? "vec3(" + rgb + ")" : rgb) + ", " + alpha + ");");
}

bool reads_source(const TextureKey& key, CombineSource source) {
  for (unsigned i = 0; i < key.count; ++i) {
    const TextureStageKey& stage = key.stages[i];
    if (stage.kind == TextureKind::kNone || stage.mode != TextureMode::kCombine) continue;
    const auto reads = [source](const CombineKey& half) {
      const auto end = half.sources.begin() + argument_count(half.function);
      return std::count(half.sources.begin(), end, static_cast<std::uint8_t>(source)) != 0;
    };
    if (reads(stage.rgb)) return true;
    if (stage.rgb.function != CombineFunction::kDot3Rgba && reads(stage.alpha)) return true;
  }
  return false;
}

}  // namespace

bool fragment_reads_texture_block(const TextureKey& key) {
  for (unsigned i = 0; i < key.count; ++i) {
    const TextureStageKey& stage = key.stages[i];
    if (stage.kind == TextureKind::kNone) continue;
    if (stage.lod_bias || stage.mode == TextureMode::kBlend) return true;
  }
  return reads_source(key, CombineSource::kConstant);
}

void emit_samplers(Writer& w, const TextureKey& key, Dialect dialect) {
  const std::string precision = dialect == Dialect::kEs300 ? "highp " : "";
  for (unsigned i = 0; i < key.count; ++i)
    if (key.stages[i].kind != TextureKind::kNone)
      w.line("uniform " + precision + sampler_type(key.stages[i]) + " texture" + std::to_string(i) +
             ";");
}

void emit_textures(Writer& w, const TextureKey& key, FragmentColors& colors) {
  if (!key.count) return;
  colors.make_variable(w);
  if (reads_source(key, CombineSource::kPrimaryColor)) w.line("vec4 primary_color = color;");
  for (unsigned i = 0; i < key.count; ++i)
    if (key.stages[i].kind != TextureKind::kNone) emit_sample(w, key.stages[i], i);
  for (unsigned i = 0; i < key.count; ++i) {
    if (key.stages[i].kind == TextureKind::kNone) continue;
    if (key.stages[i].mode == TextureMode::kCombine) emit_combine(w, key, i);
    else emit_environment(w, key.stages[i], i);
  }
}

}  // namespace legacy_gl
