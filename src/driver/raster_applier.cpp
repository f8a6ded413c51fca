#include "driver/raster_applier.hpp"

#include <algorithm>
#include <cmath>

namespace legacy_gl {

namespace {

void set_enabled(const Driver& driver, GLenum capability, bool enabled) {
  if (enabled) driver.Enable(capability);
  else driver.Disable(capability);
}

void apply_depth(const Driver& driver, const DepthState& depth) {
  set_enabled(driver, GL_DEPTH_TEST, depth.test_enabled);
  driver.DepthFunc(depth.function);
  driver.DepthMask(depth.write_mask);
  if (driver.ClearDepth) driver.ClearDepth(depth.clear_value);
  else if (driver.ClearDepthf) driver.ClearDepthf(static_cast<GLfloat>(depth.clear_value));
}

void apply_stencil(const Driver& driver, const StencilState& stencil) {
  set_enabled(driver, GL_STENCIL_TEST, stencil.test_enabled);
  driver.StencilFunc(stencil.function, stencil.reference, stencil.value_mask);
  driver.StencilMask(stencil.write_mask);
  driver.StencilOp(stencil.fail, stencil.depth_fail, stencil.depth_pass);
  driver.ClearStencil(stencil.clear_value);
}

void apply_color_buffer(const Driver& driver, const ColorBufferState& color) {
  set_enabled(driver, GL_BLEND, color.blend_enabled);
  driver.BlendFuncSeparate(color.blend_source_rgb, color.blend_destination_rgb,
                           color.blend_source_alpha, color.blend_destination_alpha);
  driver.BlendEquation(color.blend_equation);
  driver.BlendColor(color.blend_color.r, color.blend_color.g, color.blend_color.b,
                    color.blend_color.a);
  set_enabled(driver, GL_DITHER, color.dither_enabled);
  driver.ColorMask(color.write_mask[0], color.write_mask[1], color.write_mask[2],
                   color.write_mask[3]);
  driver.ClearColor(color.clear_color.r, color.clear_color.g, color.clear_color.b,
                    color.clear_color.a);
  if (driver.LogicOp) {
    set_enabled(driver, GL_COLOR_LOGIC_OP, color.logic_op_enabled);
    driver.LogicOp(color.logic_op);
  }
}

void apply_polygon(const Driver& driver, const PolygonState& polygon) {
  set_enabled(driver, GL_CULL_FACE, polygon.cull_enabled);
  driver.CullFace(polygon.cull_face);
  driver.FrontFace(polygon.front_face);
  // Drivers fill all polygons that reach them. Some heed the offsets of lines and points for these.
  set_enabled(driver, GL_POLYGON_OFFSET_FILL, polygon.offset_fill_enabled);
  driver.PolygonOffset(polygon.offset_factor, polygon.offset_units);
  if (driver.is_es()) return;
  set_enabled(driver, GL_POLYGON_SMOOTH, polygon.smooth_enabled);
}

void apply_viewport(const Driver& driver, const ViewportState& viewport) {
  driver.Viewport(viewport.box[0], viewport.box[1], viewport.box[2], viewport.box[3]);
  if (driver.DepthRange) driver.DepthRange(viewport.depth_near, viewport.depth_far);
  else if (driver.DepthRangef)
    driver.DepthRangef(static_cast<GLfloat>(viewport.depth_near),
                       static_cast<GLfloat>(viewport.depth_far));
}

void apply_multisample(const Driver& driver, const MultisampleState& multisample) {
  set_enabled(driver, GL_SAMPLE_ALPHA_TO_COVERAGE, multisample.alpha_to_coverage);
  set_enabled(driver, GL_SAMPLE_COVERAGE, multisample.coverage);
  driver.SampleCoverage(multisample.coverage_value, multisample.coverage_invert);
  if (driver.is_es()) return;
  set_enabled(driver, GL_MULTISAMPLE, multisample.enabled);
  set_enabled(driver, GL_SAMPLE_ALPHA_TO_ONE, multisample.alpha_to_one);
}

}  // namespace

void RasterApplier::apply(const Driver& driver, const RasterState& wanted,
                          std::uint8_t clip_planes) {
  RasterState& have = driver_state_;
  if (!driver.is_es() && (!known_ || clip_planes != clip_planes_))
    for (unsigned i = 0; i < kMaxClipPlanes; ++i)
      set_enabled(driver, GL_CLIP_DISTANCE0 + i, clip_planes >> i & 1);
  clip_planes_ = clip_planes;
  if (!known_ || have.depth != wanted.depth) apply_depth(driver, wanted.depth);
  if (!known_ || have.stencil != wanted.stencil) apply_stencil(driver, wanted.stencil);
  if (!known_ || have.color_buffer != wanted.color_buffer)
    apply_color_buffer(driver, wanted.color_buffer);
  if (!known_ || have.polygon != wanted.polygon) apply_polygon(driver, wanted.polygon);
  if (!known_ || have.scissor != wanted.scissor) {
    set_enabled(driver, GL_SCISSOR_TEST, wanted.scissor.test_enabled);
    const auto& box = wanted.scissor.box;
    driver.Scissor(box[0], box[1], box[2], box[3]);
  }
  if (!known_ || have.viewport != wanted.viewport) apply_viewport(driver, wanted.viewport);
  if (!known_ || have.multisample != wanted.multisample)
    apply_multisample(driver, wanted.multisample);
  if (driver.PointSize && (!known_ || have.point != wanted.point))
    // The square of a smooth point holds all pixels that the circle touches.
    driver.PointSize(drawn_point_size(wanted.point) + (wanted.point.smooth_enabled ? 1.0f : 0.0f));
  if (!driver.is_es() && (!known_ || have.point != wanted.point))
    set_enabled(driver, GL_PROGRAM_POINT_SIZE, wanted.point.is_attenuated_or_fades());
  if (!known_ || have.line != wanted.line) {
    driver.LineWidth(thin_lines_ ? std::min(wanted.line.width, 1.0f) : wanted.line.width);
    if (!driver.is_es()) set_enabled(driver, GL_LINE_SMOOTH, wanted.line.smooth_enabled);
  }
  driver_state_ = wanted;
  known_ = true;
}

}  // namespace legacy_gl
