// GL 2.1 spec 4.1.7, 6.1.12: occlusion queries. A display list holds their begin and end.
#include "dlist/dispatch.hpp"
#include "driver/driver_objects.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

bool refused(Context& c, bool valid, GLenum error) {
  if (c.recorder.inside_begin_end()) {
    raise_error(c, GL_INVALID_OPERATION);
    return true;
  }
  if (!valid) raise_error(c, error);
  return !valid;
}

void gen_queries(Context& c, GLsizei n, GLuint* names) {
  if (refused(c, n >= 0, GL_INVALID_VALUE)) return;
  if (names) c.driver->queries.generate(n, names);
}

void delete_queries(Context& c, GLsizei n, const GLuint* names) {
  if (refused(c, n >= 0, GL_INVALID_VALUE) || !names) return;
  flush_pending(c);  // one of them may be active
  for (GLsizei i = 0; i < n; ++i) c.driver->queries.remove(names[i]);
}

GLboolean is_query(Context& c, GLuint name) {
  if (refused(c, true, 0)) return GL_FALSE;
  return c.driver->queries.exists(name) ? GL_TRUE : GL_FALSE;
}

void begin_query(Context& c, GLenum target, GLuint name) {
  if (refused(c, target == GL_SAMPLES_PASSED, GL_INVALID_ENUM)) return;
  QueryObjects& queries = c.driver->queries;
  if (name == 0 || queries.active()) return raise_error(c, GL_INVALID_OPERATION);
  if (c.driver->functions.is_es())
    diagnose(c, "glBeginQuery: GLES counts no samples; the result is 1 when any passes");
  flush_pending(c);
  queries.begin(name);
}

void end_query(Context& c, GLenum target) {
  if (refused(c, target == GL_SAMPLES_PASSED, GL_INVALID_ENUM)) return;
  if (!c.driver->queries.active()) return raise_error(c, GL_INVALID_OPERATION);
  flush_pending(c);
  c.driver->queries.end();
}

void get_query(Context& c, GLenum target, GLenum name, GLint* value) {
  if (refused(c, target == GL_SAMPLES_PASSED, GL_INVALID_ENUM)) return;
  if (name != GL_CURRENT_QUERY && name != GL_QUERY_COUNTER_BITS)
    return raise_error(c, GL_INVALID_ENUM);
  if (!value) return;
  const QueryObjects& queries = c.driver->queries;
  *value = name == GL_CURRENT_QUERY ? static_cast<GLint>(queries.active()) : queries.counter_bits();
}

template <typename T>
void get_query_object(Context& c, GLuint query, GLenum name, T* value) {
  const QueryObjects& queries = c.driver->queries;
  const bool readable = queries.exists(query) && query != queries.active();
  if (refused(c, readable, GL_INVALID_OPERATION)) return;
  if (name != GL_QUERY_RESULT && name != GL_QUERY_RESULT_AVAILABLE)
    return raise_error(c, GL_INVALID_ENUM);
  if (value) *value = static_cast<T>(queries.result(query, name == GL_QUERY_RESULT_AVAILABLE));
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglGenQueries(GLsizei n, GLuint* ids) {
  execute_now<gen_queries>(n, ids);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDeleteQueries(GLsizei n, const GLuint* ids) {
  execute_now<delete_queries>(n, ids);
}
LEGACY_GL_API GLboolean LEGACY_GL_APIENTRY lglIsQuery(GLuint id) {
  return execute_now<is_query>(id);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglBeginQuery(GLenum target, GLuint id) {
  dispatch<begin_query>(target, id);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEndQuery(GLenum target) { dispatch<end_query>(target); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetQueryiv(GLenum target, GLenum pname, GLint* params) {
  execute_now<get_query>(target, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetQueryObjectiv(GLuint id, GLenum pname, GLint* params) {
  execute_now<get_query_object<GLint>>(id, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetQueryObjectuiv(GLuint id, GLenum pname,
                                                           GLuint* params) {
  execute_now<get_query_object<GLuint>>(id, pname, params);
}
