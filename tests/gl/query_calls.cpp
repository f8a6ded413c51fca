#include "gl/query_calls.hpp"

namespace legacy_gl::test {

namespace {

void current_values(const GlFunctions& gl) {
  gl.Color4f(0.25F, 0.5F, 0.75F, 0.1F);
  gl.Normal3f(-0.6F, 0, 0.8F);
  gl.SecondaryColor3f(0.3F, 0.2F, 0.9F);
  gl.FogCoordf(2.5F);
  gl.Indexf(7.5F);
  gl.EdgeFlag(GL_FALSE);
  gl.TexCoord4f(0.1F, 1.5F, -2.5F, 3.4F);
  gl.MultiTexCoord2f(GL_TEXTURE1, 5, 6);
}

/// Beyond what a colour buffer holds, as the current values may be.
void current_values_negative(const GlFunctions& gl) {
  gl.Color4b(-128, 127, 0, -1);
  gl.Normal3s(-32768, 32767, 1);
  gl.SecondaryColor3ub(255, 1, 128);
}

void second_texture_unit(const GlFunctions& gl) {
  gl.MultiTexCoord4f(GL_TEXTURE3, 1, 2, 3, 4);
  gl.ActiveTexture(GL_TEXTURE3);
  gl.ClientActiveTexture(GL_TEXTURE2);
  gl.MatrixMode(GL_TEXTURE);
  gl.PushMatrix();
}

void first_texture_unit(const GlFunctions& gl) {
  gl.MatrixMode(GL_TEXTURE);
  gl.Scalef(2, 3, 4);
  gl.Translatef(1, 2, 3);
}

void matrices(const GlFunctions& gl) {
  gl.Translatef(1.25F, -2.5F, 3);
  gl.Rotatef(33, 1, 2, 3);
  gl.PushMatrix();
  gl.PushMatrix();
  gl.Scalef(0.5F, 2, -1);
  gl.MatrixMode(GL_PROJECTION);
  gl.Frustum(-1, 2, -0.5, 0.75, 1.5, 40);
  gl.PushMatrix();
  gl.Ortho(-3, 2, -1, 1, 5, -2);
}

void lighting(const GlFunctions& gl) {
  const GLfloat ambient[] = {0.1F, 0.7F, 1, -0.5F};
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT3);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 5);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  gl.ColorMaterial(GL_BACK, GL_SPECULAR);
  gl.Enable(GL_COLOR_MATERIAL);
  gl.ShadeModel(GL_FLAT);
  gl.Enable(GL_NORMALIZE);
  gl.Enable(GL_RESCALE_NORMAL);
  gl.Enable(GL_COLOR_SUM);
}

void rasterization(const GlFunctions& gl) {
  gl.PointSize(2.5F);
  gl.Enable(GL_POINT_SMOOTH);
  gl.LineWidth(3.25F);
  gl.LineStipple(7, 0x8421);
  gl.Enable(GL_LINE_STIPPLE);
  gl.Enable(GL_POLYGON_STIPPLE);
  gl.CullFace(GL_FRONT_AND_BACK);
  gl.FrontFace(GL_CW);
  gl.PolygonMode(GL_FRONT, GL_LINE);
  gl.PolygonMode(GL_BACK, GL_POINT);
  gl.PolygonOffset(1.5F, -2.5F);
  gl.SampleCoverage(0.3F, GL_TRUE);
  gl.Enable(GL_CULL_FACE);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.Enable(GL_POLYGON_OFFSET_LINE);
  gl.Enable(GL_POLYGON_OFFSET_POINT);
  gl.Enable(GL_SAMPLE_COVERAGE);
  gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  gl.Enable(GL_SAMPLE_ALPHA_TO_ONE);
  gl.Disable(GL_MULTISAMPLE);
}

void line_stipple_factor_too_large(const GlFunctions& gl) { gl.LineStipple(1000, 0); }
void line_stipple_factor_too_small(const GlFunctions& gl) { gl.LineStipple(-5, 0x0f0f); }

void window(const GlFunctions& gl) {
  gl.Viewport(3, -4, 30, 20);
  gl.DepthRange(0.75, 0.1);
  gl.Scissor(-5, 6, 7, 8);
  gl.Enable(GL_SCISSOR_TEST);
}

void depth_and_stencil(const GlFunctions& gl) {
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_GEQUAL);
  gl.DepthMask(GL_FALSE);
  gl.ClearDepth(0.3);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_NOTEQUAL, 17, 0x3C);
  gl.StencilOp(GL_INCR_WRAP, GL_INVERT, GL_REPLACE);
  gl.StencilMask(0x81);
  gl.ClearStencil(9);
}

/// More bits than the stencil buffer has.
void stencil_beyond_its_bits(const GlFunctions& gl) {
  gl.StencilFunc(GL_LESS, 1000, 0xFFFFFFFF);
  gl.StencilMask(0xFFFFFF00);
  gl.ClearStencil(-3);
}

void color_buffer(const GlFunctions& gl) {
  gl.Enable(GL_BLEND);
  gl.BlendFuncSeparate(GL_SRC_ALPHA_SATURATE, GL_ONE_MINUS_DST_COLOR, GL_CONSTANT_ALPHA,
                       GL_SRC_COLOR);
  gl.BlendEquation(GL_FUNC_REVERSE_SUBTRACT);
  gl.BlendColor(0.1F, 0.4F, 0.6F, 1);
  gl.Disable(GL_DITHER);
  gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  gl.ClearColor(0.2F, 0.5F, 1, 0.3F);
  gl.ClearIndex(5);
  gl.IndexMask(0x0F);
  gl.Enable(GL_INDEX_LOGIC_OP);
}

void hints(const GlFunctions& gl) {
  gl.Hint(GL_PERSPECTIVE_CORRECTION_HINT, GL_NICEST);
  gl.Hint(GL_POINT_SMOOTH_HINT, GL_FASTEST);
  gl.Hint(GL_LINE_SMOOTH_HINT, GL_NICEST);
  gl.Hint(GL_POLYGON_SMOOTH_HINT, GL_FASTEST);
  gl.Hint(GL_FOG_HINT, GL_NICEST);
  gl.Hint(GL_GENERATE_MIPMAP_HINT, GL_FASTEST);
  gl.Hint(GL_TEXTURE_COMPRESSION_HINT, GL_NICEST);
}

void pixel_store(const GlFunctions& gl) {
  gl.PixelStorei(GL_PACK_SWAP_BYTES, 2);
  gl.PixelStorei(GL_PACK_LSB_FIRST, GL_TRUE);
  gl.PixelStoref(GL_PACK_ALIGNMENT, 1.6F);
  gl.PixelStorei(GL_PACK_ROW_LENGTH, 10);
  gl.PixelStorei(GL_PACK_SKIP_ROWS, 11);
  gl.PixelStorei(GL_PACK_SKIP_PIXELS, 12);
  gl.PixelStorei(GL_PACK_IMAGE_HEIGHT, 13);
  gl.PixelStorei(GL_PACK_SKIP_IMAGES, 14);
  gl.PixelStoref(GL_UNPACK_SWAP_BYTES, 1);
  gl.PixelStorei(GL_UNPACK_LSB_FIRST, GL_TRUE);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 8);
  gl.PixelStoref(GL_UNPACK_ROW_LENGTH, 20.4F);
  gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 21);
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 22);
  gl.PixelStorei(GL_UNPACK_IMAGE_HEIGHT, 23);
  gl.PixelStorei(GL_UNPACK_SKIP_IMAGES, 24);
}

void lists(const GlFunctions& gl) {
  gl.ListBase(500);
  gl.NewList(3, GL_COMPILE_AND_EXECUTE);
}

void stacks(const GlFunctions& gl) {
  for (int i = 0; i < 5; ++i) gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  for (int i = 0; i < 7; ++i) gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  gl.PopAttrib();
  gl.PopClientAttrib();
}

void client_arrays(const GlFunctions& gl) {
  static const GLfloat values[64] = {};
  gl.VertexPointer(3, GL_SHORT, 16, values);
  gl.NormalPointer(GL_BYTE, 12, values);
  gl.ColorPointer(3, GL_UNSIGNED_BYTE, 24, values);
  gl.SecondaryColorPointer(3, GL_UNSIGNED_SHORT, 28, values);
  gl.FogCoordPointer(GL_DOUBLE, 32, values);
  gl.IndexPointer(GL_SHORT, 36, values);
  gl.EdgeFlagPointer(4, values);
  gl.TexCoordPointer(2, GL_INT, 40, values);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.EnableClientState(GL_SECONDARY_COLOR_ARRAY);
  gl.EnableClientState(GL_FOG_COORDINATE_ARRAY);
  gl.EnableClientState(GL_INDEX_ARRAY);
  gl.EnableClientState(GL_EDGE_FLAG_ARRAY);
  gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
}

void everything(const GlFunctions& gl) {
  for (const auto calls :
       {current_values, matrices, lighting, rasterization, window, depth_and_stencil, color_buffer,
        hints, pixel_store, client_arrays, second_texture_unit, stacks, lists})
    calls(gl);
}

/// Everything is changed between the push and the pop of some groups, and what no group has stays
/// changed.
template <GLbitfield Groups>
void popped(const GlFunctions& gl) {
  gl.PushAttrib(Groups);
  for (const auto calls : {current_values, lighting, rasterization, window, depth_and_stencil,
                           color_buffer, hints, second_texture_unit})
    calls(gl);
  gl.ListBase(9);
  // What Mesa does not bring back: AttributeStack.BringsBackWhatMesaForgets.
  gl.Disable(GL_LIGHT3);
  gl.Disable(GL_COLOR_SUM);
  gl.Hint(GL_GENERATE_MIPMAP_HINT, GL_DONT_CARE);
  gl.PopAttrib();
}

template <GLbitfield Groups>
void client_popped(const GlFunctions& gl) {
  gl.PushClientAttrib(Groups);
  client_arrays(gl);
  pixel_store(gl);
  gl.ClientActiveTexture(GL_TEXTURE2);
  gl.PopClientAttrib();
}

/// All of it changed between the push and the pop.
void everything_popped(const GlFunctions& gl) {
  gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  for (const auto calls : {current_values, lighting, rasterization, window, depth_and_stencil,
                           color_buffer, hints, pixel_store, client_arrays, second_texture_unit})
    calls(gl);
  gl.ListBase(9);
  // What Mesa does not bring back: AttributeStack.BringsBackWhatMesaForgets.
  gl.Disable(GL_COLOR_SUM);
  gl.Hint(GL_GENERATE_MIPMAP_HINT, GL_DONT_CARE);
  gl.PopClientAttrib();
  gl.PopAttrib();
}

constexpr QueryCalls kCalls[] = {
    {"current_values", current_values},
    {"current_values_negative", current_values_negative},
    {"second_texture_unit", second_texture_unit},
    {"first_texture_unit", first_texture_unit},
    {"matrices", matrices},
    {"lighting", lighting},
    {"rasterization", rasterization},
    {"line_stipple_factor_too_large", line_stipple_factor_too_large},
    {"line_stipple_factor_too_small", line_stipple_factor_too_small},
    {"window", window},
    {"depth_and_stencil", depth_and_stencil},
    {"stencil_beyond_its_bits", stencil_beyond_its_bits},
    {"color_buffer", color_buffer},
    {"hints", hints},
    {"pixel_store", pixel_store},
    {"lists", lists},
    {"stacks", stacks},
    {"client_arrays", client_arrays},
    {"everything", everything},
    {"everything_popped", everything_popped},
    {"popped_current", popped<GL_CURRENT_BIT>},
    {"popped_point", popped<GL_POINT_BIT>},
    {"popped_line", popped<GL_LINE_BIT>},
    {"popped_polygon", popped<GL_POLYGON_BIT>},
    {"popped_polygon_stipple", popped<GL_POLYGON_STIPPLE_BIT>},
    {"popped_pixel_mode", popped<GL_PIXEL_MODE_BIT>},
    {"popped_lighting", popped<GL_LIGHTING_BIT>},
    {"popped_fog", popped<GL_FOG_BIT>},
    {"popped_depth_buffer", popped<GL_DEPTH_BUFFER_BIT>},
    {"popped_accum_buffer", popped<GL_ACCUM_BUFFER_BIT>},
    {"popped_stencil_buffer", popped<GL_STENCIL_BUFFER_BIT>},
    {"popped_viewport", popped<GL_VIEWPORT_BIT>},
    {"popped_transform", popped<GL_TRANSFORM_BIT>},
    {"popped_enable", popped<GL_ENABLE_BIT>},
    {"popped_color_buffer", popped<GL_COLOR_BUFFER_BIT>},
    {"popped_hint", popped<GL_HINT_BIT>},
    {"popped_eval", popped<GL_EVAL_BIT>},
    {"popped_list", popped<GL_LIST_BIT>},
    {"popped_texture", popped<GL_TEXTURE_BIT>},
    {"popped_scissor", popped<GL_SCISSOR_BIT>},
    {"popped_multisample", popped<GL_MULTISAMPLE_BIT>},
    {"popped_nothing", popped<0>},
    {"popped_lighting_and_enable", popped<GL_LIGHTING_BIT | GL_ENABLE_BIT>},
    {"popped_client_pixel_store", client_popped<GL_CLIENT_PIXEL_STORE_BIT>},
    {"popped_client_vertex_array", client_popped<GL_CLIENT_VERTEX_ARRAY_BIT>},
    {"popped_client_nothing", client_popped<0>},
};

}  // namespace

std::span<const QueryCalls> query_calls() { return kCalls; }

}  // namespace legacy_gl::test
