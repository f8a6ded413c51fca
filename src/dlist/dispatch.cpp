#include "dlist/dispatch.hpp"

#include "debug/log.hpp"

namespace legacy_gl {

constinit thread_local Context* direct_context = nullptr;

void update_direct_context() {
  const bool direct =
      current_context && !current_context->list_modes.compiling && !debug::names_calls();
  direct_context = direct ? current_context : nullptr;
}

}  // namespace legacy_gl
