// Texture units (GL 2.1 spec 2.11.4, 3.8): what of them chooses code, and the values of their
// block.
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include "shadergen/attributes.hpp"
#include "translate/draw_inputs.hpp"

namespace legacy_gl {

namespace {

TextureKind kind_of(TextureTarget target) {
  switch (target) {
    case kTexture1D: return TextureKind::k1D;
    case kTexture2D: return TextureKind::k2D;
    case kTexture3D: return TextureKind::k3D;
    case kTextureCube: return TextureKind::kCube;
  }
  return TextureKind::kNone;
}

/// GL 2.1 spec 3.8.14: what comparison or a depth texture gives is luminance, intensity or alpha.
TextureBase depth_base(GLenum mode) {
  if (mode == GL_INTENSITY) return TextureBase::kIntensity;
  return mode == GL_ALPHA ? TextureBase::kAlpha : TextureBase::kLuminance;
}

TextureBase base_of(const TextureObject& texture) {
  switch (texture.base()) {
    case BaseFormat::kAlpha: return TextureBase::kAlpha;
    case BaseFormat::kLuminance: return TextureBase::kLuminance;
    case BaseFormat::kLuminanceAlpha: return TextureBase::kLuminanceAlpha;
    case BaseFormat::kIntensity: return TextureBase::kIntensity;
    case BaseFormat::kRed:
    case BaseFormat::kRg:
    case BaseFormat::kRgb: return TextureBase::kRgb;
    case BaseFormat::kRgba: return TextureBase::kRgba;
    case BaseFormat::kDepth: return depth_base(texture.parameters.depth_mode);
  }
  return TextureBase::kRgba;
}

TextureMode mode_of(GLenum mode) {
  switch (mode) {
    case GL_REPLACE: return TextureMode::kReplace;
    case GL_DECAL: return TextureMode::kDecal;
    case GL_BLEND: return TextureMode::kBlend;
    case GL_ADD: return TextureMode::kAdd;
    case GL_COMBINE: return TextureMode::kCombine;
    default: return TextureMode::kModulate;
  }
}

CombineFunction function_of(GLenum function) {
  switch (function) {
    case GL_MODULATE: return CombineFunction::kModulate;
    case GL_ADD: return CombineFunction::kAdd;
    case GL_ADD_SIGNED: return CombineFunction::kAddSigned;
    case GL_INTERPOLATE: return CombineFunction::kInterpolate;
    case GL_SUBTRACT: return CombineFunction::kSubtract;
    case GL_DOT3_RGB: return CombineFunction::kDot3Rgb;
    case GL_DOT3_RGBA: return CombineFunction::kDot3Rgba;
    default: return CombineFunction::kReplace;
  }
}

std::uint8_t source_of(GLenum source, unsigned unit) {
  constexpr auto kTexture0 = static_cast<unsigned>(CombineSource::kTexture0);
  switch (source) {
    case GL_TEXTURE: return static_cast<std::uint8_t>(kTexture0 + unit);
    case GL_CONSTANT: return static_cast<std::uint8_t>(CombineSource::kConstant);
    case GL_PRIMARY_COLOR: return static_cast<std::uint8_t>(CombineSource::kPrimaryColor);
    case GL_PREVIOUS: return static_cast<std::uint8_t>(CombineSource::kPrevious);
    default: return static_cast<std::uint8_t>(kTexture0 + (source - GL_TEXTURE0));
  }
}

CombineOperand operand_of(GLenum operand) {
  switch (operand) {
    case GL_SRC_COLOR: return CombineOperand::kColor;
    case GL_ONE_MINUS_SRC_COLOR: return CombineOperand::kOneMinusColor;
    case GL_SRC_ALPHA: return CombineOperand::kAlpha;
    default: return CombineOperand::kOneMinusAlpha;
  }
}

CombineKey combine_key(const CombineState& state, unsigned unit) {
  CombineKey key;
  key.function = function_of(state.function);
  key.scale = static_cast<std::uint8_t>(state.scale);
  for (unsigned i = 0; i < argument_count(key.function); ++i) {
    key.sources[i] = source_of(state.sources[i], unit);
    key.operands[i] = operand_of(state.operands[i]);
  }
  return key;
}

CoordinateSource source_of(const TexgenCoordinate& coordinate) {
  if (!coordinate.enabled) return CoordinateSource::kVertex;
  switch (coordinate.mode) {
    case GL_SPHERE_MAP: return CoordinateSource::kSphere;
    case GL_REFLECTION_MAP: return CoordinateSource::kReflection;
    case GL_NORMAL_MAP: return CoordinateSource::kNormal;
    default: return CoordinateSource::kLinear;
  }
}

/// With linear filtering GL_CLAMP reaches half into the border (GL 2.1 spec table 3.19), and the
/// coordinate is clamped to [0, 1] before; GL_CLAMP of the nearest texel is clamping to the edge.
std::uint8_t clamp_bits(const TextureObject& texture) {
  const TextureParameters& parameters = texture.parameters;
  if (!filters_linearly(parameters)) return 0;
  const unsigned dimensions = texture.target == kTexture1D   ? 1
                              : texture.target == kTexture2D ? 2
                                                             : 3;
  if (texture.target == kTextureCube) return 0;
  unsigned bits = 0;
  for (unsigned i = 0; i < dimensions; ++i)
    if (parameters.wrap[i] == GL_CLAMP) bits |= 1u << i;
  return static_cast<std::uint8_t>(bits);
}

float lod_bias(const TextureUnit& unit, const TextureObject& texture) {
  return unit.environment.lod_bias + texture.parameters.lod_bias;
}

bool is_identity(const glm::mat4& matrix) { return matrix == glm::mat4(1.0f); }
bool keeps_q(const glm::mat4& matrix) { return glm::row(matrix, 3) == glm::vec4(0, 0, 0, 1); }

TextureStageKey stage_key(const Context& context, const TextureObject& texture, unsigned index,
                          bool wide) {
  const TextureUnit& unit = context.texture.units[index];
  TextureStageKey key;
  key.kind = kind_of(texture.target);
  key.base = base_of(texture);
  key.mode = mode_of(unit.environment.mode);
  if (key.mode == TextureMode::kCombine) {
    key.rgb = combine_key(unit.environment.rgb, index);
    key.alpha = combine_key(unit.environment.alpha, index);
    if (key.rgb.function == CombineFunction::kDot3Rgba)  // alpha is the product too
      key.alpha = {.scale = key.alpha.scale};
  }
  bool wide_from_vertex = false;
  for (unsigned i = 0; i < 4; ++i) {
    key.sources[i] = source_of(unit.texgen.coordinates[i]);
    if (i == 3) wide_from_vertex = wide && key.sources[3] == CoordinateSource::kVertex;
  }
  const glm::mat4& matrix = context.transform.texture[index].top().single;
  key.matrix = !is_identity(matrix);
  key.projective = wide_from_vertex || key.sources[3] != CoordinateSource::kVertex ||
                   (key.matrix && !keeps_q(matrix));
  if (texture.target == kTextureCube) key.projective = false;  // a direction has no length
  key.lod_bias = lod_bias(unit, texture) != 0;
  key.shadow = texture.base() == BaseFormat::kDepth && texture.target <= kTexture2D &&
               texture.parameters.compare_mode == GL_COMPARE_R_TO_TEXTURE;
  key.clamp = clamp_bits(texture);
  key.mipmap = key.clamp && uses_mipmaps(texture.parameters.min_filter);
  return key;
}

}  // namespace

void DrawInputs::update_textures(Context& context, std::uint32_t dirty, bool layout_changed) {
  const bool transformed =
      dirty & kDirtyTransform && (key.textures.reads_normal() || key.textures.reads_planes());
  const bool changed = dirty & (kDirtyTexture | kDirtyKey) || layout_changed;
  if (!transformed && !changed) return;
  const TextureKey before = key.textures;
  choose_textures(context);
  if (key.textures.count && (transformed || dirty & kDirtyTexture || !(before == key.textures)))
    fill_textures(context);
}

void DrawInputs::choose_textures(Context& context) {
  key.textures = {};
  const ActiveTextures& active = active_textures(context.texture);
  if (!active.mask) return;
  for (unsigned i = 0; i < active.count; ++i) {
    if (!active.textures[i]) continue;
    TextureStageKey stage =
        stage_key(context, *active.textures[i], i, layout_.wide_texcoords & 1u << i);
    if (stage.reads_vertex() && !has_texcoord_location(layout_.materials, i)) {
      diagnose(context, "more texture units and per-vertex materials than a driver has attributes");
      continue;
    }
    key.textures.stages[i] = stage;
    key.textures.count = static_cast<std::uint8_t>(i + 1);
  }
  key.textures.normalize = key.textures.reads_normal() && context.transform.normalize_enabled;
}

void DrawInputs::fill_textures(Context& context) {
  stale[kTexturesBlock] = true;
  const Matrix& modelview = context.transform.modelview.top();
  if (key.textures.reads_normal()) {
    textures.modelview = glm::mat4(modelview.exact);
    glm::dmat3 normal_matrix = linear_.inverse_transpose;
    if (key.textures.normalize) normal_matrix = linear_.cofactor * linear_.determinant_sign;
    else if (context.transform.rescale_normal_enabled) normal_matrix *= linear_.rescale_factor;
    for (int column = 0; column < 3; ++column)
      textures.normal_matrix[static_cast<unsigned>(column)] =
          glm::vec4(glm::vec3(normal_matrix[column]), 0);
  }
  texture_units.resize(key.textures.count);
  const glm::dmat4 to_object = glm::transpose(modelview.exact);
  for (unsigned i = 0; i < key.textures.count; ++i) {
    const TextureStageKey& stage = key.textures.stages[i];
    TextureUnitUniforms& values = texture_units[i] = {};
    if (stage.kind == TextureKind::kNone) continue;
    const TextureUnit& unit = context.texture.units[i];
    values.color = glm::clamp(unit.environment.color, 0.0f, 1.0f);
    values.parameters.x = lod_bias(unit, *context.texture.active.textures[i]);
    if (stage.matrix) values.matrix = context.transform.texture[i].top().single;
    for (unsigned c = 0; c < 4; ++c) {
      const TexgenCoordinate& coordinate = unit.texgen.coordinates[c];
      if (stage.sources[c] != CoordinateSource::kLinear) continue;
      // p . (M v) is (Mt p) . v: the plane goes to the object, so that no vertex has to come.
      values.planes[c] = coordinate.mode == GL_OBJECT_LINEAR
                             ? coordinate.object_plane
                             : glm::vec4(to_object * coordinate.eye_plane);
    }
  }
}

}  // namespace legacy_gl
