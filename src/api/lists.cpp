// GL 2.1 spec 5.4: display lists.
#include <cmath>
#include <cstdint>
#include <utility>

#include "dlist/dispatch.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

bool in_begin_end(Context& c) {
  if (!c.recorder.inside_begin_end()) return false;
  raise_error(c, GL_INVALID_OPERATION);
  return true;
}

void new_list(Context& c, GLuint name, GLenum mode) {
  if (in_begin_end(c)) return;
  if (name == 0) return raise_error(c, GL_INVALID_VALUE);
  if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE) return raise_error(c, GL_INVALID_ENUM);
  if (c.list_modes.compiling) return raise_error(c, GL_INVALID_OPERATION);
  c.lists.compiling_list = std::make_shared<DisplayList>();
  c.list_modes.compiling = true;
  c.lists.failed = false;
  c.list_modes.mode = mode;
  c.list_modes.compiling_name = name;
  c.lists.welder = {};
  update_direct_context();
}

void end_list(Context& c) {
  if (in_begin_end(c)) return;
  if (!c.list_modes.compiling) return raise_error(c, GL_INVALID_OPERATION);
  const std::shared_ptr<DisplayList> list = std::exchange(c.lists.compiling_list, nullptr);
  const GLuint name = std::exchange(c.list_modes.compiling_name, 0);
  c.list_modes.compiling = false;
  c.list_modes.mode = 0;
  c.lists.welder = {};
  update_direct_context();
  if (std::exchange(c.lists.failed, false)) return;
  list->finish();
  c.lists.names->store(name, list);
}

/// What a list executes is not recorded again: GL_COMPILE_AND_EXECUTE records the call itself.
class ListCall {
 public:
  explicit ListCall(Context& context)
      : context_(context), compiling_(std::exchange(context.list_modes.compiling, false)) {
    if (compiling_) update_direct_context();
    ++context_.list_modes.nesting;
  }
  ~ListCall() {
    --context_.list_modes.nesting;
    context_.list_modes.compiling = compiling_;
    if (compiling_) update_direct_context();
  }
  ListCall(const ListCall&) = delete;
  ListCall& operator=(const ListCall&) = delete;

 private:
  Context& context_;
  const bool compiling_;
};

void call_list(Context& c, GLuint name) {
  if (c.list_modes.nesting == ListModes::kMaxNesting) return;
  const std::shared_ptr<const DisplayList> list = c.lists.names->find(name);
  if (!list) return;
  const ListCall call(c);
  list->execute(c);
}

void list_base(Context& c, GLuint base) {
  if (in_begin_end(c)) return;
  c.list_modes.base = base;
}

/// Truncated to an integer; a float that no integer holds is no offset.
GLuint float_offset(GLfloat offset) {
  return std::abs(offset) < 2147483648.0f ? static_cast<GLuint>(static_cast<GLint>(offset)) : 0;
}

/// The i-th offset of glCallLists; -1 for a type it does not take.
std::int64_t list_offset(GLenum type, const void* lists, GLsizei i) {
  const auto* const bytes = static_cast<const GLubyte*>(lists);
  const auto at = static_cast<std::size_t>(i);
  switch (type) {
    case GL_BYTE: return static_cast<GLuint>(static_cast<const GLbyte*>(lists)[at]);
    case GL_UNSIGNED_BYTE: return bytes[at];
    case GL_SHORT: return static_cast<GLuint>(static_cast<const GLshort*>(lists)[at]);
    case GL_UNSIGNED_SHORT: return static_cast<const GLushort*>(lists)[at];
    case GL_INT: return static_cast<GLuint>(static_cast<const GLint*>(lists)[at]);
    case GL_UNSIGNED_INT: return static_cast<const GLuint*>(lists)[at];
    case GL_FLOAT: return float_offset(static_cast<const GLfloat*>(lists)[at]);
    case GL_2_BYTES: return bytes[2 * at] * 256 + bytes[2 * at + 1];
    case GL_3_BYTES: return bytes[3 * at] * 65536 + bytes[3 * at + 1] * 256 + bytes[3 * at + 2];
    case GL_4_BYTES:
      return std::int64_t{bytes[4 * at]} << 24 | bytes[4 * at + 1] << 16 | bytes[4 * at + 2] << 8 |
             bytes[4 * at + 3];
    default: return -1;
  }
}

bool is_list_type(GLenum type) {
  return (type >= GL_BYTE && type <= GL_FLOAT) || (type >= GL_2_BYTES && type <= GL_4_BYTES);
}

void call_list_at_base(Context& c, GLuint offset) { call_list(c, c.list_modes.base + offset); }

GLuint gen_lists(Context& c, GLsizei range) {
  if (in_begin_end(c)) return 0;
  if (range < 0) {
    raise_error(c, GL_INVALID_VALUE);
    return 0;
  }
  if (range == 0) return 0;
  static const auto empty = std::make_shared<const DisplayList>();
  return c.lists.names->generate(static_cast<GLuint>(range), empty);
}

void delete_lists(Context& c, GLuint list, GLsizei range) {
  if (in_begin_end(c)) return;
  if (range < 0) return raise_error(c, GL_INVALID_VALUE);
  c.lists.names->erase(list, static_cast<GLuint>(range));
}

GLboolean is_list(Context& c, GLuint list) {
  if (in_begin_end(c)) return GL_FALSE;
  return c.lists.names->contains(list) ? GL_TRUE : GL_FALSE;
}

void call_lists_error(Context& c, GLenum error) { raise_error(c, error); }

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglNewList(GLuint list, GLenum mode) {
  execute_now<new_list>(list, mode);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEndList(void) { execute_now<end_list>(); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCallList(GLuint list) { dispatch<call_list>(list); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCallLists(GLsizei n, GLenum type, const void* lists) {
  if (!is_list_type(type)) return dispatch<call_lists_error>(GLenum{GL_INVALID_ENUM});
  if (n < 0) return dispatch<call_lists_error>(GLenum{GL_INVALID_VALUE});
  for (GLsizei i = 0; i < n; ++i)
    dispatch<call_list_at_base>(static_cast<GLuint>(list_offset(type, lists, i)));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglListBase(GLuint base) { dispatch<list_base>(base); }
LEGACY_GL_API GLuint LEGACY_GL_APIENTRY lglGenLists(GLsizei range) {
  return execute_now<gen_lists>(range);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDeleteLists(GLuint list, GLsizei range) {
  execute_now<delete_lists>(list, range);
}
LEGACY_GL_API GLboolean LEGACY_GL_APIENTRY lglIsList(GLuint list) {
  return execute_now<is_list>(list);
}
