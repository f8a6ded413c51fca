// GL 2.1 spec 2.9: buffer objects. No display list holds them (5.4).
#include "dlist/dispatch.hpp"
#include "driver/driver_objects.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

bool inside(Context& c) {
  if (!c.recorder.inside_begin_end()) return false;
  raise_error(c, GL_INVALID_OPERATION);
  return true;
}

/// Where the target's binding is kept; nullptr for an enum that is no target.
BufferPointer* binding(Context& c, GLenum target) {
  switch (target) {
    case GL_ARRAY_BUFFER: return &c.arrays.array_buffer;
    case GL_ELEMENT_ARRAY_BUFFER: return &c.arrays.element_buffer;
    default: return nullptr;
  }
}

/// The object bound to the target; nullptr after raising the error that there is none.
BufferObject* bound_buffer(Context& c, GLenum target) {
  if (inside(c)) return nullptr;
  const BufferPointer* const bound = binding(c, target);
  if (!bound) {
    raise_error(c, GL_INVALID_ENUM);
    return nullptr;
  }
  if (!*bound) raise_error(c, GL_INVALID_OPERATION);
  return bound->get();
}

bool is_usage(GLenum usage) {
  switch (usage) {
    case GL_STREAM_DRAW:
    case GL_STREAM_READ:
    case GL_STREAM_COPY:
    case GL_STATIC_DRAW:
    case GL_STATIC_READ:
    case GL_STATIC_COPY:
    case GL_DYNAMIC_DRAW:
    case GL_DYNAMIC_READ:
    case GL_DYNAMIC_COPY: return true;
    default: return false;
  }
}

bool inside_store(const BufferObject& buffer, GLintptr offset, GLsizeiptr size) {
  return offset >= 0 && size >= 0 && offset <= buffer.size && size <= buffer.size - offset;
}

void gen_buffers(Context& c, GLsizei n, GLuint* names) {
  if (inside(c)) return;
  if (n < 0) return raise_error(c, GL_INVALID_VALUE);
  if (names) c.driver->buffers.generate(n, names);
}

void bind_buffer(Context& c, GLenum target, GLuint name) {
  if (inside(c)) return;
  BufferPointer* const bound = binding(c, target);
  if (!bound) return raise_error(c, GL_INVALID_ENUM);
  *bound = name ? c.driver->buffers.find_or_create(name) : nullptr;
}

/// Bindings of this context to a buffer that is deleted become 0.
void unbind(Context& c, const BufferPointer& buffer) {
  if (c.arrays.array_buffer == buffer) c.arrays.array_buffer = nullptr;
  if (c.arrays.element_buffer == buffer) c.arrays.element_buffer = nullptr;
  for (ClientArray& array : c.arrays.arrays)
    if (array.buffer == buffer) {
      array.buffer = nullptr;
      array.buffer_deleted = true;
    }
}

void delete_buffers(Context& c, GLsizei n, const GLuint* names) {
  if (inside(c)) return;
  if (n < 0) return raise_error(c, GL_INVALID_VALUE);
  if (!names) return;
  for (GLsizei i = 0; i < n; ++i) {
    if (names[i] == 0) continue;
    if (const BufferPointer buffer = c.driver->buffers.find(names[i])) unbind(c, buffer);
    c.driver->delete_buffer(names[i]);
  }
}

GLboolean is_buffer(Context& c, GLuint name) {
  if (inside(c)) return GL_FALSE;
  return c.driver->buffers.find(name) ? GL_TRUE : GL_FALSE;
}

void buffer_data(Context& c, GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  if (inside(c)) return;
  if (!binding(c, target) || !is_usage(usage)) return raise_error(c, GL_INVALID_ENUM);
  if (size < 0) return raise_error(c, GL_INVALID_VALUE);
  BufferObject* const buffer = bound_buffer(c, target);
  if (!buffer) return;
  if (!c.driver->buffers.set_data(*buffer, size, data, usage)) raise_error(c, GL_OUT_OF_MEMORY);
}

void buffer_sub_data(Context& c, GLenum target, GLintptr offset, GLsizeiptr size,
                     const void* data) {
  BufferObject* const buffer = bound_buffer(c, target);
  if (!buffer) return;
  if (!inside_store(*buffer, offset, size)) return raise_error(c, GL_INVALID_VALUE);
  if (buffer->mapped) return raise_error(c, GL_INVALID_OPERATION);
  if (size && data) c.driver->buffers.set_sub_data(*buffer, offset, size, data);
}

void get_buffer_sub_data(Context& c, GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
  BufferObject* const buffer = bound_buffer(c, target);
  if (!buffer) return;
  if (!inside_store(*buffer, offset, size)) return raise_error(c, GL_INVALID_VALUE);
  if (buffer->mapped) return raise_error(c, GL_INVALID_OPERATION);
  if (data && !c.driver->buffers.get_sub_data(*buffer, offset, size, data))
    raise_error(c, GL_OUT_OF_MEMORY);
}

void* map_buffer(Context& c, GLenum target, GLenum access) {
  BufferObject* const buffer = bound_buffer(c, target);
  if (!buffer) return nullptr;
  if (access != GL_READ_ONLY && access != GL_WRITE_ONLY && access != GL_READ_WRITE) {
    raise_error(c, GL_INVALID_ENUM);
    return nullptr;
  }
  if (buffer->mapped || buffer->size == 0) {
    raise_error(c, GL_INVALID_OPERATION);
    return nullptr;
  }
  void* const pointer = c.driver->buffers.map(*buffer, access);
  if (!pointer) raise_error(c, GL_OUT_OF_MEMORY);
  return pointer;
}

GLboolean unmap_buffer(Context& c, GLenum target) {
  BufferObject* const buffer = bound_buffer(c, target);
  if (!buffer) return GL_FALSE;
  if (!buffer->mapped) {
    raise_error(c, GL_INVALID_OPERATION);
    return GL_FALSE;
  }
  return c.driver->buffers.unmap(*buffer) ? GL_TRUE : GL_FALSE;
}

void get_buffer_parameter(Context& c, GLenum target, GLenum name, GLint* value) {
  const BufferObject* const buffer = bound_buffer(c, target);
  if (!buffer || !value) return;
  switch (name) {
    case GL_BUFFER_SIZE: *value = static_cast<GLint>(buffer->size); break;
    case GL_BUFFER_USAGE: *value = static_cast<GLint>(buffer->usage); break;
    case GL_BUFFER_ACCESS: *value = static_cast<GLint>(buffer->access); break;
    case GL_BUFFER_MAPPED: *value = buffer->mapped ? GL_TRUE : GL_FALSE; break;
    default: raise_error(c, GL_INVALID_ENUM);
  }
}

void get_buffer_pointer(Context& c, GLenum target, GLenum name, void** pointer) {
  const BufferObject* const buffer = bound_buffer(c, target);
  if (!buffer) return;
  if (name != GL_BUFFER_MAP_POINTER) return raise_error(c, GL_INVALID_ENUM);
  if (pointer) *pointer = buffer->mapped;
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglGenBuffers(GLsizei n, GLuint* buffers) {
  execute_now<gen_buffers>(n, buffers);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglBindBuffer(GLenum target, GLuint buffer) {
  execute_now<bind_buffer>(target, buffer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglDeleteBuffers(GLsizei n, const GLuint* buffers) {
  execute_now<delete_buffers>(n, buffers);
}
LEGACY_GL_API GLboolean LEGACY_GL_APIENTRY lglIsBuffer(GLuint buffer) {
  return execute_now<is_buffer>(buffer);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglBufferData(GLenum target, GLsizeiptr size,
                                                    const void* data, GLenum usage) {
  execute_now<buffer_data>(target, size, data, usage);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglBufferSubData(GLenum target, GLintptr offset,
                                                       GLsizeiptr size, const void* data) {
  execute_now<buffer_sub_data>(target, offset, size, data);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetBufferSubData(GLenum target, GLintptr offset,
                                                          GLsizeiptr size, void* data) {
  execute_now<get_buffer_sub_data>(target, offset, size, data);
}
LEGACY_GL_API void* LEGACY_GL_APIENTRY lglMapBuffer(GLenum target, GLenum access) {
  return execute_now<map_buffer>(target, access);
}
LEGACY_GL_API GLboolean LEGACY_GL_APIENTRY lglUnmapBuffer(GLenum target) {
  return execute_now<unmap_buffer>(target);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetBufferParameteriv(GLenum target, GLenum pname,
                                                              GLint* params) {
  execute_now<get_buffer_parameter>(target, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetBufferPointerv(GLenum target, GLenum pname,
                                                           void** params) {
  execute_now<get_buffer_pointer>(target, pname, params);
}
