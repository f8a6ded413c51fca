#pragma once
#include "context/context.hpp"

namespace legacy_gl {

/// Draws the recorder's batch with its polygons made into lines or points (GL 2.1 spec 3.5.4), and
/// its lines made wide or stippled.
void draw_expanded(Context& context);

}  // namespace legacy_gl
