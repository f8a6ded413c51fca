// What glAccum does with the framebuffer (GL 2.1 spec 4.2.4).
#include <algorithm>
#include <cstring>

#include "submit/accumulation.hpp"

#include "submit/pixels.hpp"
#include "submit/submission.hpp"

namespace legacy_gl {

namespace {

/// The pixels that the buffer has and the scissor leaves. No driver says how large a window is: the
/// viewport does, row D24 of docs/deviations.md.
PixelRectangle accumulated_area(const RasterState& raster) {
  const auto& view = raster.viewport.box;
  PixelRectangle area{0, 0, std::max(view[0] + view[2], 0), std::max(view[1] + view[3], 0)};
  if (!raster.scissor.test_enabled) return area;
  const auto& box = raster.scissor.box;
  const auto cut = [](GLint first, GLsizei size, GLint& at, GLsizei& length) {
    const GLint end = std::min(length, first + size);
    at = std::max(first, 0);
    length = std::max(end - at, 0);
  };
  cut(box[0], box[2], area.x, area.width);
  cut(box[1], box[3], area.y, area.height);
  return area;
}

}  // namespace

void clear_accumulation(const Context& context) {
  Submission& submission = *context.submission;
  const PixelRectangle area = accumulated_area(context.raster);
  if (area.width && area.height)
    submission.accumulation.clear(area, context.accumulation.clear_value);
}

void accumulate(Context& context, GLenum operation, float value) {
  const Driver& driver = context.driver->functions;
  Submission& submission = *context.submission;
  const PixelRectangle area = accumulated_area(context.raster);
  if (!area.width || !area.height) return;
  driver.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  switch (operation) {
    case GL_ACCUM: submission.accumulation.add(area, read_colors(driver, area, {}), value); break;
    case GL_LOAD: submission.accumulation.load(area, read_colors(driver, area, {}), value); break;
    case GL_MULT: submission.accumulation.scale_and_bias(area, value, 0); break;
    case GL_ADD: submission.accumulation.scale_and_bias(area, 1, value); break;
    default: write_colors(context, area, submission.accumulation.scaled(area, value));
  }
}

}  // namespace legacy_gl
