// glXUseXFont: a display list for each glyph of an X font (GLX 1.4 spec 3.3.13).
#define LEGACY_GL_NO_NAMES
#include <GL/glx.h>
#include <legacy_gl/context.h>
#include <legacy_gl/gl.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "platform/export.hpp"

namespace {

/// Draws glyphs into a bitmap of the X server's and reads them back.
class GlyphReader {
 public:
  GlyphReader(Display* display, Font font, unsigned width, unsigned height)
      : display_(display),
        width_(width),
        height_(height),
        pixmap_(XCreatePixmap(display, DefaultRootWindow(display), width, height, 1)) {
    XGCValues values{};
    values.font = font;
    context_ = XCreateGC(display, pixmap_, GCFont, &values);
  }
  ~GlyphReader() {
    XFreeGC(display_, context_);
    XFreePixmap(display_, pixmap_);
  }
  GlyphReader(const GlyphReader&) = delete;
  GlyphReader& operator=(const GlyphReader&) = delete;

  /// One bit a pixel, the bottom row first, each row whole bytes, as glBitmap takes it with
  /// GL_UNPACK_ALIGNMENT 1.
  std::vector<GLubyte> read(unsigned character, const XCharStruct& metrics) {
    const int width = metrics.rbearing - metrics.lbearing,
              height = metrics.ascent + metrics.descent;
    XSetForeground(display_, context_, 0);
    XFillRectangle(display_, pixmap_, context_, 0, 0, width_, height_);
    XSetForeground(display_, context_, 1);
    XChar2b text{static_cast<unsigned char>(character >> 8),
                 static_cast<unsigned char>(character & 255)};
    XDrawString16(display_, pixmap_, context_, -metrics.lbearing, metrics.ascent, &text, 1);
    const std::size_t stride = static_cast<std::size_t>(width + 7) / 8;
    std::vector<GLubyte> bits(stride * static_cast<std::size_t>(height));
    XImage* const image = XGetImage(display_, pixmap_, 0, 0, static_cast<unsigned>(width),
                                    static_cast<unsigned>(height), 1, XYPixmap);
    if (!image) return bits;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (XGetPixel(image, x, height - 1 - y))
          bits[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x / 8)] |=
              static_cast<GLubyte>(0x80 >> (x % 8));
    XDestroyImage(image);
    return bits;
  }

 private:
  Display* display_;
  unsigned width_, height_;
  Pixmap pixmap_;
  GC context_;
};

/// The metrics of a character; nullptr for one that the font does not have.
const XCharStruct* metrics_of(const XFontStruct& font, unsigned character) {
  const unsigned row = character >> 8, column = character & 255;
  if (row < font.min_byte1 || row > font.max_byte1 || column < font.min_char_or_byte2 ||
      column > font.max_char_or_byte2)
    return nullptr;
  if (!font.per_char) return &font.max_bounds;
  const unsigned columns = font.max_char_or_byte2 - font.min_char_or_byte2 + 1;
  return &font.per_char[(row - font.min_byte1) * columns + column - font.min_char_or_byte2];
}

}  // namespace

LEGACY_GL_EXPORT void glXUseXFont(Font font, int first, int count, int listBase) {
  if (!legacy_gl_get_current()) return;
  Display* const display = glXGetCurrentDisplay();
  XFontStruct* const description = XQueryFont(display, font);
  if (!description) return;
  const XCharStruct& largest = description->max_bounds;
  const int width = std::max(1, largest.rbearing - description->min_bounds.lbearing);
  const int height = std::max(1, largest.ascent + largest.descent);
  GlyphReader reader(display, font, static_cast<unsigned>(width), static_cast<unsigned>(height));

  lglPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
  lglPixelStorei(GL_UNPACK_SWAP_BYTES, GL_FALSE);
  lglPixelStorei(GL_UNPACK_LSB_FIRST, GL_FALSE);
  lglPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  lglPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
  lglPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
  lglPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (int i = 0; i < count; ++i) {
    const auto character = static_cast<unsigned>(first + i);
    const XCharStruct* const metrics = metrics_of(*description, character);
    lglNewList(static_cast<GLuint>(listBase + i), GL_COMPILE);
    if (metrics) {
      const int glyph_width = metrics->rbearing - metrics->lbearing;
      const int glyph_height = metrics->ascent + metrics->descent;
      const bool visible = glyph_width > 0 && glyph_height > 0;
      const std::vector<GLubyte> bits =
          visible ? reader.read(character, *metrics) : std::vector<GLubyte>();
      lglBitmap(visible ? glyph_width : 0, visible ? glyph_height : 0,
                static_cast<GLfloat>(-metrics->lbearing), static_cast<GLfloat>(metrics->descent),
                static_cast<GLfloat>(metrics->width), 0, bits.data());
    }
    lglEndList();
  }
  lglPopClientAttrib();
  XFreeFontInfo(nullptr, description, 1);
}
