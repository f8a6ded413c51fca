#include "gl/error_cases.hpp"

#include "gl/any_values.hpp"

namespace legacy_gl::test {

namespace {

void nothing(const GlFunctions&) {}

// Setups: the state in which the next push overflows.
template <typename Push>
void push_to_limit(const GlFunctions& gl, GLenum max_depth_name, GLint depth, Push push) {
  GLint max_depth = 0;
  gl.GetIntegerv(max_depth_name, &max_depth);
  for (; depth < max_depth; ++depth) push();
}
void push_matrix_to_limit(const GlFunctions& gl, GLenum mode, GLenum max_depth_name) {
  gl.MatrixMode(mode);
  push_to_limit(gl, max_depth_name, 1, gl.PushMatrix);
}
void push_attrib_to_limit(const GlFunctions& gl) {
  push_to_limit(gl, GL_MAX_ATTRIB_STACK_DEPTH, 0, [&gl] { gl.PushAttrib(GL_CURRENT_BIT); });
}
void push_client_attrib_to_limit(const GlFunctions& gl) {
  push_to_limit(gl, GL_MAX_CLIENT_ATTRIB_STACK_DEPTH, 0,
                [&gl] { gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT); });
}

// Objects with a name of their own, bound.
void new_buffer(const GlFunctions& gl, GLenum target, GLsizeiptr size) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, size, memory, GL_STATIC_DRAW);
}
void new_mapped_buffer(const GlFunctions& gl, GLenum target) {
  new_buffer(gl, target, 64);
  gl.MapBuffer(target, GL_READ_WRITE);
}
[[maybe_unused]] GLuint new_query(const GlFunctions& gl) {
  GLuint query = 0;
  gl.GenQueries(1, &query);
  return query;
}

void start_selection(const GlFunctions& gl) {
  static GLuint hits[16];
  gl.SelectBuffer(16, hits);
  gl.RenderMode(GL_SELECT);
}

void start_feedback(const GlFunctions& gl) {
  static GLfloat values[16];
  gl.FeedbackBuffer(16, GL_2D, values);
  gl.RenderMode(GL_FEEDBACK);
}

constexpr GLuint name_1[] = {1};
const void* const index_arrays[] = {memory};
const GLubyte* const pixels = kBytes.data();

}  // namespace

const std::vector<ErrorCase>& error_cases() {
  static const std::vector<ErrorCase> cases = {
#include "gl/error_cases.inc"
  };
  return cases;
}

const std::vector<ValidCall>& calls_inside_begin_end() {
  static const std::vector<ValidCall> calls = {
#include "gl/calls_inside_begin_end.inc"
  };
  return calls;
}

}  // namespace legacy_gl::test
