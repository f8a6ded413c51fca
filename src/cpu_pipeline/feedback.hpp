#pragma once
#include "record/pending.hpp"
#include "state/gl_types.hpp"

struct legacy_gl_context;

namespace legacy_gl {

/// The recorder's batch in GL_FEEDBACK: what would be rasterised of it is written to the feedback
/// buffer (GL 2.1 spec 5.3). Nothing is drawn, and the batch is cleared.
void feed_back_recorded(legacy_gl_context& context);

/// The current raster position under GL_BITMAP_TOKEN, GL_DRAW_PIXEL_TOKEN or GL_COPY_PIXEL_TOKEN.
void feed_back_raster_position(legacy_gl_context& context, GLenum token);

}  // namespace legacy_gl
