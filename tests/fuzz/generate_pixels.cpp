// Raster positions, bitmaps, pixel rectangles and their transfer.
#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

void set_raster_position(Builder& b) {
  if (b.random.chance(50)) return b.call("WindowPos2i", b.random.below(50), b.random.below(50));
  b.call("RasterPos2f", b.coordinate(), b.coordinate());
}

void draw_bitmap(Builder& b) {
  const int height = b.random.between(1, 9);
  // Rows of four bytes, whatever the alignment that is in force.
  b.call("Bitmap", 8, height, b.random.between(-2, 2), 0, 9, b.random.between(-1, 1),
         input("GLubyte", b.random.whole(static_cast<std::size_t>(height * 8), 0, 255)));
  // Mesa keeps bitmaps back and draws them in the state that comes later.
  if (!b.in_list) b.call("Flush");
}

void draw_rectangle_of_pixels(Builder& b) {
  const int height = b.random.between(1, 6);
  const auto [format, components] = b.random.pick<std::pair<const char*, int>>(
      {{"GL_RGBA", 4}, {"GL_RGB", 3}, {"GL_LUMINANCE", 1}, {"GL_LUMINANCE_ALPHA", 2}});
  if (b.random.chance(70))
    return b.call("DrawPixels", 8, height, format, "GL_UNSIGNED_BYTE",
                  input("GLubyte",
                        b.random.whole(static_cast<std::size_t>(8 * height * components), 0, 255)));
  b.call("DrawPixels", 8, height, format, "GL_FLOAT",
         floats(b.random.reals(static_cast<std::size_t>(8 * height * components), 0, 1)));
}

}  // namespace

void draw_pixels(Builder& b) {
  auto& random = b.random;
  set_raster_position(b);
  // Whole zooms: D20.
  if (random.chance(30)) b.call("PixelZoom", random.pick({1, 2, -1, 3}), random.pick({1, 2, -2}));
  switch (random.below(5)) {
    case 0:
    case 1: return draw_bitmap(b);
    case 2:
      return b.call("CopyPixels", random.below(30), random.below(30), random.between(1, 12),
                    random.between(1, 12), "GL_COLOR");
    default: return draw_rectangle_of_pixels(b);
  }
}

}  // namespace legacy_gl::fuzz
