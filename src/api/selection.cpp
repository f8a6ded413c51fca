// GL 2.1 spec 5.2, 5.3: selection and feedback.
#include "dlist/dispatch.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

bool inside(Context& c) {
  if (!c.recorder.inside_begin_end()) return false;
  raise_error(c, GL_INVALID_OPERATION);
  return true;
}

/// What was recorded hits under the names of now.
SelectionState& settled(Context& c) {
  flush_pending(c);
  c.selection.write_hit();
  return c.selection;
}

void init_names(Context& c) {
  if (inside(c) || !c.selection.is_selecting()) return;
  settled(c).name_count = 0;
}

void load_name(Context& c, GLuint name) {
  if (inside(c) || !c.selection.is_selecting()) return;
  if (c.selection.name_count == 0) return raise_error(c, GL_INVALID_OPERATION);
  SelectionState& selection = settled(c);
  selection.names[selection.name_count - 1] = name;
}

void push_name(Context& c, GLuint name) {
  if (inside(c) || !c.selection.is_selecting()) return;
  if (c.selection.name_count == SelectionState::kMaxNames) return raise_error(c, GL_STACK_OVERFLOW);
  SelectionState& selection = settled(c);
  selection.names[selection.name_count++] = name;
}

void pop_name(Context& c) {
  if (inside(c) || !c.selection.is_selecting()) return;
  if (c.selection.name_count == 0) return raise_error(c, GL_STACK_UNDERFLOW);
  --settled(c).name_count;
}

void select_buffer(Context& c, GLsizei size, GLuint* buffer) {
  if (inside(c)) return;
  if (size < 0) return raise_error(c, GL_INVALID_VALUE);
  if (c.selection.is_selecting()) return raise_error(c, GL_INVALID_OPERATION);
  c.selection.buffer = buffer;
  c.selection.buffer_size = buffer ? static_cast<std::size_t>(size) : 0;
}

bool is_feedback_type(GLenum type) {
  return type == GL_2D || type == GL_3D || type == GL_3D_COLOR || type == GL_3D_COLOR_TEXTURE ||
         type == GL_4D_COLOR_TEXTURE;
}

void feedback_buffer(Context& c, GLsizei size, GLenum type, GLfloat* buffer) {
  if (inside(c)) return;
  if (size < 0) return raise_error(c, GL_INVALID_VALUE);
  if (!is_feedback_type(type)) return raise_error(c, GL_INVALID_ENUM);
  if (c.selection.is_feeding_back()) return raise_error(c, GL_INVALID_OPERATION);
  c.feedback.type = type;
  c.feedback.buffer = buffer;
  c.feedback.buffer_size = buffer ? static_cast<std::size_t>(size) : 0;
}

void pass_through(Context& c, float token) {
  if (inside(c) || !c.selection.is_feeding_back()) return;
  flush_pending(c);
  c.feedback.put_token(GL_PASS_THROUGH_TOKEN);
  c.feedback.put(token);
}

GLint render_mode(Context& c, GLenum mode) {
  if (inside(c)) return 0;
  if (mode != GL_RENDER && mode != GL_SELECT && mode != GL_FEEDBACK) {
    raise_error(c, GL_INVALID_ENUM);
    return 0;
  }
  if ((mode == GL_FEEDBACK && c.feedback.buffer_size == 0) ||
      (mode == GL_SELECT && c.selection.buffer_size == 0)) {
    raise_error(c, GL_INVALID_OPERATION);
    return 0;
  }
  flush_pending(c);
  const GLint result = c.selection.is_selecting()      ? c.selection.finish()
                       : c.selection.is_feeding_back() ? c.feedback.finish()
                                                       : 0;
  c.selection.render_mode = mode;
  return result;
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglInitNames(void) { dispatch<init_names>(); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLoadName(GLuint name) { dispatch<load_name>(name); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPushName(GLuint name) { dispatch<push_name>(name); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPopName(void) { dispatch<pop_name>(); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglSelectBuffer(GLsizei size, GLuint* buffer) {
  execute_now<select_buffer>(size, buffer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglFeedbackBuffer(GLsizei size, GLenum type,
                                                        GLfloat* buffer) {
  execute_now<feedback_buffer>(size, type, buffer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPassThrough(GLfloat token) {
  dispatch<pass_through>(token);
}
LEGACY_GL_API GLint LEGACY_GL_APIENTRY lglRenderMode(GLenum mode) {
  return execute_now<render_mode>(mode);
}
