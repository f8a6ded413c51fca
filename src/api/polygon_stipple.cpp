// GL 2.1 spec 3.5.2, 6.1.5: glPolygonStipple, glGetPolygonStipple.
#include "dlist/dispatch.hpp"
#include "record/pending.hpp"
#include "texture/bitmap_image.hpp"
#include "texture/pixel_format.hpp"

using namespace legacy_gl;

namespace {

constexpr GLsizei kSide = 32;

PolygonStipple unpack_stipple(const PixelStore& store, const GLubyte* mask) {
  BitmapImage image;
  unpack_bitmap(store, kSide, kSide, mask, image);
  PolygonStipple rows{};
  std::size_t at = 0;
  for (std::uint32_t& row : rows)
    for (unsigned byte = 0; byte < 4; ++byte)
      row = row << 8 | static_cast<unsigned char>(image.bits[at++]);
  return rows;
}

void polygon_stipple(Context& c, PolygonStipple rows) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  assign(c, c.raster.polygon_stipple, rows, kDirtyFragments);
}

void get_polygon_stipple(Context& c, GLubyte* mask) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  if (!mask) return;
  std::array<GLuint, kSide * kSide> bits{};
  for (unsigned y = 0; y < kSide; ++y)
    for (unsigned x = 0; x < kSide; ++x)
      bits[y * kSide + x] = c.raster.polygon_stipple[y] >> (kSide - 1 - x) & 1u;
  pack_bits(c.pack, bits.data(), kSide, kSide, reinterpret_cast<std::byte*>(mask));
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglPolygonStipple(const GLubyte* mask) {
  with_context([mask](Context& c) {
    if (mask) dispatch<polygon_stipple>(unpack_stipple(c.unpack, mask));
  });
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetPolygonStipple(GLubyte* mask) {
  execute_now<get_polygon_stipple>(mask);
}
