// GL 2.1 spec 4.2.1, 4.3.2: glDrawBuffer, glReadBuffer.
#include "dlist/dispatch.hpp"
#include "state/framebuffer.hpp"

using namespace legacy_gl;

namespace {

bool inside(Context& c) {
  if (!c.recorder.inside_begin_end()) return false;
  raise_error(c, GL_INVALID_OPERATION);
  return true;
}

void draw_buffer(Context& c, GLenum mode) {
  if (inside(c)) return;
  if (const GLenum error = draw_buffer_error(c, mode)) return raise_error(c, error);
  set_draw_buffer(c, mode);
}

void read_buffer(Context& c, GLenum mode) {
  if (inside(c)) return;
  if (const GLenum error = read_buffer_error(c, mode)) return raise_error(c, error);
  set_read_buffer(c, mode);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglDrawBuffer(GLenum buf) { dispatch<draw_buffer>(buf); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglReadBuffer(GLenum src) { dispatch<read_buffer>(src); }
