// GL 2.1 spec 2.6: Begin and End.
#include "execute/begin_end.hpp"

#include "dlist/dispatch.hpp"

using namespace legacy_gl;

LEGACY_GL_API void LEGACY_GL_APIENTRY lglBegin(GLenum mode) { dispatch<execute::begin>(mode); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEnd(void) {
  dispatch<execute::end>();
  if (!direct_context && current_context && current_context->list_modes.compiling)
    with_context([](Context& context) { context.lists.weld(); });
}
