#include "driver/buffer_objects.hpp"

#include <cstring>
#include <utility>

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

void changed(BufferObject& buffer) {
  buffer.version = BufferObject::next_number();
  buffer.contents = nullptr;
}

}  // namespace

void BufferObjects::bind(const BufferObject& buffer) {
  driver_.BindBuffer(kTarget, buffer.driver_name.get());
}

void BufferObjects::generate(GLsizei count, GLuint* names) {
  for (GLsizei i = 0; i < count; ++i) {
    GLuint name = 0;
    // A name that the application chose itself may be the driver's next: that one is passed over.
    do driver_.GenBuffers(1, &name);
    while (name && shared_->names.contains(name));
    if (name) shared_->names.store(name, nullptr);
    names[i] = name;
  }
}

BufferPointer BufferObjects::find_or_create(GLuint name) {
  return shared_->names.find_or_create(name, [&](bool reserved) {
    auto buffer = std::make_shared<BufferObject>(name, shared_->deleted);
    buffer->driver_name.get_or_make([&] {
      GLuint made = name;
      if (!reserved) driver_.GenBuffers(1, &made);
      return made;
    });
    return buffer;
  });
}

void BufferObjects::remove(GLuint name) {
  if (!shared_->names.find(name) && shared_->names.contains(name)) driver_.DeleteBuffers(1, &name);
  if (shared_->names.erase(name, 1)) {
    ++shared_->deletions;
    ++seen_deletions_;
  }
  free_deleted();
}

bool BufferObjects::deleted_elsewhere() {
  const std::uint64_t deletions = shared_->deletions;
  return std::exchange(seen_deletions_, deletions) != deletions;
}

bool BufferObjects::set_data(BufferObject& buffer, GLsizeiptr size, const void* data,
                             GLenum usage) {
  bind(buffer);
  forget_errors(driver_);
  driver_.BufferData(kTarget, size, data, usage);
  const bool stored = driver_.GetError() == GL_NO_ERROR;
  if (stored) label(driver_, GL_BUFFER, buffer.driver_name.get(), "buffer object");
  buffer.size = stored ? size : 0;
  buffer.usage = usage;
  buffer.access = GL_READ_WRITE;
  buffer.mapped = nullptr;
  changed(buffer);
  return stored;
}

void BufferObjects::set_sub_data(BufferObject& buffer, GLintptr offset, GLsizeiptr size,
                                 const void* data) {
  bind(buffer);
  driver_.BufferSubData(kTarget, offset, size, data);
  buffer.version = BufferObject::next_number();
  // A program that changes a part before each draw is to pay for that part alone.
  if (!buffer.contents) return;
  if (buffer.contents.use_count() > 1)
    buffer.contents = std::make_shared<BufferObject::Contents>(*buffer.contents);
  std::memcpy(buffer.contents->data() + offset, data, static_cast<std::size_t>(size));
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
  if (buffer.access != GL_READ_ONLY) changed(buffer);
  buffer.mapped = nullptr;
  buffer.access = GL_READ_WRITE;
  return driver_.UnmapBuffer(kTarget) != GL_FALSE;
}

std::shared_ptr<const BufferObject::Contents> BufferObjects::read(BufferObject& buffer) {
  const std::lock_guard lock(buffer.reading);
  if (buffer.contents || buffer.size == 0) return buffer.contents;
  const auto size = static_cast<std::size_t>(buffer.size);
  auto contents = std::make_shared<BufferObject::Contents>(size);
  bind(buffer);
  const void* const source = driver_.MapBufferRange(kTarget, 0, buffer.size, GL_MAP_READ_BIT);
  if (!source) return nullptr;
  std::memcpy(contents->data(), source, size);
  // The contents were lost while they were mapped: they are read again at the next draw.
  if (driver_.UnmapBuffer(kTarget) != GL_FALSE) buffer.contents = contents;
  return contents;
}

}  // namespace legacy_gl
