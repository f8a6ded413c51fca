#include "driver/stream_buffer.hpp"

#include <algorithm>
#include <cstring>

#include "driver/debug_labels.hpp"

namespace legacy_gl {

StreamBuffer::StreamBuffer(const Driver& driver, GLenum target, std::size_t size, Use use)
    : driver_(driver), target_(target), use_(use), size_(size) {
  driver_.GenBuffers(1, &name_);
  driver_.BindBuffer(target_, name_);
  driver_.BufferData(target_, static_cast<GLsizeiptr>(size_), nullptr, GL_STREAM_DRAW);
  label(driver_, GL_BUFFER, name_,
        target_ == GL_UNIFORM_BUFFER      ? "uniform blocks"
        : target_ == GL_COPY_WRITE_BUFFER ? "stream of indices"
                                          : "stream of vertices");
}

StreamBuffer::~StreamBuffer() {
  forget_fences();
  driver_.DeleteBuffers(1, &name_);
}

void StreamBuffer::forget_fences() {
  for (GLsync& fence : fences_) {
    if (fence) driver_.DeleteSync(fence);
    fence = nullptr;
  }
}

void StreamBuffer::orphan(std::size_t at_least) {
  forget_fences();
  size_ = std::max(size_, 2 * at_least);
  driver_.BufferData(target_, static_cast<GLsizeiptr>(size_), nullptr, GL_STREAM_DRAW);
}

/// Every draw so far has been handed to the driver: a fence now comes after those that read the
/// segment left behind. False when the driver may still be reading one of those that are entered.
bool StreamBuffer::enter_segments(std::size_t first, std::size_t last) {
  if (fences_[segment_]) driver_.DeleteSync(fences_[segment_]);
  fences_[segment_] = driver_.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  for (std::size_t segment = first; segment <= last; ++segment) {
    GLsync& fence = fences_[segment];
    if (!fence) continue;
    const GLenum status = driver_.ClientWaitSync(fence, 0, 0);
    if (status != GL_ALREADY_SIGNALED && status != GL_CONDITION_SATISFIED) return false;
    driver_.DeleteSync(fence);
    fence = nullptr;
  }
  segment_ = last;
  return true;
}

std::size_t StreamBuffer::allocate(std::size_t size, std::size_t alignment) {
  driver_.BindBuffer(target_, name_);
  std::size_t offset = (used_ + alignment - 1) / alignment * alignment;
  const bool wraps = offset + size > size_;
  if (wraps) offset = 0;
  const std::size_t last = segment_of(offset + size);
  bool anew = wraps;
  if (use_ == Use::kOneDraw && size <= size_)
    anew = (wraps || last > segment_) && !enter_segments(wraps ? 0 : segment_ + 1, last);
  if (anew) {
    orphan(size);
    offset = 0;
    segment_ = segment_of(size);
  }
  if (wraps || anew) ++rounds_;
  used_ = offset + size;
  return offset;
}

/// The segment of the last byte before `end`.
std::size_t StreamBuffer::segment_of(std::size_t end) const {
  return end == 0 ? 0 : std::min((end - 1) / (size_ / kSegments), kSegments - 1);
}

void* StreamBuffer::map_at(std::size_t offset, std::size_t size) {
  return driver_.MapBufferRange(
      target_, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(size),
      GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_RANGE_BIT | GL_MAP_UNSYNCHRONIZED_BIT);
}

void* StreamBuffer::map(std::size_t size, std::size_t alignment, std::size_t& offset) {
  offset = allocate(size, alignment);
  return map_at(offset, size);
}

void StreamBuffer::unmap() { driver_.UnmapBuffer(target_); }

/// Where the driver refuses to map. The store itself may be missing, for lack of memory: then it is
/// asked for again.
std::size_t StreamBuffer::write_without_map(std::size_t offset, const void* data,
                                            std::size_t size) {
  forget_errors(driver_);
  const auto put = [&](std::size_t at) {
    driver_.BufferSubData(target_, static_cast<GLintptr>(at), static_cast<GLsizeiptr>(size), data);
  };
  put(offset);
  if (driver_.GetError() == GL_NO_ERROR) return offset;
  orphan(size);
  segment_ = segment_of(size);
  used_ = size;
  ++rounds_;
  put(0);
  return 0;
}

std::size_t StreamBuffer::write(const void* data, std::size_t size, std::size_t alignment,
                                std::size_t room) {
  const std::size_t offset = allocate(room, alignment);
  if (size == 0) return offset;
  if (void* const target = map_at(offset, size)) {
    std::memcpy(target, data, size);
    unmap();
    return offset;
  }
  return write_without_map(offset, data, size);
}

}  // namespace legacy_gl
