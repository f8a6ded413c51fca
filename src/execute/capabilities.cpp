#include "execute/capabilities.hpp"

#include <cstdio>
#include <utility>

#include "driver/driver_objects.hpp"
#include "execute/lighting_setters.hpp"
#include "record/pending.hpp"

namespace legacy_gl {

namespace {

/// The capabilities that are one flag of the raster state.
bool* raster_flag(RasterState& raster, GLenum capability) {
  switch (capability) {
    case GL_DEPTH_TEST: return &raster.depth.test_enabled;
    case GL_STENCIL_TEST: return &raster.stencil.test_enabled;
    case GL_BLEND: return &raster.color_buffer.blend_enabled;
    case GL_COLOR_LOGIC_OP: return &raster.color_buffer.logic_op_enabled;
    case GL_INDEX_LOGIC_OP: return &raster.color_buffer.index_logic_op_enabled;
    case GL_DITHER: return &raster.color_buffer.dither_enabled;
    case GL_CULL_FACE: return &raster.polygon.cull_enabled;
    case GL_POLYGON_OFFSET_FILL: return &raster.polygon.offset_fill_enabled;
    case GL_POLYGON_OFFSET_LINE: return &raster.polygon.offset_line_enabled;
    case GL_POLYGON_OFFSET_POINT: return &raster.polygon.offset_point_enabled;
    case GL_POLYGON_SMOOTH: return &raster.polygon.smooth_enabled;
    case GL_POLYGON_STIPPLE: return &raster.polygon.stipple_enabled;
    case GL_POINT_SMOOTH: return &raster.point.smooth_enabled;
    case GL_LINE_STIPPLE: return &raster.line.stipple_enabled;
    case GL_LINE_SMOOTH: return &raster.line.smooth_enabled;
    case GL_SCISSOR_TEST: return &raster.scissor.test_enabled;
    case GL_MULTISAMPLE: return &raster.multisample.enabled;
    case GL_SAMPLE_ALPHA_TO_COVERAGE: return &raster.multisample.alpha_to_coverage;
    case GL_SAMPLE_ALPHA_TO_ONE: return &raster.multisample.alpha_to_one;
    case GL_SAMPLE_COVERAGE: return &raster.multisample.coverage;
    default: return nullptr;
  }
}

/// The set that holds an evaluator's map, and its bit there; nullptr for what is no map.
template <typename Modes>  // const or not
auto map_flag(Modes& modes, GLenum capability) -> std::pair<decltype(&modes.enabled[0]), unsigned> {
  const GLenum curve = capability - GL_MAP1_COLOR_4, surface = capability - GL_MAP2_COLOR_4;
  if (curve < kMapCount) return {&modes.enabled[0], 1u << curve};
  if (surface < kMapCount) return {&modes.enabled[1], 1u << surface};
  return {nullptr, 0};
}

/// The flag of the active texture unit; nullptr for what is none of a unit's.
template <typename Unit>  // const or not
auto texture_flag(Unit& unit, GLenum capability) -> decltype(&unit.enabled[0]) {
  switch (capability) {
    case GL_TEXTURE_1D: return &unit.enabled[kTexture1D];
    case GL_TEXTURE_2D: return &unit.enabled[kTexture2D];
    case GL_TEXTURE_3D: return &unit.enabled[kTexture3D];
    case GL_TEXTURE_CUBE_MAP: return &unit.enabled[kTextureCube];
    default: break;
  }
  const GLenum coordinate = capability - GL_TEXTURE_GEN_S;
  return coordinate < 4 ? &unit.texgen.coordinates[coordinate].enabled : nullptr;
}

constexpr GLenum kTextureEnables[] = {GL_TEXTURE_1D,       GL_TEXTURE_2D,    GL_TEXTURE_3D,
                                      GL_TEXTURE_CUBE_MAP, GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T,
                                      GL_TEXTURE_GEN_R,    GL_TEXTURE_GEN_Q};

void enable_texture(Context& context, bool& flag, bool enabled) {
  if (flag == enabled) return;
  before_texture_change(context);
  flag = enabled;
}

/// Those of GL_ENABLE_BIT (GL 2.1 spec table 6.6 to 6.33); client arrays are not among them.
constexpr GLenum kEnableGroup[] = {GL_ALPHA_TEST,
                                   GL_AUTO_NORMAL,
                                   GL_BLEND,
                                   GL_MAP1_COLOR_4,
                                   GL_MAP1_INDEX,
                                   GL_MAP1_NORMAL,
                                   GL_MAP1_TEXTURE_COORD_1,
                                   GL_MAP1_TEXTURE_COORD_2,
                                   GL_MAP1_TEXTURE_COORD_3,
                                   GL_MAP1_TEXTURE_COORD_4,
                                   GL_MAP1_VERTEX_3,
                                   GL_MAP1_VERTEX_4,
                                   GL_MAP2_COLOR_4,
                                   GL_MAP2_INDEX,
                                   GL_MAP2_NORMAL,
                                   GL_MAP2_TEXTURE_COORD_1,
                                   GL_MAP2_TEXTURE_COORD_2,
                                   GL_MAP2_TEXTURE_COORD_3,
                                   GL_MAP2_TEXTURE_COORD_4,
                                   GL_MAP2_VERTEX_3,
                                   GL_MAP2_VERTEX_4,
                                   GL_CLIP_PLANE0,
                                   GL_CLIP_PLANE1,
                                   GL_CLIP_PLANE2,
                                   GL_CLIP_PLANE3,
                                   GL_CLIP_PLANE4,
                                   GL_CLIP_PLANE5,
                                   GL_COLOR_LOGIC_OP,
                                   GL_COLOR_MATERIAL,
                                   GL_COLOR_SUM,
                                   GL_CULL_FACE,
                                   GL_DEPTH_TEST,
                                   GL_DITHER,
                                   GL_FOG,
                                   GL_INDEX_LOGIC_OP,
                                   GL_LIGHTING,
                                   GL_LINE_SMOOTH,
                                   GL_LINE_STIPPLE,
                                   GL_MULTISAMPLE,
                                   GL_NORMALIZE,
                                   GL_POINT_SMOOTH,
                                   GL_POLYGON_OFFSET_FILL,
                                   GL_POLYGON_OFFSET_LINE,
                                   GL_POLYGON_SMOOTH,
                                   GL_POLYGON_OFFSET_POINT,
                                   GL_POLYGON_STIPPLE,
                                   GL_RESCALE_NORMAL,
                                   GL_SAMPLE_COVERAGE,
                                   GL_SAMPLE_ALPHA_TO_COVERAGE,
                                   GL_SAMPLE_ALPHA_TO_ONE,
                                   GL_SCISSOR_TEST,
                                   GL_STENCIL_TEST};

}  // namespace

void save_enables(const Context& context, std::vector<std::uint8_t>& enables) {
  enables.clear();
  bool known = false;
  for (const GLenum capability : kEnableGroup)
    enables.push_back(capability_enabled(context, capability, known));
  for (const Light& light : context.lighting.lights) enables.push_back(light.enabled);
  for (const TextureUnit& unit : context.texture.units)
    for (const GLenum capability : kTextureEnables)
      enables.push_back(*texture_flag(unit, capability));
}

void restore_enables(Context& context, const std::vector<std::uint8_t>& enables) {
  std::size_t at = 0;
  for (const GLenum capability : kEnableGroup)
    set_capability(context, capability, enables[at++] != 0);
  for (unsigned light = 0; light < context.lighting.lights.size(); ++light)
    enable_light(context, light, enables[at++] != 0);
  for (TextureUnit& unit : context.texture.units)
    for (const GLenum capability : kTextureEnables)
      enable_texture(context, *texture_flag(unit, capability), enables[at++] != 0);
}

namespace {

/// OpenGL ES has neither these nor anything that could stand for them.
bool is_missing_in_es(GLenum capability) {
  switch (capability) {
    case GL_COLOR_LOGIC_OP:
    case GL_LINE_SMOOTH:
    case GL_POLYGON_OFFSET_LINE:
    case GL_POLYGON_OFFSET_POINT:
    case GL_POLYGON_SMOOTH: return true;
    default: return false;
  }
}

std::string in_words(const char* format, GLenum capability) {
  char text[96];
  std::snprintf(text, sizeof text, format, capability);
  return text;
}

}  // namespace

bool set_capability(Context& context, GLenum capability, bool enabled) {
  const GLenum light = capability - GL_LIGHT0;
  if (light < context.lighting.lights.size()) {
    enable_light(context, light, enabled);
    return true;
  }
  // EXT_vertex_array's way, before there was glEnableClientState.
  if (const unsigned array = array_index(capability, context.client_active_texture);
      array != kArrayCount) {
    context.arrays.arrays[array].enabled = enabled;
    return true;
  }
  switch (capability) {
    case GL_LIGHTING: enable_lighting(context, enabled); return true;
    case GL_COLOR_MATERIAL: enable_color_material(context, enabled); return true;
    case GL_NORMALIZE:
      assign_lighting(context, context.transform.normalize_enabled, enabled, kDirtyTransform);
      return true;
    case GL_RESCALE_NORMAL:
      assign_lighting(context, context.transform.rescale_normal_enabled, enabled, kDirtyTransform);
      return true;
    case GL_AUTO_NORMAL: context.evaluators.modes.auto_normal = enabled; return true;
    case GL_COLOR_SUM: assign(context, context.color_sum_enabled, enabled, kDirtyKey); return true;
    case GL_FOG:
      assign(context, context.fog.enabled, enabled, kDirtyKey | kDirtyFragments);
      return true;
    case GL_ALPHA_TEST:
      assign(context, context.raster.color_buffer.alpha_test_enabled, enabled,
             kDirtyKey | kDirtyFragments);
      return true;
    default: break;
  }
  if (const GLenum plane = capability - GL_CLIP_PLANE0; plane < kMaxClipPlanes) {
    const std::uint8_t before = context.transform.clip.enabled;
    const auto bit = static_cast<std::uint8_t>(1u << plane);
    assign(context, context.transform.clip.enabled,
           static_cast<std::uint8_t>(enabled ? before | bit : before & ~bit),
           kDirtyKey | kDirtyFragments | kDirtyRaster);
    return true;
  }
  if (bool* const flag = texture_flag(context.texture.units[context.active_texture], capability)) {
    enable_texture(context, *flag, enabled);
    return true;
  }
  if (const auto [enables, bit] = map_flag(context.evaluators.modes, capability); enables) {
    *enables = static_cast<std::uint16_t>(enabled ? *enables | bit : *enables & ~bit);
    return true;
  }
  bool* const flag = raster_flag(context.raster, capability);
  if (!flag) return false;
  if (enabled && is_missing_in_es(capability) && context.driver->functions.is_es())
    diagnose(context, in_words("glEnable(0x%04X) has no effect on OpenGL ES", capability));
  std::uint32_t dirty = kDirtyRaster;
  if (capability == GL_CULL_FACE) dirty |= kDirtyKey;
  if (capability == GL_POLYGON_STIPPLE) dirty |= kDirtyFragments;
  if (capability == GL_POINT_SMOOTH) dirty |= kDirtyTransform;
  assign(context, *flag, enabled, dirty);
  return true;
}

bool capability_enabled(const Context& context, GLenum capability, bool& known) {
  known = true;
  const GLenum light = capability - GL_LIGHT0;
  if (light < context.lighting.lights.size()) return context.lighting.lights[light].enabled;
  const unsigned array = array_index(capability, context.client_active_texture);
  if (array != kArrayCount) return context.arrays.arrays[array].enabled;
  switch (capability) {
    case GL_LIGHTING: return context.lighting.enabled;
    case GL_COLOR_MATERIAL: return context.lighting.color_material.enabled;
    case GL_NORMALIZE: return context.transform.normalize_enabled;
    case GL_RESCALE_NORMAL: return context.transform.rescale_normal_enabled;
    case GL_COLOR_SUM: return context.color_sum_enabled;
    case GL_FOG: return context.fog.enabled;
    case GL_AUTO_NORMAL: return context.evaluators.modes.auto_normal;
    case GL_ALPHA_TEST: return context.raster.color_buffer.alpha_test_enabled;
    default: break;
  }
  if (const GLenum plane = capability - GL_CLIP_PLANE0; plane < kMaxClipPlanes)
    return (context.transform.clip.enabled >> plane & 1) != 0;
  if (const auto [enables, bit] = map_flag(context.evaluators.modes, capability); enables)
    return (*enables & bit) != 0;
  const TextureUnit& unit = context.texture.units[context.active_texture];
  if (const bool* const flag = texture_flag(unit, capability)) return *flag;
  RasterState raster = context.raster;
  const bool* const flag = raster_flag(raster, capability);
  known = flag != nullptr;
  return flag && *flag;
}

}  // namespace legacy_gl
