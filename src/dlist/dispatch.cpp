#include "dlist/dispatch.hpp"

namespace legacy_gl {

constinit thread_local Context* direct_context = nullptr;

void update_direct_context() {
  direct_context =
      current_context && !current_context->list_modes.compiling ? current_context : nullptr;
}

}  // namespace legacy_gl
