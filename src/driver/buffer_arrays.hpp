#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>

#include "driver/driver.hpp"

namespace legacy_gl {

/// One attribute fetched from a buffer object of the application as it lies there.
struct BufferAttribute {
  unsigned location = 0;
  GLuint buffer = 0;         ///< the driver's name
  std::uint64_t serial = 0;  ///< of the buffer: the driver gives names of deleted ones again
  GLint size = 0;
  GLenum type = 0;
  GLsizei stride = 0;
  bool normalised = false;
  const void* offset = nullptr;
  bool operator==(const BufferAttribute&) const = default;
};

struct BufferAttributes {
  static constexpr unsigned kMax = 16;
  std::array<BufferAttribute, kMax> attributes;
  unsigned count = 0;
  GLuint index_buffer = 0;
  std::uint64_t index_serial = 0;  ///< 0: a buffer of the library's own
  bool operator==(const BufferAttributes&) const = default;

  void add(const BufferAttribute& attribute) { attributes[count++] = attribute; }
};

/// Vertex array objects over the application's buffers: specified once, since a program draws the
/// same arrays frame after frame, and drivers check and compile what is specified again.
class BufferArrays {
 public:
  explicit BufferArrays(const Driver& driver) : driver_(driver) {}
  ~BufferArrays();
  BufferArrays(const BufferArrays&) = delete;
  BufferArrays& operator=(const BufferArrays&) = delete;

  GLuint find_or_build(const BufferAttributes& wanted);
  /// Deletes the objects that refer to the buffer of this serial number.
  void forget(std::uint64_t buffer);
  /// Deletes all.
  void clear();

 private:
  struct Hash {
    std::size_t operator()(const BufferAttributes& key) const noexcept;
  };
  GLuint build(const BufferAttributes& wanted);

  const Driver& driver_;
  std::unordered_map<BufferAttributes, GLuint, Hash> arrays_;
};

}  // namespace legacy_gl
