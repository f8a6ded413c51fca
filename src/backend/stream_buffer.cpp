#include "backend/stream_buffer.hpp"

#include <algorithm>
#include <cstring>

namespace legacy_gl {

StreamBuffer::StreamBuffer(const Driver& driver, GLenum target, std::size_t size)
    : driver_(driver), target_(target), size_(size) {
  driver_.GenBuffers(1, &name_);
  driver_.BindBuffer(target_, name_);
  driver_.BufferData(target_, static_cast<GLsizeiptr>(size_), nullptr, GL_STREAM_DRAW);
}

StreamBuffer::~StreamBuffer() { driver_.DeleteBuffers(1, &name_); }

std::size_t StreamBuffer::allocate(std::size_t size, std::size_t alignment) {
  driver_.BindBuffer(target_, name_);
  std::size_t offset = (used_ + alignment - 1) / alignment * alignment;
  if (offset + size > size_) {
    size_ = std::max(size_, 2 * size);
    driver_.BufferData(target_, static_cast<GLsizeiptr>(size_), nullptr, GL_STREAM_DRAW);
    offset = 0;
  }
  used_ = offset + size;
  return offset;
}

void* StreamBuffer::map(std::size_t size, std::size_t alignment, std::size_t& offset) {
  offset = allocate(size, alignment);
  return driver_.MapBufferRange(
      target_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size),
      GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_UNSYNCHRONIZED_BIT);
}

void StreamBuffer::unmap() { driver_.UnmapBuffer(target_); }

std::size_t StreamBuffer::write(const void* data, std::size_t size, std::size_t alignment) {
  std::size_t offset = 0;
  if (void* const target = map(size, alignment, offset)) {
    std::memcpy(target, data, size);
    unmap();
  } else {
    driver_.BufferSubData(target_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size),
                          data);
  }
  return offset;
}

}  // namespace legacy_gl
