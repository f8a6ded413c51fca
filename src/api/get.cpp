// GL 2.1 spec 6.1: glGetBooleanv, glGetIntegerv, glGetFloatv, glGetDoublev.
#include "dlist/dispatch.hpp"
#include "execute/queries.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

void store(ValueKind, double value, GLboolean& result) { result = as_boolean(value); }
void store(ValueKind kind, double value, GLint& result) { result = as_integer(kind, value); }
void store(ValueKind, double value, GLfloat& result) { result = static_cast<GLfloat>(value); }
void store(ValueKind, double value, GLdouble& result) { result = value; }

template <typename T>
void get(Context& c, GLenum name, T* results) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  QueryValues values;
  if (!query(c, name, values)) return raise_error(c, GL_INVALID_ENUM);
  if (!results) return;
  for (unsigned i = 0; i < values.count; ++i) store(values.kind, values.values[i], results[i]);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetBooleanv(GLenum pname, GLboolean* data) {
  execute_now<get<GLboolean>>(pname, data);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetIntegerv(GLenum pname, GLint* data) {
  execute_now<get<GLint>>(pname, data);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetFloatv(GLenum pname, GLfloat* data) {
  execute_now<get<GLfloat>>(pname, data);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetDoublev(GLenum pname, GLdouble* data) {
  execute_now<get<GLdouble>>(pname, data);
}
