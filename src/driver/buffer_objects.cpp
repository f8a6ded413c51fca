#include "driver/buffer_objects.hpp"

#include <cstring>

#include "driver/debug_labels.hpp"

namespace legacy_gl {

namespace {

// No draw reads this binding, and no vertex array object remembers it.
constexpr GLenum kTarget = GL_COPY_READ_BUFFER;

GLbitfield map_bits(GLenum access) {
  switch (access) {
    case GL_READ_ONLY: return GL_MAP_READ_BIT;
    case GL_WRITE_ONLY: return GL_MAP_WRITE_BIT;
    default: return GL_MAP_READ_BIT | GL_MAP_WRITE_BIT;
  }
}

}  // namespace

BufferObjects::~BufferObjects() {
  for (const auto& [name, buffer] : objects_)
    if (buffer.driver_name) driver_.DeleteBuffers(1, &buffer.driver_name);
}

void BufferObjects::bind(const BufferObject& buffer) {
  driver_.BindBuffer(kTarget, buffer.driver_name);
}

void BufferObjects::generate(GLsizei count, GLuint* names) {
  for (GLsizei i = 0; i < count; ++i) {
    GLuint name = 0;
    // A name that the application chose itself may be the driver's next: that one is passed over.
    do driver_.GenBuffers(1, &name);
    while (name && objects_.contains(name));
    objects_[name].driver_name = 0;
    names[i] = name;
  }
}

BufferObject& BufferObjects::find_or_create(GLuint name) {
  const auto [at, is_foreign] = objects_.try_emplace(name);
  BufferObject& buffer = at->second;
  if (buffer.driver_name == 0) {
    if (is_foreign) driver_.GenBuffers(1, &buffer.driver_name);
    else buffer.driver_name = name;
    buffer.version = ++last_version_;
  }
  return buffer;
}

BufferObject* BufferObjects::find(GLuint name) {
  const auto at = objects_.find(name);
  return at == objects_.end() || at->second.driver_name == 0 ? nullptr : &at->second;
}

void BufferObjects::remove(GLuint name) {
  const auto at = objects_.find(name);
  if (at == objects_.end()) return;
  const GLuint driver_name = at->second.driver_name ? at->second.driver_name : name;
  driver_.DeleteBuffers(1, &driver_name);
  objects_.erase(at);
}

bool BufferObjects::set_data(BufferObject& buffer, GLsizeiptr size, const void* data,
                             GLenum usage) {
  bind(buffer);
  while (driver_.GetError() != GL_NO_ERROR) {
  }
  driver_.BufferData(kTarget, size, data, usage);
  const bool stored = driver_.GetError() == GL_NO_ERROR;
  if (stored) label(driver_, GL_BUFFER, buffer.driver_name, "buffer object");
  buffer.size = stored ? size : 0;
  buffer.usage = usage;
  buffer.access = GL_READ_WRITE;
  buffer.mapped = nullptr;
  buffer.version = ++last_version_;
  return stored;
}

void BufferObjects::set_sub_data(BufferObject& buffer, GLintptr offset, GLsizeiptr size,
                                 const void* data) {
  bind(buffer);
  driver_.BufferSubData(kTarget, offset, size, data);
  buffer.version = ++last_version_;
}

bool BufferObjects::get_sub_data(BufferObject& buffer, GLintptr offset, GLsizeiptr size,
                                 void* data) {
  if (size == 0) return true;
  bind(buffer);
  const void* const source = driver_.MapBufferRange(kTarget, offset, size, GL_MAP_READ_BIT);
  if (!source) return false;
  std::memcpy(data, source, static_cast<std::size_t>(size));
  return driver_.UnmapBuffer(kTarget) != GL_FALSE;
}

void* BufferObjects::map(BufferObject& buffer, GLenum access) {
  bind(buffer);
  buffer.mapped = driver_.MapBufferRange(kTarget, 0, buffer.size, map_bits(access));
  if (buffer.mapped) buffer.access = access;
  return buffer.mapped;
}

bool BufferObjects::unmap(BufferObject& buffer) {
  bind(buffer);
  if (buffer.access != GL_READ_ONLY) buffer.version = ++last_version_;
  buffer.mapped = nullptr;
  buffer.access = GL_READ_WRITE;
  return driver_.UnmapBuffer(kTarget) != GL_FALSE;
}

const void* BufferObjects::map_for_reading(const BufferObject& buffer) {
  if (buffer.size == 0) return nullptr;
  bind(buffer);
  return driver_.MapBufferRange(kTarget, 0, buffer.size, GL_MAP_READ_BIT);
}

void BufferObjects::unmap_after_reading(const BufferObject& buffer) {
  bind(buffer);
  driver_.UnmapBuffer(kTarget);
}

}  // namespace legacy_gl
