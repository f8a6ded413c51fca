#include "dlist/dispatch.hpp"

#include "debug/log.hpp"
#include "record/recorder.hpp"
#include "record/renderer.hpp"

namespace legacy_gl {

constinit thread_local Context* direct_context = nullptr;

void update_direct_context() {
  const bool direct =
      current_context && !current_context->list_modes.compiling && !debug::names_calls();
  direct_context = direct ? current_context : nullptr;
}

void recover_from_exception(Context& context) noexcept {
  raise_error(context, GL_OUT_OF_MEMORY);
  if (context.lists.compiling_list) context.lists.give_up();
  context.recorder.abandon();
  context.bitmaps_pending = false;
  context.texture.active_stale = true;
  context.dirty = kDirtyAll;
  if (context.renderer) context.renderer->recover(context);
}

}  // namespace legacy_gl
