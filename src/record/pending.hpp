#pragma once
// What waits to be drawn, and when: the rule that every setter follows.
#include "context/context.hpp"
#include "debug/log.hpp"
#include "record/recorder.hpp"

namespace legacy_gl {

/// Draws what is recorded, primitives or bitmaps; in selection it only hits, and in feedback it is
/// written. Every setter calls it before it stores a value that differs.
void draw_pending(Context& context);
/// The recorder is full: what it has is drawn, and more of the same state follows.
void draw_part_of_batch(Context& context);
inline void flush_pending(Context& context) {
  if (context.recorder.has_pending() || context.bitmaps_pending) draw_pending(context);
}

/// Before the modelview or the projection changes: what is recorded is drawn, or its vertices are
/// transformed so that others can join them.
void before_matrix_change(Context& context);

/// Lights the recorded primitives on the CPU, if they are few, so that nothing that lights them
/// matters any more. False when the batch is to be drawn instead.
bool shade_pending(Context& context);

/// Before lights, the light model or a material change: what is recorded is lit or drawn.
void before_lighting_change(Context& context);

/// The next primitives of a batch that is lit on the CPU can be lit so too.
bool shades_next_draw(Context& context);

/// Before a texture unit, or a texture that may be bound, changes: draws what is recorded.
void before_texture_change(Context& context);

/// What a call has changed is derived anew before the next draw.
inline void mark_dirty(Context& context, std::uint32_t dirty_bits) {
  context.dirty |= dirty_bits;
  if (debug::names_calls()) [[unlikely]]
    debug::log_state(dirty_bits);
}

/// The order of every setter: what was recorded under the old value is drawn, then the value is
/// stored and its dirty bits raised. Returns *changed*.
template <typename T, typename U>
bool assign(Context& context, T& stored, const U& value, std::uint32_t dirty_bits) {
  if (stored == value) return false;
  flush_pending(context);
  stored = value;
  mark_dirty(context, dirty_bits);
  return true;
}

/// The same for what lights vertices.
template <typename T, typename U>
bool assign_lighting(Context& context, T& stored, const U& value, std::uint32_t dirty_bits) {
  if (stored == value) return false;
  before_lighting_change(context);
  stored = value;
  mark_dirty(context, dirty_bits);
  return true;
}

}  // namespace legacy_gl
