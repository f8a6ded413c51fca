#pragma once
#include "context/context.hpp"

namespace legacy_gl {

/// A bitmap whose left lower corner is at the window coordinates (x, y) waits for draw_bitmaps.
void add_bitmap(Context& context, GLint x, GLint y, const BitmapImage& image);
void draw_bitmaps(Context& context);

}  // namespace legacy_gl
