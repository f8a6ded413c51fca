#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "driver/driver.hpp"
#include "state/deleted_names.hpp"
#include "state/shared_names.hpp"

namespace legacy_gl {

/// A buffer object of the application (GL 2.1 spec 2.9, table 2.6). One that is deleted lives on
/// where another context has it bound (GL 2.1 spec D.3).
struct BufferObject {
  BufferObject(GLuint own_name, std::shared_ptr<DeletedNames> deleted)
      : name(own_name), driver_name(std::move(deleted)) {}

  const GLuint name;
  const std::uint64_t serial = next_number();  ///< of no other buffer in the process
  DriverName driver_name;
  GLsizeiptr size = 0;
  GLenum usage = GL_STATIC_DRAW;
  GLenum access = GL_READ_WRITE;
  void* mapped = nullptr;                 ///< where the application mapped it
  std::uint64_t version = next_number();  ///< differs whenever the contents may differ

  static std::uint64_t next_number() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
  }

  /// A copy of what the driver has, where the library has read it and nothing changed since.
  using Contents = std::vector<std::byte>;
  std::shared_ptr<Contents> contents;
  std::mutex reading;  ///< held while `contents` is made: contexts draw with one buffer at a time
};

using BufferPointer = std::shared_ptr<BufferObject>;

/// The buffer objects of all contexts that share. A reserved name becomes an object when it is
/// bound first.
struct SharedBuffers {
  SharedNames<BufferObject> names;
  std::shared_ptr<DeletedNames> deleted = std::make_shared<DeletedNames>();
  std::atomic<std::uint64_t> deletions = 0;  ///< of glDeleteBuffers so far
};

/// The application's buffer objects. Names are the driver's where the application asked for names;
/// it may also bind names of its own choice, as the core profile does not allow.
class BufferObjects {
 public:
  explicit BufferObjects(const Driver& driver) : driver_(driver) {}
  BufferObjects(const BufferObjects&) = delete;
  BufferObjects& operator=(const BufferObjects&) = delete;

  /// Before anything else.
  void share_with(const BufferObjects& other) { shared_ = other.shared_; }
  /// The context ends: with the last that shares them, all buffers do.
  void leave() {
    if (shared_.use_count() == 1) shared_->names.erase(1, UINT32_MAX);
  }
  /// Another context has deleted some since the last call.
  bool deleted_elsewhere();
  /// Deletes in the driver what no context has any more.
  void free_deleted() { shared_->deleted->collect(driver_.DeleteBuffers); }

  void generate(GLsizei count, GLuint* names);
  /// The object of that name, which is made if there is none.
  BufferPointer find_or_create(GLuint name);
  /// nullptr for 0 and for names that were never bound.
  BufferPointer find(GLuint name) const { return shared_->names.find(name); }
  void remove(GLuint name);

  /// False when the driver has no memory for it: the store is then empty.
  bool set_data(BufferObject& buffer, GLsizeiptr size, const void* data, GLenum usage);
  void set_sub_data(BufferObject& buffer, GLintptr offset, GLsizeiptr size, const void* data);
  bool get_sub_data(BufferObject& buffer, GLintptr offset, GLsizeiptr size, void* data);
  /// nullptr when the driver refuses.
  void* map(BufferObject& buffer, GLenum access);
  bool unmap(BufferObject& buffer);

  /// For the library's own reading, while the application has not mapped the buffer: the driver is
  /// asked once for what is the same. nullptr when it refuses, or when the store is empty.
  std::shared_ptr<const BufferObject::Contents> read(BufferObject& buffer);

 private:
  void bind(const BufferObject& buffer);

  const Driver& driver_;
  std::shared_ptr<SharedBuffers> shared_ = std::make_shared<SharedBuffers>();
  std::uint64_t seen_deletions_ = 0;
};

}  // namespace legacy_gl
