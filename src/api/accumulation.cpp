// GL 2.1 spec 4.2.3, 4.2.4: glClearAccum, glAccum.
#include <glm/common.hpp>

#include "dlist/dispatch.hpp"
#include "execute/framebuffer.hpp"
#include "record/pending.hpp"
#include "submit/accumulation.hpp"

using namespace legacy_gl;

namespace {

void clear_accum(Context& c, glm::vec4 value) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  c.accumulation.clear_value = glm::clamp(value, -1.0f, 1.0f);
}

bool is_operation(GLenum operation) {
  return operation >= GL_ACCUM && operation <= GL_ADD;  // also LOAD, RETURN, MULT
}

void accum(Context& c, GLenum operation, float value) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  if (!is_operation(operation)) return raise_error(c, GL_INVALID_ENUM);
  if (!has_accumulation_buffer(c)) return raise_error(c, GL_INVALID_OPERATION);
  flush_pending(c);
  accumulate(c, operation, value);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglClearAccum(GLfloat red, GLfloat green, GLfloat blue,
                                                    GLfloat alpha) {
  dispatch<clear_accum>(glm::vec4(red, green, blue, alpha));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglAccum(GLenum op, GLfloat value) {
  dispatch<accum>(op, value);
}
