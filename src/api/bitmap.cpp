// GL 2.1 spec 3.7: glBitmap.
#include <algorithm>
#include <cmath>
#include <memory>

#include "cpu_pipeline/feedback.hpp"
#include "dlist/dispatch.hpp"
#include "record/pending.hpp"
#include "submit/bitmaps.hpp"
#include "texture/bitmap_image.hpp"

using namespace legacy_gl;

namespace {

struct Origin {
  float x, y;
};

/// Raster positions a rounding below a whole pixel belong to it, as on Mesa.
GLint first_pixel(float position, float origin) {
  return static_cast<GLint>(std::floor(std::clamp(position + 0.0001f - origin, -1e6f, 1e6f)));
}

void bitmap(Context& c, const BitmapImage* image, Origin origin, Origin move) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  RasterPosition& raster = c.current.raster;
  if (!raster.valid) return;
  if (c.selection.is_feeding_back()) feed_back_raster_position(c, GL_BITMAP_TOKEN);
  if (image && c.selection.is_rendering()) {
    if (c.recorder.has_pending()) draw_pending(c);
    add_bitmap(c, first_pixel(raster.position.x, origin.x),
               first_pixel(raster.position.y, origin.y), *image);
  }
  raster.position.x += move.x;
  raster.position.y += move.y;
}

void bitmap_error(Context& c, GLenum error) {
  raise_error(c, c.recorder.inside_begin_end() ? GLenum{GL_INVALID_OPERATION} : error);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglBitmap(GLsizei width, GLsizei height, GLfloat xorig,
                                                GLfloat yorig, GLfloat xmove, GLfloat ymove,
                                                const GLubyte* pixels) {
  if (width < 0 || height < 0) return dispatch<bitmap_error>(GLenum{GL_INVALID_VALUE});
  const Origin origin{xorig, yorig}, move{xmove, ymove};
  const BitmapImage* const none = nullptr;
  if (!width || !height || !pixels) return dispatch<bitmap>(none, origin, move);
  with_context([&](Context& c) {
    if (!c.list_modes.compiling) {
      unpack_bitmap(c.unpack, width, height, pixels, c.bitmap_scratch);
      return bitmap(c, &c.bitmap_scratch, origin, move);
    }
    const auto image = std::make_shared<BitmapImage>();
    unpack_bitmap(c.unpack, width, height, pixels, *image);
    c.lists.keep(image);
    const BitmapImage* const kept = image.get();
    dispatch<bitmap>(kept, origin, move);
  });
}
