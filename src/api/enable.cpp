// glEnable, glDisable, glIsEnabled; errors, flushing, hints.
#include <utility>

#include "dlist/dispatch.hpp"
#include "execute/capabilities.hpp"
#include "execute/framebuffer.hpp"
#include "record/pending.hpp"
#include "submit/accumulation.hpp"
#include "submit/prepare.hpp"

using namespace legacy_gl;

namespace {

void enable(Context& c, GLenum capability, bool enabled) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  if (!set_capability(c, capability, enabled)) raise_error(c, GL_INVALID_ENUM);
}

GLboolean is_enabled(Context& c, GLenum capability) {
  if (c.recorder.inside_begin_end()) {
    raise_error(c, GL_INVALID_OPERATION);
    return GL_FALSE;
  }
  bool known = false;
  const bool enabled = capability_enabled(c, capability, known);
  if (!known) raise_error(c, GL_INVALID_ENUM);
  return enabled ? GL_TRUE : GL_FALSE;
}

GLenum get_error(Context& c) {
  // Inside Begin/End glGetError is itself an error, and answers 0 (GL 2.1 spec 2.6.3).
  if (c.recorder.inside_begin_end()) {
    raise_error(c, GL_INVALID_OPERATION);
    return GL_NO_ERROR;
  }
  return std::exchange(c.error, GLenum{GL_NO_ERROR});
}

void flush(Context& c) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  flush_pending(c);
  c.driver->functions.Flush();
  free_deleted(c);
}

void finish(Context& c) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  flush_pending(c);
  c.driver->functions.Finish();
  free_deleted(c);
}

void clear(Context& c, GLbitfield mask) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  constexpr GLbitfield kKnown =
      GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT;
  if (mask & ~kKnown) return raise_error(c, GL_INVALID_VALUE);
  flush_pending(c);
  if (!c.selection.is_rendering()) return;
  if (mask & GL_ACCUM_BUFFER_BIT && has_accumulation_buffer(c)) clear_accumulation(c);
  apply_raster(c);
  c.driver->functions.Clear(mask & ~GLbitfield{GL_ACCUM_BUFFER_BIT});
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglEnable(GLenum cap) { dispatch<enable>(cap, true); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDisable(GLenum cap) { dispatch<enable>(cap, false); }
LEGACY_GL_API GLboolean LEGACY_GL_APIENTRY lglIsEnabled(GLenum cap) {
  return execute_now<is_enabled>(cap);
}
LEGACY_GL_API GLenum LEGACY_GL_APIENTRY lglGetError(void) { return execute_now<get_error>(); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglFlush(void) { execute_now<flush>(); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglFinish(void) { execute_now<finish>(); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglClear(GLbitfield mask) { dispatch<clear>(mask); }
