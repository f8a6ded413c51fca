// GL 2.1 spec 2.8: what the client arrays are. No display list holds these commands (5.4), but for
// glActiveTexture.
#include "state/client_arrays.hpp"

#include <cstdint>
#include <initializer_list>

#include "dlist/dispatch.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

bool inside(Context& c) {
  if (!c.recorder.inside_begin_end()) return false;
  raise_error(c, GL_INVALID_OPERATION);
  return true;
}

bool one_of(GLenum type, std::initializer_list<GLenum> types) {
  for (const GLenum candidate : types)
    if (type == candidate) return true;
  return false;
}

/// Table 2.4: sizes and types that each array takes.
bool takes_size(unsigned array, GLint size) {
  switch (array) {
    case kVertexArray: return size >= 2 && size <= 4;
    case kColorArray: return size == 3 || size == 4;
    case kSecondaryColorArray: return size == 3;
    case kNormalArray:
    case kFogCoordArray:
    case kIndexArray:
    case kEdgeFlagArray: return true;  // the size is not a parameter
    default: return size >= 1 && size <= 4;
  }
}

bool takes_type(unsigned array, GLenum type) {
  switch (array) {
    case kNormalArray: return one_of(type, {GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE});
    case kColorArray:
    case kSecondaryColorArray: return type_size(type) != 0;
    case kFogCoordArray: return one_of(type, {GL_FLOAT, GL_DOUBLE});
    case kIndexArray:
      return one_of(type, {GL_UNSIGNED_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE});
    case kEdgeFlagArray: return true;
    default: return one_of(type, {GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE});
  }
}

void point(Context& c, unsigned array, GLint size, GLenum type, GLsizei stride,
           const void* pointer) {
  if (inside(c)) return;
  if (!takes_size(array, size) || stride < 0) return raise_error(c, GL_INVALID_VALUE);
  if (!takes_type(array, type)) return raise_error(c, GL_INVALID_ENUM);
  ClientArray& target = c.arrays.arrays[array];
  target.size = size;
  target.type = type;
  target.stride = stride;
  target.pointer = pointer;
  target.buffer = c.arrays.array_buffer;
  target.buffer_deleted = false;
}

void point_texcoord(Context& c, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  point(c, kTexCoordArray + c.client_active_texture, size, type, stride, pointer);
}

void enable_client_state(Context& c, GLenum name, bool enabled) {
  if (inside(c)) return;
  const unsigned array = array_index(name, c.client_active_texture);
  if (array == kArrayCount) return raise_error(c, GL_INVALID_ENUM);
  c.arrays.arrays[array].enabled = enabled;
}

void client_active_texture(Context& c, GLenum texture) {
  if (inside(c)) return;
  const GLenum unit = texture - GL_TEXTURE0;
  if (unit >= kMaxTextureUnits) return raise_error(c, GL_INVALID_ENUM);
  c.client_active_texture = unit;
}

void active_texture(Context& c, GLenum texture) {
  if (inside(c)) return;
  const GLenum unit = texture - GL_TEXTURE0;
  if (unit >= kMaxTextureUnits) return raise_error(c, GL_INVALID_ENUM);
  c.active_texture = unit;
}

void interleaved_arrays(Context& c, GLenum format_name, GLsizei stride, const void* pointer) {
  if (inside(c)) return;
  const InterleavedFormat* const format = find_interleaved_format(format_name);
  if (!format) return raise_error(c, GL_INVALID_ENUM);
  if (stride < 0) return raise_error(c, GL_INVALID_VALUE);
  const GLsizei actual_stride = stride ? stride : static_cast<GLsizei>(format->stride);
  const auto set = [&](unsigned array, unsigned size, GLenum type, unsigned offset) {
    c.arrays.arrays[array].enabled = size != 0;
    if (size)
      // An offset into a buffer object is no address to count from: hence the integer.
      point(c, array, static_cast<GLint>(size), type, actual_stride,
            reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(pointer) + offset));
  };
  c.arrays.arrays[kEdgeFlagArray].enabled = false;
  c.arrays.arrays[kIndexArray].enabled = false;
  c.arrays.arrays[kSecondaryColorArray].enabled = false;
  c.arrays.arrays[kFogCoordArray].enabled = false;
  set(kTexCoordArray + c.client_active_texture, format->texcoord_size, GL_FLOAT, 0);
  set(kColorArray, format->color_size, format->color_type, format->color_offset);
  set(kNormalArray, format->has_normal ? 3 : 0, GL_FLOAT, format->normal_offset);
  set(kVertexArray, format->vertex_size, GL_FLOAT, format->vertex_offset);
}

unsigned pointer_index(GLenum name, unsigned client_unit) {
  switch (name) {
    case GL_VERTEX_ARRAY_POINTER: return kVertexArray;
    case GL_NORMAL_ARRAY_POINTER: return kNormalArray;
    case GL_COLOR_ARRAY_POINTER: return kColorArray;
    case GL_SECONDARY_COLOR_ARRAY_POINTER: return kSecondaryColorArray;
    case GL_FOG_COORD_ARRAY_POINTER: return kFogCoordArray;
    case GL_INDEX_ARRAY_POINTER: return kIndexArray;
    case GL_EDGE_FLAG_ARRAY_POINTER: return kEdgeFlagArray;
    case GL_TEXTURE_COORD_ARRAY_POINTER: return kTexCoordArray + client_unit;
    default: return kArrayCount;
  }
}

// GL 2.1 spec 6.1.11
void get_pointer(Context& c, GLenum name, void** pointer) {
  if (inside(c)) return;
  const unsigned array = pointer_index(name, c.client_active_texture);
  const bool feedback = name == GL_FEEDBACK_BUFFER_POINTER;
  const bool selection = name == GL_SELECTION_BUFFER_POINTER;
  if (array == kArrayCount && !feedback && !selection) return raise_error(c, GL_INVALID_ENUM);
  if (!pointer) return;
  if (feedback) *pointer = c.feedback.buffer;
  else if (selection) *pointer = c.selection.buffer;
  else *pointer = const_cast<void*>(c.arrays.arrays[array].pointer);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglVertexPointer(GLint size, GLenum type, GLsizei stride,
                                                       const void* pointer) {
  execute_now<point>(unsigned{kVertexArray}, size, type, stride, pointer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglNormalPointer(GLenum type, GLsizei stride,
                                                       const void* pointer) {
  execute_now<point>(unsigned{kNormalArray}, 3, type, stride, pointer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglColorPointer(GLint size, GLenum type, GLsizei stride,
                                                      const void* pointer) {
  execute_now<point>(unsigned{kColorArray}, size, type, stride, pointer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglSecondaryColorPointer(GLint size, GLenum type,
                                                               GLsizei stride,
                                                               const void* pointer) {
  execute_now<point>(unsigned{kSecondaryColorArray}, size, type, stride, pointer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglFogCoordPointer(GLenum type, GLsizei stride,
                                                         const void* pointer) {
  execute_now<point>(unsigned{kFogCoordArray}, 1, type, stride, pointer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglIndexPointer(GLenum type, GLsizei stride,
                                                      const void* pointer) {
  execute_now<point>(unsigned{kIndexArray}, 1, type, stride, pointer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEdgeFlagPointer(GLsizei stride, const void* pointer) {
  execute_now<point>(unsigned{kEdgeFlagArray}, 1, GLenum{GL_UNSIGNED_BYTE}, stride, pointer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexCoordPointer(GLint size, GLenum type, GLsizei stride,
                                                         const void* pointer) {
  execute_now<point_texcoord>(size, type, stride, pointer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglEnableClientState(GLenum array) {
  execute_now<enable_client_state>(array, true);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDisableClientState(GLenum array) {
  execute_now<enable_client_state>(array, false);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglClientActiveTexture(GLenum texture) {
  execute_now<client_active_texture>(texture);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglActiveTexture(GLenum texture) {
  dispatch<active_texture>(texture);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglInterleavedArrays(GLenum format, GLsizei stride,
                                                           const void* pointer) {
  execute_now<interleaved_arrays>(format, stride, pointer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetPointerv(GLenum pname, void** params) {
  execute_now<get_pointer>(pname, params);
}
