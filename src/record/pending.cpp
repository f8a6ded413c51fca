#include "record/pending.hpp"

#include "record/renderer.hpp"

namespace legacy_gl {

namespace {

void draw(Context& context) {
  if (context.bitmaps_pending) {
    context.bitmaps_pending = false;
    if (context.renderer) context.renderer->draw_bitmaps(context);
  }
  if (!context.recorder.has_pending()) return;
  if (context.renderer) context.renderer->draw_batch(context);
  else context.recorder.clear();
}

}  // namespace

void draw_pending(Context& context) {
  if (!context.recorder.inside_begin_end()) draw(context);
}

void draw_part_of_batch(Context& context) { draw(context); }

void before_matrix_change(Context& context) {
  if (!context.recorder.has_pending() || context.recorder.all_shaded()) return;
  if (shade_pending(context)) return;
  // Selection and feedback take vertices as they were given.
  const bool rendering = context.selection.is_rendering();
  if (!rendering || !context.renderer || !context.renderer->detach_from_matrices(context))
    draw_pending(context);
}

bool shade_pending(Context& context) {
  return context.selection.is_rendering() && !context.bitmaps_pending && context.renderer &&
         context.renderer->shade_batch(context);
}

void before_lighting_change(Context& context) {
  if (context.recorder.all_shaded() && !context.bitmaps_pending) return;
  if (context.recorder.is_idle() || !shade_pending(context)) flush_pending(context);
}

bool shades_next_draw(Context& context) {
  return context.renderer && context.renderer->shades_next_draw(context);
}

void before_texture_change(Context& context) {
  flush_pending(context);
  context.texture.active_stale = true;
  mark_dirty(context, kDirtyTexture);
}

}  // namespace legacy_gl
