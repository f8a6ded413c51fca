// GL 2.1 spec 2.6: Begin and End.
#include "dlist/dispatch.hpp"

using namespace legacy_gl;

namespace {

void begin(Context& c, GLenum mode) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  if (mode > GL_POLYGON) return raise_error(c, GL_INVALID_ENUM);
  c.recorder.begin(c, mode);
}

void end(Context& c) {
  if (!c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  c.recorder.end(c);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglBegin(GLenum mode) { dispatch<begin>(mode); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEnd(void) { dispatch<end>(); }
