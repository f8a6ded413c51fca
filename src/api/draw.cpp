// GL 2.1 spec 2.8: drawing from client arrays. In a display list they are dereferenced when
// compiled (5.4).
#include "api/attributes.hpp"
#include "dlist/dispatch.hpp"
#include "dlist/list_arrays.hpp"
#include "driver/driver_objects.hpp"
#include "record/pending.hpp"
#include "submit/arrays.hpp"

using namespace legacy_gl;

namespace {

bool is_element_type(GLenum type) {
  return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT;
}

/// The error of a draw whose arguments would be fine inside no Begin/End; GL_NO_ERROR: it may be
/// drawn.
GLenum draw_error(Context& c, GLenum mode, bool elements) {
  if (mode > GL_POLYGON) return GL_INVALID_ENUM;
  return draws_from_mapped_buffer(c, elements) ? GLenum{GL_INVALID_OPERATION} : GLenum{GL_NO_ERROR};
}

/// The list that is being compiled raises errors when it is played.
void raise(Context& c, GLenum error) { raise_error(c, error); }

void draw_nothing(Context& c) {
  if (c.recorder.inside_begin_end()) raise_error(c, GL_INVALID_OPERATION);
}

bool refused(Context& c, GLenum error) {
  if (!c.list_modes.compiling && c.recorder.inside_begin_end()) error = GL_INVALID_OPERATION;
  if (error == GL_NO_ERROR) return false;
  dispatch<raise>(error);
  return true;
}

void draw(Context& c, const ArrayDraw& arguments) {
  if (arguments.count == 0) return;
  if (c.list_modes.compiling) {
    // The list may be called inside Begin/End, where the draw is an error whatever it draws.
    if (!c.arrays.arrays[kVertexArray].enabled) return dispatch<draw_nothing>();
    ReadableArrays readable(c);
    if (arguments.is_indexed())
      record_elements(c, readable.views(), arguments.mode, readable.elements(arguments));
    else record_arrays(c, readable.views(), arguments.mode, arguments.first, arguments.count);
    if (c.list_modes.mode == GL_COMPILE) return;
  }
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  draw_arrays(c, arguments);
}

void draw_range(Context& c, GLenum mode, GLint first, GLsizei count) {
  draw(c, {mode, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(count), 0, nullptr});
}

void draw_listed(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices) {
  draw(c, {mode, 0, static_cast<std::uint32_t>(count), type, indices});
}

GLenum arrays_error(Context& c, GLenum mode, GLint first, GLsizei count) {
  if (const GLenum error = draw_error(c, mode, false)) return error;
  // A negative first is undefined; the specification recommends this error.
  return first < 0 || count < 0 ? GLenum{GL_INVALID_VALUE} : GLenum{GL_NO_ERROR};
}

GLenum elements_error(Context& c, GLenum mode, GLsizei count, GLenum type) {
  if (const GLenum error = draw_error(c, mode, true)) return error;
  if (!is_element_type(type)) return GL_INVALID_ENUM;
  return count < 0 ? GLenum{GL_INVALID_VALUE} : GLenum{GL_NO_ERROR};
}

void draw_arrays_call(Context& c, GLenum mode, GLint first, GLsizei count) {
  if (!refused(c, arrays_error(c, mode, first, count))) draw_range(c, mode, first, count);
}

void draw_elements_call(Context& c, GLenum mode, GLsizei count, GLenum type, const void* indices) {
  if (!refused(c, elements_error(c, mode, count, type))) draw_listed(c, mode, count, type, indices);
}

void draw_range_elements_call(Context& c, GLenum mode, GLuint start, GLuint end, GLsizei count,
                              GLenum type, const void* indices) {
  GLenum error = elements_error(c, mode, count, type);
  if (error == GL_NO_ERROR && end < start) error = GL_INVALID_VALUE;
  if (!refused(c, error)) draw_listed(c, mode, count, type, indices);
}

void multi_draw_arrays_call(Context& c, GLenum mode, const GLint* first, const GLsizei* count,
                            GLsizei draws) {
  GLenum error = draws < 0 ? GLenum{GL_INVALID_VALUE} : draw_error(c, mode, false);
  for (GLsizei i = 0; i < draws && error == GL_NO_ERROR; ++i)
    error = arrays_error(c, mode, first[i], count[i]);
  if (refused(c, error)) return;
  for (GLsizei i = 0; i < draws; ++i) draw_range(c, mode, first[i], count[i]);
}

void multi_draw_elements_call(Context& c, GLenum mode, const GLsizei* count, GLenum type,
                              const void* const* indices, GLsizei draws) {
  GLenum error = draws < 0 ? GLenum{GL_INVALID_VALUE} : elements_error(c, mode, 0, type);
  for (GLsizei i = 0; i < draws && error == GL_NO_ERROR; ++i)
    error = elements_error(c, mode, count[i], type);
  if (refused(c, error)) return;
  for (GLsizei i = 0; i < draws; ++i) draw_listed(c, mode, count[i], type, indices[i]);
}

/// The same as the attribute commands for element i of every enabled array, the vertex last.
void array_element_call(Context& c, GLint i) {
  GLenum error = i < 0 ? GLenum{GL_INVALID_VALUE} : GLenum{GL_NO_ERROR};
  if (draws_from_mapped_buffer(c, false)) error = GL_INVALID_OPERATION;
  if (error != GL_NO_ERROR) return dispatch<raise>(error);
  ReadableArrays readable(c);
  const ArrayViews& views = readable.views();
  std::array<float, 4> v;
  const auto read = [&](unsigned array) {
    const ArrayView& view = views[array];
    if (!view.data) return false;
    view.read(find_reader(view.type, is_normalised(array), view.size, 4),
              static_cast<std::uint32_t>(i), 1, v.data(), 4, 4);
    return true;
  };
  for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
    if (read(kTexCoordArray + unit)) texcoord4(unit, v[0], v[1], v[2], v[3]);
  if (read(kNormalArray)) normal3(v[0], v[1], v[2]);
  if (read(kColorArray)) color4(v[0], v[1], v[2], v[3]);
  if (read(kSecondaryColorArray)) secondary_color3(v[0], v[1], v[2]);
  if (read(kFogCoordArray)) fog_coord(v[0]);
  if (read(kIndexArray)) index(v[0]);
  if (read(kEdgeFlagArray)) edge_flag(v[0] != 0);
  if (!read(kVertexArray)) return;
  if (views[kVertexArray].size == 4) vertex4(v[0], v[1], v[2], v[3]);
  else vertex3(v[0], v[1], v[2]);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglArrayElement(GLint i) {
  execute_now<array_element_call>(i);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDrawArrays(GLenum mode, GLint first, GLsizei count) {
  execute_now<draw_arrays_call>(mode, first, count);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDrawElements(GLenum mode, GLsizei count, GLenum type,
                                                      const void* indices) {
  execute_now<draw_elements_call>(mode, count, type, indices);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDrawRangeElements(GLenum mode, GLuint start, GLuint end,
                                                           GLsizei count, GLenum type,
                                                           const void* indices) {
  execute_now<draw_range_elements_call>(mode, start, end, count, type, indices);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMultiDrawArrays(GLenum mode, const GLint* first,
                                                         const GLsizei* count, GLsizei drawcount) {
  execute_now<multi_draw_arrays_call>(mode, first, count, drawcount);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMultiDrawElements(GLenum mode, const GLsizei* count,
                                                           GLenum type, const void* const* indices,
                                                           GLsizei drawcount) {
  execute_now<multi_draw_elements_call>(mode, count, type, indices, drawcount);
}
