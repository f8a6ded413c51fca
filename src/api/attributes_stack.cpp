// GL 2.1 spec 6.1.14: glPushAttrib, glPopAttrib, glPushClientAttrib, glPopClientAttrib.
#include "context/attribute_stack.hpp"
#include "dlist/dispatch.hpp"
#include "execute/attribute_stack.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

bool inside(Context& c) {
  if (!c.recorder.inside_begin_end()) return false;
  raise_error(c, GL_INVALID_OPERATION);
  return true;
}

void push_attrib(Context& c, GLbitfield mask) {
  if (inside(c)) return;
  if (!c.attribute_stacks.server.can_push()) return raise_error(c, GL_STACK_OVERFLOW);
  save_attributes(c, mask, c.attribute_stacks.server.next());
  c.attribute_stacks.server.push();
}

void pop_attrib(Context& c) {
  if (inside(c)) return;
  if (!c.attribute_stacks.server.can_pop()) return raise_error(c, GL_STACK_UNDERFLOW);
  restore_attributes(c, c.attribute_stacks.server.pop());
}

void push_client_attrib(Context& c, GLbitfield mask) {
  if (inside(c)) return;
  if (!c.attribute_stacks.client.can_push()) return raise_error(c, GL_STACK_OVERFLOW);
  save_client_attributes(c, mask, c.attribute_stacks.client.next());
  c.attribute_stacks.client.push();
}

void pop_client_attrib(Context& c) {
  if (inside(c)) return;
  if (!c.attribute_stacks.client.can_pop()) return raise_error(c, GL_STACK_UNDERFLOW);
  restore_client_attributes(c, c.attribute_stacks.client.pop());
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglPushAttrib(GLbitfield mask) {
  dispatch<push_attrib>(mask);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPopAttrib(void) { dispatch<pop_attrib>(); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPushClientAttrib(GLbitfield mask) {
  execute_now<push_client_attrib>(mask);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPopClientAttrib(void) { execute_now<pop_client_attrib>(); }
