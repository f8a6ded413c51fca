#include "execute/begin_end.hpp"
#include "record/pending.hpp"

namespace legacy_gl::execute {

void begin(Context& context, GLenum mode) {
  if (context.recorder.inside_begin_end()) return raise_error(context, GL_INVALID_OPERATION);
  if (mode > GL_POLYGON) return raise_error(context, GL_INVALID_ENUM);
  context.recorder.begin(context, mode);
}

void end(Context& context) {
  if (!context.recorder.inside_begin_end()) return raise_error(context, GL_INVALID_OPERATION);
  context.recorder.end(context);
}

}  // namespace legacy_gl::execute
