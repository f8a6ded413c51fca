// What glGet answers from the context's own state. Tables 6.6 to 6.33 of the GL 2.1 spec, in their
// order.
#include <algorithm>
#include <glm/matrix.hpp>

#include "execute/framebuffer.hpp"
#include "execute/queries.hpp"

namespace legacy_gl {

namespace {

using enum ValueKind;

const MatrixStack& texture_stack(const Context& c) { return c.transform.texture[c.active_texture]; }
template <TextureTarget kTarget>
void binding(Context& c, QueryValues& v) {
  v.put(c.texture.units[c.active_texture].bound[kTarget]->name);
}

GLint as_bits(GLuint mask) { return static_cast<GLint>(mask); }

/// GL 2.1 spec 4.1.5: the reference value is clamped to what the stencil buffer holds.
GLint clamped_stencil_reference(const Context& c) {
  const GLint largest = (1 << framebuffer_bits(c, FramebufferChannel::kStencil)) - 1;
  return std::clamp(c.raster.stencil.reference, 0, largest);
}

double number(std::size_t n) { return static_cast<double>(n); }

constexpr Query kCurrentValues[] = {
    {GL_CURRENT_COLOR, kNormalised, [](Context& c, QueryValues& v) { v.put(c.current.color); }},
    {GL_CURRENT_SECONDARY_COLOR, kNormalised,
     [](Context& c, QueryValues& v) { v.put(c.current.secondary_color); }},
    {GL_CURRENT_INDEX, kFloat, [](Context& c, QueryValues& v) { v.put(c.current.index); }},
    {GL_CURRENT_NORMAL, kNormalised, [](Context& c, QueryValues& v) { v.put(c.current.normal); }},
    {GL_CURRENT_FOG_COORDINATE, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.current.fog_coordinate); }},
    {GL_CURRENT_TEXTURE_COORDS, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.current.texture_coordinates[c.active_texture]); }},
    {GL_EDGE_FLAG, kBoolean, [](Context& c, QueryValues& v) { v.put(c.current.edge_flag); }},
};

constexpr Query kRasterPosition[] = {
    {GL_CURRENT_RASTER_POSITION, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.current.raster.position); }},
    {GL_CURRENT_RASTER_DISTANCE, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.current.raster.distance); }},
    {GL_CURRENT_RASTER_COLOR, kNormalised,
     [](Context& c, QueryValues& v) { v.put(c.current.raster.color); }},
    {GL_CURRENT_RASTER_INDEX, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.current.raster.index); }},
    {GL_CURRENT_RASTER_TEXTURE_COORDS, kFloat,
     [](Context& c, QueryValues& v) {
       v.put(c.current.raster.texture_coordinates[c.active_texture]);
     }},
    {GL_CURRENT_RASTER_POSITION_VALID, kBoolean,
     [](Context& c, QueryValues& v) { v.put(c.current.raster.valid); }},
};

constexpr Query kTransform[] = {
    {GL_MATRIX_MODE, kInteger, [](Context& c, QueryValues& v) { v.put(c.transform.matrix_mode); }},
    {GL_MODELVIEW_MATRIX, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.transform.modelview.top().single); }},
    {GL_PROJECTION_MATRIX, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.transform.projection.top().single); }},
    {GL_TEXTURE_MATRIX, kFloat,
     [](Context& c, QueryValues& v) { v.put(texture_stack(c).top().single); }},
    {GL_TRANSPOSE_MODELVIEW_MATRIX, kFloat,
     [](Context& c, QueryValues& v) { v.put(transpose(c.transform.modelview.top().single)); }},
    {GL_TRANSPOSE_PROJECTION_MATRIX, kFloat,
     [](Context& c, QueryValues& v) { v.put(transpose(c.transform.projection.top().single)); }},
    {GL_TRANSPOSE_TEXTURE_MATRIX, kFloat,
     [](Context& c, QueryValues& v) { v.put(transpose(texture_stack(c).top().single)); }},
    {GL_MODELVIEW_STACK_DEPTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(number(c.transform.modelview.depth())); }},
    {GL_PROJECTION_STACK_DEPTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(number(c.transform.projection.depth())); }},
    {GL_TEXTURE_STACK_DEPTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(number(texture_stack(c).depth())); }},
    {GL_MAX_MODELVIEW_STACK_DEPTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(number(c.transform.modelview.max_depth())); }},
    {GL_MAX_PROJECTION_STACK_DEPTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(number(c.transform.projection.max_depth())); }},
    {GL_MAX_TEXTURE_STACK_DEPTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(number(texture_stack(c).max_depth())); }},
    {GL_ACTIVE_TEXTURE, kInteger,
     [](Context& c, QueryValues& v) { v.put(GL_TEXTURE0 + c.active_texture); }},
    {GL_CLIENT_ACTIVE_TEXTURE, kInteger,
     [](Context& c, QueryValues& v) { v.put(GL_TEXTURE0 + c.client_active_texture); }},
    {GL_TEXTURE_BINDING_1D, kInteger, binding<kTexture1D>},
    {GL_TEXTURE_BINDING_2D, kInteger, binding<kTexture2D>},
    {GL_TEXTURE_BINDING_3D, kInteger, binding<kTexture3D>},
    {GL_TEXTURE_BINDING_CUBE_MAP, kInteger, binding<kTextureCube>},
    {GL_MAX_TEXTURE_UNITS, kInteger, [](Context&, QueryValues& v) { v.put(kMaxTextureUnits); }},
    {GL_VIEWPORT, kInteger, [](Context& c, QueryValues& v) { v.put(c.raster.viewport.box); }},
    {GL_DEPTH_RANGE, kNormalised,
     [](Context& c, QueryValues& v) {
       // In the precision that drivers keep it in, so that all of them answer alike.
       v.put(static_cast<float>(c.raster.viewport.depth_near));
       v.put(static_cast<float>(c.raster.viewport.depth_far));
     }},
};

constexpr Query kLighting[] = {
    {GL_SHADE_MODEL, kInteger, [](Context& c, QueryValues& v) { v.put(c.lighting.shade_model); }},
    {GL_COLOR_MATERIAL_FACE, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.lighting.color_material.face); }},
    {GL_COLOR_MATERIAL_PARAMETER, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.lighting.color_material.mode); }},
    {GL_LIGHT_MODEL_AMBIENT, kNormalised,
     [](Context& c, QueryValues& v) { v.put(c.lighting.model.ambient); }},
    {GL_LIGHT_MODEL_LOCAL_VIEWER, kBoolean,
     [](Context& c, QueryValues& v) { v.put(c.lighting.model.local_viewer); }},
    {GL_LIGHT_MODEL_TWO_SIDE, kBoolean,
     [](Context& c, QueryValues& v) { v.put(c.lighting.model.two_side); }},
    {GL_LIGHT_MODEL_COLOR_CONTROL, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.lighting.model.color_control); }},
    {GL_MAX_LIGHTS, kInteger,
     [](Context& c, QueryValues& v) { v.put(number(c.lighting.lights.size())); }},
};

constexpr Query kRasterization[] = {
    {GL_POINT_SIZE, kFloat, [](Context& c, QueryValues& v) { v.put(c.raster.point.size); }},
    {GL_POINT_SIZE_MIN, kFloat, [](Context& c, QueryValues& v) { v.put(c.raster.point.size_min); }},
    {GL_POINT_SIZE_MAX, kFloat, [](Context& c, QueryValues& v) { v.put(c.raster.point.size_max); }},
    {GL_POINT_FADE_THRESHOLD_SIZE, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.raster.point.fade_threshold); }},
    {GL_POINT_DISTANCE_ATTENUATION, kFloat,
     [](Context& c, QueryValues& v) {
       for (int i = 0; i < 3; ++i) v.put(static_cast<double>(c.raster.point.attenuation[i]));
     }},
    {GL_LINE_WIDTH, kFloat, [](Context& c, QueryValues& v) { v.put(c.raster.line.width); }},
    {GL_LINE_STIPPLE_PATTERN, kInteger,
     [](Context& c, QueryValues& v) { v.put(GLint{c.raster.line.stipple_pattern}); }},
    {GL_LINE_STIPPLE_REPEAT, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.line.stipple_factor); }},
    {GL_CULL_FACE_MODE, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.polygon.cull_face); }},
    {GL_FRONT_FACE, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.polygon.front_face); }},
    {GL_POLYGON_MODE, kInteger,
     [](Context& c, QueryValues& v) {
       v.put(c.raster.polygon.front_mode);
       v.put(c.raster.polygon.back_mode);
     }},
    {GL_POLYGON_OFFSET_FACTOR, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.raster.polygon.offset_factor); }},
    {GL_POLYGON_OFFSET_UNITS, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.raster.polygon.offset_units); }},
    {GL_SAMPLE_COVERAGE_VALUE, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.raster.multisample.coverage_value); }},
    {GL_SAMPLE_COVERAGE_INVERT, kBoolean,
     [](Context& c, QueryValues& v) { v.put(c.raster.multisample.coverage_invert); }},
    {GL_SCISSOR_BOX, kInteger, [](Context& c, QueryValues& v) { v.put(c.raster.scissor.box); }},
};

constexpr Query kStencilAndDepth[] = {
    {GL_STENCIL_FUNC, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.stencil.function); }},
    {GL_STENCIL_VALUE_MASK, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.stencil.value_mask); }},
    {GL_STENCIL_REF, kInteger,
     [](Context& c, QueryValues& v) { v.put(clamped_stencil_reference(c)); }},
    {GL_STENCIL_FAIL, kInteger, [](Context& c, QueryValues& v) { v.put(c.raster.stencil.fail); }},
    {GL_STENCIL_PASS_DEPTH_FAIL, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.stencil.depth_fail); }},
    {GL_STENCIL_PASS_DEPTH_PASS, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.stencil.depth_pass); }},
    {GL_STENCIL_WRITEMASK, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.stencil.write_mask); }},
    {GL_STENCIL_CLEAR_VALUE, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.stencil.clear_value); }},
    {GL_DEPTH_FUNC, kInteger, [](Context& c, QueryValues& v) { v.put(c.raster.depth.function); }},
    {GL_DEPTH_WRITEMASK, kBoolean,
     [](Context& c, QueryValues& v) { v.put(c.raster.depth.write_mask); }},
    {GL_DEPTH_CLEAR_VALUE, kNormalised,
     [](Context& c, QueryValues& v) { v.put(c.raster.depth.clear_value); }},
};

constexpr Query kColorBuffer[] = {
    {GL_ALPHA_TEST_FUNC, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.alpha_function); }},
    {GL_ALPHA_TEST_REF, kNormalised,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.alpha_reference); }},
    {GL_BLEND_SRC, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.blend_source_rgb); }},
    {GL_BLEND_DST, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.blend_destination_rgb); }},
    {GL_BLEND_SRC_RGB, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.blend_source_rgb); }},
    {GL_BLEND_SRC_ALPHA, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.blend_source_alpha); }},
    {GL_BLEND_DST_RGB, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.blend_destination_rgb); }},
    {GL_BLEND_DST_ALPHA, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.blend_destination_alpha); }},
    {GL_BLEND_EQUATION, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.blend_equation); }},
    {GL_BLEND_COLOR, kNormalised,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.blend_color); }},
    {GL_LOGIC_OP_MODE, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.logic_op); }},
    {GL_DRAW_BUFFER, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.draw_buffer); }},
    {GL_READ_BUFFER, kInteger, [](Context& c, QueryValues& v) { v.put(c.read_buffer); }},
    {GL_COLOR_WRITEMASK, kBoolean,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.write_mask); }},
    {GL_COLOR_CLEAR_VALUE, kNormalised,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.clear_color); }},
    {GL_INDEX_CLEAR_VALUE, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.raster.color_buffer.clear_index); }},
    {GL_INDEX_WRITEMASK, kInteger,
     [](Context& c, QueryValues& v) { v.put(as_bits(c.raster.color_buffer.index_mask)); }},
};

constexpr Query kPixelStore[] = {
    {GL_UNPACK_SWAP_BYTES, kBoolean,
     [](Context& c, QueryValues& v) { v.put(c.unpack.swap_bytes); }},
    {GL_UNPACK_LSB_FIRST, kBoolean, [](Context& c, QueryValues& v) { v.put(c.unpack.lsb_first); }},
    {GL_UNPACK_ALIGNMENT, kInteger, [](Context& c, QueryValues& v) { v.put(c.unpack.alignment); }},
    {GL_UNPACK_ROW_LENGTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.unpack.row_length); }},
    {GL_UNPACK_SKIP_ROWS, kInteger, [](Context& c, QueryValues& v) { v.put(c.unpack.skip_rows); }},
    {GL_UNPACK_SKIP_PIXELS, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.unpack.skip_pixels); }},
    {GL_UNPACK_IMAGE_HEIGHT, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.unpack.image_height); }},
    {GL_UNPACK_SKIP_IMAGES, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.unpack.skip_images); }},
    {GL_PACK_SWAP_BYTES, kBoolean, [](Context& c, QueryValues& v) { v.put(c.pack.swap_bytes); }},
    {GL_PACK_LSB_FIRST, kBoolean, [](Context& c, QueryValues& v) { v.put(c.pack.lsb_first); }},
    {GL_PACK_ALIGNMENT, kInteger, [](Context& c, QueryValues& v) { v.put(c.pack.alignment); }},
    {GL_PACK_ROW_LENGTH, kInteger, [](Context& c, QueryValues& v) { v.put(c.pack.row_length); }},
    {GL_PACK_SKIP_ROWS, kInteger, [](Context& c, QueryValues& v) { v.put(c.pack.skip_rows); }},
    {GL_PACK_SKIP_PIXELS, kInteger, [](Context& c, QueryValues& v) { v.put(c.pack.skip_pixels); }},
    {GL_PACK_IMAGE_HEIGHT, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.pack.image_height); }},
    {GL_PACK_SKIP_IMAGES, kInteger, [](Context& c, QueryValues& v) { v.put(c.pack.skip_images); }},
};

template <unsigned Channel>
void scale_of(Context& c, QueryValues& v) {
  v.put(static_cast<double>(c.pixels.transfer.scale[Channel]));
}
template <unsigned Channel>
void bias_of(Context& c, QueryValues& v) {
  v.put(static_cast<double>(c.pixels.transfer.bias[Channel]));
}
template <unsigned Map>
void map_size(Context& c, QueryValues& v) {
  v.put(static_cast<double>(c.pixels.maps[Map].size()));
}

constexpr Query kPixelTransfer[] = {
    {GL_MAP_COLOR, kBoolean,
     [](Context& c, QueryValues& v) { v.put(c.pixels.transfer.map_color); }},
    {GL_MAP_STENCIL, kBoolean,
     [](Context& c, QueryValues& v) { v.put(c.pixels.transfer.map_stencil); }},
    {GL_INDEX_SHIFT, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.pixels.transfer.index_shift); }},
    {GL_INDEX_OFFSET, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.pixels.transfer.index_offset); }},
    {GL_RED_SCALE, kFloat, scale_of<0>},
    {GL_GREEN_SCALE, kFloat, scale_of<1>},
    {GL_BLUE_SCALE, kFloat, scale_of<2>},
    {GL_ALPHA_SCALE, kFloat, scale_of<3>},
    {GL_RED_BIAS, kFloat, bias_of<0>},
    {GL_GREEN_BIAS, kFloat, bias_of<1>},
    {GL_BLUE_BIAS, kFloat, bias_of<2>},
    {GL_ALPHA_BIAS, kFloat, bias_of<3>},
    {GL_DEPTH_SCALE, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.pixels.transfer.depth_scale); }},
    {GL_DEPTH_BIAS, kFloat,
     [](Context& c, QueryValues& v) { v.put(c.pixels.transfer.depth_bias); }},
    {GL_ZOOM_X, kFloat, [](Context& c, QueryValues& v) { v.put(c.pixels.transfer.zoom_x); }},
    {GL_ZOOM_Y, kFloat, [](Context& c, QueryValues& v) { v.put(c.pixels.transfer.zoom_y); }},
    {GL_PIXEL_MAP_I_TO_I_SIZE, kInteger, map_size<kMapIToI>},
    {GL_PIXEL_MAP_S_TO_S_SIZE, kInteger, map_size<kMapSToS>},
    {GL_PIXEL_MAP_I_TO_R_SIZE, kInteger, map_size<kMapIToR>},
    {GL_PIXEL_MAP_I_TO_G_SIZE, kInteger, map_size<kMapIToG>},
    {GL_PIXEL_MAP_I_TO_B_SIZE, kInteger, map_size<kMapIToB>},
    {GL_PIXEL_MAP_I_TO_A_SIZE, kInteger, map_size<kMapIToA>},
    {GL_PIXEL_MAP_R_TO_R_SIZE, kInteger, map_size<kMapRToR>},
    {GL_PIXEL_MAP_G_TO_G_SIZE, kInteger, map_size<kMapGToG>},
    {GL_PIXEL_MAP_B_TO_B_SIZE, kInteger, map_size<kMapBToB>},
    {GL_PIXEL_MAP_A_TO_A_SIZE, kInteger, map_size<kMapAToA>},
    {GL_MAX_PIXEL_MAP_TABLE, kInteger, [](Context&, QueryValues& v) { v.put(kMaxPixelMapTable); }},
};

constexpr Query kAttributeStacks[] = {
    {GL_ATTRIB_STACK_DEPTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.attribute_stacks.server.depth()); }},
    {GL_MAX_ATTRIB_STACK_DEPTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.attribute_stacks.server.kMaxDepth); }},
    {GL_CLIENT_ATTRIB_STACK_DEPTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.attribute_stacks.client.depth()); }},
    {GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.attribute_stacks.client.kMaxDepth); }},
};

constexpr Query kFogAndClipping[] = {
    {GL_FOG_COLOR, kNormalised, [](Context& c, QueryValues& v) { v.put(c.fog.color); }},
    {GL_FOG_INDEX, kFloat, [](Context& c, QueryValues& v) { v.put(c.fog.index); }},
    {GL_FOG_DENSITY, kFloat, [](Context& c, QueryValues& v) { v.put(c.fog.density); }},
    {GL_FOG_START, kFloat, [](Context& c, QueryValues& v) { v.put(c.fog.start); }},
    {GL_FOG_END, kFloat, [](Context& c, QueryValues& v) { v.put(c.fog.end); }},
    {GL_FOG_MODE, kInteger, [](Context& c, QueryValues& v) { v.put(c.fog.mode); }},
    {GL_FOG_COORDINATE_SOURCE, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.fog.coordinate_source); }},
    {GL_MAX_CLIP_PLANES, kInteger, [](Context&, QueryValues& v) { v.put(kMaxClipPlanes); }},
};

constexpr Query kEvaluators[] = {
    {GL_MAX_EVAL_ORDER, kInteger, [](Context&, QueryValues& v) { v.put(kMaxEvalOrder); }},
    {GL_MAP1_GRID_SEGMENTS, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.evaluators.modes.segments[0]); }},
    {GL_MAP2_GRID_SEGMENTS, kInteger,
     [](Context& c, QueryValues& v) {
       for (unsigned i = 1; i < 3; ++i) v.put(c.evaluators.modes.segments[i]);
     }},
    {GL_MAP1_GRID_DOMAIN, kFloat,
     [](Context& c, QueryValues& v) {
       for (unsigned i = 0; i < 2; ++i) v.put(static_cast<double>(c.evaluators.modes.grid[i]));
     }},
    {GL_MAP2_GRID_DOMAIN, kFloat,
     [](Context& c, QueryValues& v) {
       for (unsigned i = 2; i < 6; ++i) v.put(static_cast<double>(c.evaluators.modes.grid[i]));
     }},
};

constexpr Query kSelection[] = {
    {GL_RENDER_MODE, kInteger, [](Context& c, QueryValues& v) { v.put(c.selection.render_mode); }},
    {GL_NAME_STACK_DEPTH, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.selection.name_count); }},
    {GL_MAX_NAME_STACK_DEPTH, kInteger,
     [](Context&, QueryValues& v) { v.put(SelectionState::kMaxNames); }},
    {GL_SELECTION_BUFFER_SIZE, kInteger,
     [](Context& c, QueryValues& v) { v.put(number(c.selection.buffer_size)); }},
    {GL_FEEDBACK_BUFFER_SIZE, kInteger,
     [](Context& c, QueryValues& v) { v.put(number(c.feedback.buffer_size)); }},
    {GL_FEEDBACK_BUFFER_TYPE, kInteger, [](Context& c, QueryValues& v) { v.put(c.feedback.type); }},
};

constexpr Query kListsAndHints[] = {
    {GL_LIST_BASE, kInteger, [](Context& c, QueryValues& v) { v.put(c.list_modes.base); }},
    {GL_LIST_INDEX, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.list_modes.compiling_name); }},
    {GL_LIST_MODE, kInteger, [](Context& c, QueryValues& v) { v.put(c.list_modes.mode); }},
    {GL_MAX_LIST_NESTING, kInteger,
     [](Context&, QueryValues& v) { v.put(ListModes::kMaxNesting); }},
    {GL_PERSPECTIVE_CORRECTION_HINT, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.hints.perspective_correction); }},
    {GL_POINT_SMOOTH_HINT, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.hints.point_smooth); }},
    {GL_LINE_SMOOTH_HINT, kInteger, [](Context& c, QueryValues& v) { v.put(c.hints.line_smooth); }},
    {GL_POLYGON_SMOOTH_HINT, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.hints.polygon_smooth); }},
    {GL_FOG_HINT, kInteger, [](Context& c, QueryValues& v) { v.put(c.hints.fog); }},
    {GL_GENERATE_MIPMAP_HINT, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.hints.generate_mipmap); }},
    {GL_TEXTURE_COMPRESSION_HINT, kInteger,
     [](Context& c, QueryValues& v) { v.put(c.hints.texture_compression); }},
    {GL_PHONG_HINT_WIN, kInteger, [](Context& c, QueryValues& v) { v.put(c.hints.phong); }},
};

}  // namespace

QueryGroups state_queries() {
  static constexpr std::span<const Query> kGroups[] = {
      kCurrentValues,   kRasterPosition, kTransform,  kLighting,      kRasterization,
      kStencilAndDepth, kColorBuffer,    kPixelStore, kListsAndHints, kFogAndClipping,
      kAttributeStacks, kPixelTransfer,  kSelection,  kEvaluators};
  return kGroups;
}

}  // namespace legacy_gl
