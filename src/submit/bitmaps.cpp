// Bitmaps: a text of one state is one draw from the atlas of glyphs (GL 2.1 spec 3.7).
#include "submit/bitmaps.hpp"

#include <algorithm>

#include "submit/pixel_quads.hpp"
#include "submit/prepare.hpp"

namespace legacy_gl {

void draw_bitmaps(Context& context) {
  DriverObjects& objects = *context.driver;
  Submission& submission = *context.submission;
  context.bitmaps_pending = false;
  objects.textures.select_unit(kPixelTextureUnit);
  if (objects.bitmaps.bind())
    draw_pixel_quads(context, PixelSource::kBitmap, objects.bitmaps.vertices(),
                     pixel_raster(context.raster), &submission.bitmap_texture_coordinates);
  else raise_error(context, GL_OUT_OF_MEMORY);
  objects.bitmaps.clear();
}

void add_bitmap(Context& context, GLint x, GLint y, const BitmapImage& image) {
  DriverObjects& objects = *context.driver;
  Submission& submission = *context.submission;
  const RasterTextureCoordinates& coordinates = context.current.raster.texture_coordinates;
  if (!context.bitmaps_pending) {
    submission.bitmap_texture_coordinates = coordinates;
  } else if (active_textures(context.texture).mask &&
             submission.bitmap_texture_coordinates != coordinates) {
    draw_bitmaps(context);
    submission.bitmap_texture_coordinates = coordinates;
  }
  constexpr GLsizei kSide = BitmapAtlas::kMaxSide;
  for (GLsizei top = 0; top < image.height; top += kSide)
    for (GLsizei left = 0; left < image.width; left += kSide) {
      const GLsizei width = std::min(kSide, image.width - left);
      const GLsizei height = std::min(kSide, image.height - top);
      const bool whole = width == image.width && height == image.height;
      const BitmapImage part = whole ? BitmapImage{} : image.part(left, top, width, height);
      const auto add = [&] {
        return objects.bitmaps.add(context.current.raster, x + left, y + top, whole ? image : part);
      };
      if (!add()) {
        if (context.bitmaps_pending) draw_bitmaps(context);
        objects.bitmaps.forget();
        add();
      }
      context.bitmaps_pending = true;
    }
}

}  // namespace legacy_gl
