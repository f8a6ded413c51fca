#pragma once
#include "context/context.hpp"
#include "submit/choose_path.hpp"

namespace legacy_gl {

/// What choose_path reads of the context.
PathState path_state(const Context& context);

}  // namespace legacy_gl
