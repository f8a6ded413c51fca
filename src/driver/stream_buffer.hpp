#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "driver/driver.hpp"

namespace legacy_gl {

/// A ring in a buffer object. Writes never wait for the driver: memory is used again only when a
/// fence says that the driver has read it; until then the whole storage is orphaned (glBufferData
/// with NULL), so that draws under way keep theirs.
class StreamBuffer {
 public:
  /// What is written is either drawn with before the next write, or stays bound for the draws of
  /// some time.
  enum class Use { kOneDraw, kManyDraws };

  StreamBuffer(const Driver& driver, GLenum target, std::size_t size, Use use);
  ~StreamBuffer();
  StreamBuffer(const StreamBuffer&) = delete;
  StreamBuffer& operator=(const StreamBuffer&) = delete;

  /// Copies `size` bytes to an offset that is a multiple of `alignment`; returns that offset. The
  /// buffer is bound to the target afterwards.
  std::size_t write(const void* data, std::size_t size, std::size_t alignment) {
    return write(data, size, alignment, size);
  }
  /// Of `room` bytes, the first `size` are written.
  std::size_t write(const void* data, std::size_t size, std::size_t alignment, std::size_t room);

  /// Room of `size` bytes to write through a pointer; close with unmap().
  void* map(std::size_t size, std::size_t alignment, std::size_t& offset);
  void unmap();

  GLuint name() const { return name_; }
  /// Times that the ring began anew: what was written before is no longer there.
  std::uint64_t rounds() const { return rounds_; }

 private:
  static constexpr std::size_t kSegments = 4;

  std::size_t allocate(std::size_t size, std::size_t alignment);
  std::size_t write_without_map(std::size_t offset, const void* data, std::size_t size);
  void* map_at(std::size_t offset, std::size_t size);
  std::size_t segment_of(std::size_t end) const;
  bool enter_segments(std::size_t first, std::size_t last);
  void orphan(std::size_t at_least);
  void forget_fences();

  const Driver& driver_;
  GLenum target_;
  Use use_;
  GLuint name_ = 0;
  std::size_t size_;
  std::size_t used_ = 0;
  std::size_t segment_ = 0;  ///< the last one that was written to
  std::uint64_t rounds_ = 0;
  /// Each after the last draw that reads the segment; nullptr: it was not read yet in this storage.
  std::array<GLsync, kSegments> fences_{};
};

}  // namespace legacy_gl
