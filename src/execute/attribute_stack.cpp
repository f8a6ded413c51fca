#include "execute/attribute_stack.hpp"

#include "context/context.hpp"
#include "driver/driver_objects.hpp"
#include "execute/attributes.hpp"
#include "execute/capabilities.hpp"
#include "execute/framebuffer.hpp"
#include "execute/lighting_setters.hpp"
#include "record/pending.hpp"

namespace legacy_gl {

namespace {

/// GL_LIGHTING_BIT brings back lights and materials together. The properties that colour material
/// tracks follow the current colour again when tracking comes back (GL 2.1 spec 2.14.3).
void restore_lighting(Context& context, const LightingState& saved) {
  LightingState& now = context.lighting;
  enable_lighting(context, saved.enabled);
  for (std::size_t i = 0; i < saved.lights.size(); ++i)
    assign(context, now.lights[i], saved.lights[i], kDirtyLights);
  assign(context, now.model, saved.model, kDirtyKey | kDirtyMaterial | kDirtyTransform);
  set_shade_model(context, saved.shade_model);
  assign(context, now.color_material, saved.color_material, kDirtyKey | kDirtyMaterial);
  assign(context, now.materials, saved.materials, kDirtyMaterial);
  latch_color_material(context);
}

void restore_raster(Context& context, GLbitfield mask, const RasterState& saved) {
  RasterState& now = context.raster;
  // Their sizes and modes also choose how primitives are drawn.
  constexpr std::uint32_t kShapes = kDirtyRaster | kDirtyKey | kDirtyTransform;
  if (mask & GL_POINT_BIT) assign(context, now.point, saved.point, kShapes);
  if (mask & GL_LINE_BIT) assign(context, now.line, saved.line, kShapes);
  if (mask & GL_POLYGON_BIT) assign(context, now.polygon, saved.polygon, kShapes);
  if (mask & GL_POLYGON_STIPPLE_BIT)
    assign(context, now.polygon_stipple, saved.polygon_stipple, kDirtyFragments);
  if (mask & GL_VIEWPORT_BIT) assign(context, now.viewport, saved.viewport, kShapes);
  if (mask & GL_DEPTH_BUFFER_BIT) assign(context, now.depth, saved.depth, kDirtyRaster);
  if (mask & GL_STENCIL_BUFFER_BIT) assign(context, now.stencil, saved.stencil, kDirtyRaster);
  if (mask & GL_SCISSOR_BIT) assign(context, now.scissor, saved.scissor, kDirtyRaster);
  if (mask & GL_MULTISAMPLE_BIT) assign(context, now.multisample, saved.multisample, kDirtyRaster);
  if (mask & GL_COLOR_BUFFER_BIT) {
    if (now.color_buffer.draw_buffer != saved.color_buffer.draw_buffer)
      set_draw_buffer(context, saved.color_buffer.draw_buffer);
    assign(context, now.color_buffer, saved.color_buffer,
           kDirtyRaster | kDirtyKey | kDirtyFragments);
  }
}

void save_textures(const Context& context, TextureGroup& saved) {
  saved.active_texture = context.active_texture;
  saved.units = context.texture.units;
  for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
    for (unsigned target = 0; target < kTextureTargetCount; ++target)
      saved.parameters[unit][target] = context.texture.units[unit].bound[target]->parameters;
}

/// A texture that was deleted since the push does not come back.
void restore_textures(Context& context, const TextureGroup& saved) {
  context.active_texture = saved.active_texture;
  if (!(context.texture.units == saved.units)) {
    before_texture_change(context);
    context.texture.units = saved.units;
  }
  for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
    for (unsigned target = 0; target < kTextureTargetCount; ++target) {
      TexturePointer& bound = context.texture.units[unit].bound[target];
      const TextureParameters& parameters = saved.parameters[unit][target];
      const bool deleted = bound->name && context.texture.shared->names.find(bound->name) != bound;
      if (!deleted && bound->parameters == parameters) continue;
      before_texture_change(context);
      if (deleted) {
        bound = context.texture.defaults[target];
        continue;
      }
      bound->parameters = parameters;
      bound->parameters_stale = true;
    }
}

/// As by the calls, since the vertices that are recorded may lack r and q.
void restore_current(Context& context, const CurrentValues& saved) {
  context.current = saved;
  for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit) {
    const glm::vec4& to = saved.texture_coordinates[unit];
    execute::texcoord4(context, unit, to.s, to.t, to.p, to.q);
  }
}

/// A buffer object that was deleted since the push does not come back.
void forget_deleted_buffers(Context& context) {
  const BufferObjects& buffers = context.driver->buffers;
  ClientArrays& arrays = context.arrays;
  const auto is_deleted = [&buffers](const BufferPointer& buffer) {
    return buffer && buffers.find(buffer->name) != buffer;
  };
  if (is_deleted(arrays.array_buffer)) arrays.array_buffer = nullptr;
  if (is_deleted(arrays.element_buffer)) arrays.element_buffer = nullptr;
  for (ClientArray& array : arrays.arrays) {
    if (!is_deleted(array.buffer)) continue;
    array.buffer = nullptr;
    array.buffer_deleted = true;
  }
}

}  // namespace

void save_attributes(Context& context, GLbitfield mask, SavedAttributes& level) {
  level.mask = mask;
  if (mask & GL_CURRENT_BIT) level.current = context.current;
  if (mask & GL_LIGHTING_BIT) {
    latch_color_material(context);
    level.lighting = context.lighting;
  }
  level.transform = {context.transform.matrix_mode, context.transform.normalize_enabled,
                     context.transform.rescale_normal_enabled, context.transform.clip};
  level.raster = context.raster;
  level.fog = context.fog;
  level.accumulation = context.accumulation;
  level.hints = context.hints;
  level.list_base = context.list_modes.base;
  if (mask & GL_TEXTURE_BIT) save_textures(context, level.texture);
  level.color_sum_enabled = context.color_sum_enabled;
  level.read_buffer = context.read_buffer;
  level.pixel_transfer = context.pixels.transfer;
  level.evaluators = context.evaluators.modes;
  if (mask & GL_ENABLE_BIT) save_enables(context, level.enables);
}

void restore_attributes(Context& context, const SavedAttributes& level) {
  const GLbitfield mask = level.mask;
  // The current colour goes first: tracked materials follow it.
  if (mask & GL_CURRENT_BIT) restore_current(context, level.current);
  if (mask & GL_LIGHTING_BIT) restore_lighting(context, level.lighting);
  if (mask & GL_ENABLE_BIT) restore_enables(context, level.enables);
  if (mask & GL_TRANSFORM_BIT) {
    TransformState& now = context.transform;
    now.matrix_mode = level.transform.matrix_mode;
    assign(context, now.normalize_enabled, level.transform.normalize_enabled, kDirtyTransform);
    assign(context, now.rescale_normal_enabled, level.transform.rescale_normal_enabled,
           kDirtyTransform);
    assign(context, now.clip, level.transform.clip, kDirtyKey | kDirtyFragments | kDirtyRaster);
  }
  restore_raster(context, mask, level.raster);
  if (mask & GL_FOG_BIT) {
    assign(context, context.color_sum_enabled, level.color_sum_enabled, kDirtyKey);
    assign(context, context.fog, level.fog, kDirtyKey | kDirtyFragments);
  }
  if (mask & GL_EVAL_BIT) context.evaluators.modes = level.evaluators;
  if (mask & GL_ACCUM_BUFFER_BIT) context.accumulation = level.accumulation;
  if (mask & GL_HINT_BIT) context.hints = level.hints;
  if (mask & GL_LIST_BIT) context.list_modes.base = level.list_base;
  if (mask & GL_TEXTURE_BIT) restore_textures(context, level.texture);
  if (mask & GL_PIXEL_MODE_BIT) {
    context.pixels.transfer = level.pixel_transfer;
    if (context.read_buffer != level.read_buffer) set_read_buffer(context, level.read_buffer);
  }
}

void save_client_attributes(const Context& context, GLbitfield mask, SavedClientAttributes& level) {
  level.mask = mask;
  level.pack = context.pack;
  level.unpack = context.unpack;
  if (mask & GL_CLIENT_VERTEX_ARRAY_BIT) level.arrays = context.arrays;
  level.client_active_texture = context.client_active_texture;
}

void restore_client_attributes(Context& context, const SavedClientAttributes& level) {
  if (level.mask & GL_CLIENT_PIXEL_STORE_BIT) {
    context.pack = level.pack;
    context.unpack = level.unpack;
  }
  if (level.mask & GL_CLIENT_VERTEX_ARRAY_BIT) {
    context.arrays = level.arrays;
    context.client_active_texture = level.client_active_texture;
    forget_deleted_buffers(context);
  }
}

}  // namespace legacy_gl
