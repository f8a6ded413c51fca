// Bitmaps and pixel rectangles: quads in window coordinates, whose fragments go the way of all
// others (GL 2.1 spec 3.6.4, 3.7).
#include <algorithm>

#include "backend/backend.hpp"

namespace legacy_gl {

namespace {

/// Position with w; the texel in the place of the normal; the raster position's colours.
VertexLayout pixel_layout() {
  VertexLayout layout;
  layout.fields =
      kFieldPositionW | kFieldNormal | kFieldColor | kFieldSecondaryColor | kFieldFogCoord;
  return layout;
}

/// Neither viewport nor culling nor polygon offset concern pixel rectangles.
RasterState pixel_raster(const RasterState& raster) {
  RasterState pixels = raster;
  pixels.viewport = {{0, 0, kPixelWindow, kPixelWindow}, 0, 1};
  pixels.polygon = {};
  return pixels;
}

/// What of the state's key still matters. The distance is the raster position's.
ProgramKey pixel_key(const Context& context, const FragmentKey& fragments, PixelSource source) {
  ProgramKey key;
  key.pixels = source;
  key.fragments = fragments;
  key.fragments.clip_planes = 0;
  key.fragments.fog_coordinate = fragments.has_fog();
  key.secondary_from_vertex = context.color_sum_enabled ||
                              (context.lighting.enabled &&
                               context.lighting.model.color_control == GL_SEPARATE_SPECULAR_COLOR);
  return key;
}

}  // namespace

void Backend::draw_pixel_quads(Context& context, PixelSource source,
                               const std::vector<float>& vertices, const RasterState& raster) {
  const VertexLayout layout = pixel_layout();
  const std::size_t stride = offsets_of(layout).stride * sizeof(float);
  derived_.update(context, Recorder::relevant_layout(context), driver.dialect);
  upload_uniforms(context);
  const auto count = static_cast<GLsizei>(vertices.size() * sizeof(float) / stride);
  if (!use_program(context, pixel_key(context, derived_.key.fragments, source),
                   static_cast<std::uint64_t>(count)))
    return;
  raster_.apply(driver, raster, 0);
  context.dirty |= kDirtyRaster;  // the viewport of other primitives returns with the next draw
  const std::size_t offset =
      vertices_.write(vertices.data(), vertices.size() * sizeof(float), stride);
  bind_vertex_array(arrays_.find_or_build(layout, vertices_.name(), indices_.name()));
  driver.DrawArrays(GL_TRIANGLES, static_cast<GLint>(offset / stride), count);
  ++context.statistics.draws;
  ++context.statistics.batches;
}

void Backend::draw_bitmaps(Context& context) {
  context.bitmaps_pending = false;
  driver.ActiveTexture(GL_TEXTURE0 + kPixelTextureUnit);
  bitmaps_.bind();
  draw_pixel_quads(context, PixelSource::kBitmap, bitmaps_.vertices(),
                   pixel_raster(context.raster));
  bitmaps_.clear();
}

void Backend::add_bitmap(Context& context, GLint x, GLint y, const BitmapImage& image) {
  constexpr GLsizei kSide = Bitmaps::kMaxSide;
  for (GLsizei top = 0; top < image.height; top += kSide)
    for (GLsizei left = 0; left < image.width; left += kSide) {
      const GLsizei width = std::min(kSide, image.width - left);
      const GLsizei height = std::min(kSide, image.height - top);
      const bool whole = width == image.width && height == image.height;
      const BitmapImage part = whole ? BitmapImage{} : image.part(left, top, width, height);
      const auto add = [&] {
        return bitmaps_.add(context.current.raster, x + left, y + top, whole ? image : part);
      };
      if (!add()) {
        if (context.bitmaps_pending) draw_bitmaps(context);
        bitmaps_.forget();
        add();
      }
      context.bitmaps_pending = true;
    }
}

}  // namespace legacy_gl
