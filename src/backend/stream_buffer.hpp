#pragma once
#include <cstddef>

#include "backend/driver.hpp"

namespace legacy_gl {

/// A ring in a buffer object. Writes never wait for the driver: a region is written once, and when the ring is full
/// its storage is orphaned (glBufferData with NULL), so that draws under way keep theirs.
class StreamBuffer {
 public:
  StreamBuffer(const Driver& driver, GLenum target, std::size_t size);
  ~StreamBuffer();
  StreamBuffer(const StreamBuffer&) = delete;
  StreamBuffer& operator=(const StreamBuffer&) = delete;

  /// Copies `size` bytes to an offset that is a multiple of `alignment`; returns that offset. The buffer is bound to
  /// the target afterwards.
  std::size_t write(const void* data, std::size_t size, std::size_t alignment);

  /// Room of `size` bytes to write through a pointer; close with unmap().
  void* map(std::size_t size, std::size_t alignment, std::size_t& offset);
  void unmap();

  GLuint name() const { return name_; }

 private:
  std::size_t allocate(std::size_t size, std::size_t alignment);

  const Driver& driver_;
  GLenum target_;
  GLuint name_ = 0;
  std::size_t size_;
  std::size_t used_ = 0;
};

}  // namespace legacy_gl
