#pragma once

struct legacy_gl_context;

namespace legacy_gl {

/// The recorder's batch in GL_SELECT: primitives that are partly in the view volume hit (GL 2.1
/// spec 5.2). Nothing is drawn, and the batch is cleared.
void select_recorded(legacy_gl_context& context);

}  // namespace legacy_gl
