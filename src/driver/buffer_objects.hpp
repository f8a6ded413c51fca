#pragma once
#include <cstdint>
#include <unordered_map>

#include "driver/driver.hpp"

namespace legacy_gl {

/// A buffer object of the application (GL 2.1 spec 2.9, table 2.6).
struct BufferObject {
  GLuint driver_name = 0;
  GLsizeiptr size = 0;
  GLenum usage = GL_STATIC_DRAW;
  GLenum access = GL_READ_WRITE;
  void* mapped = nullptr;     ///< where the application mapped it
  std::uint64_t version = 0;  ///< differs whenever the contents may differ
};

/// The application's buffer objects. Names are the driver's where the application asked for names;
/// it may also bind names of its own choice, as the core profile does not allow.
class BufferObjects {
 public:
  explicit BufferObjects(const Driver& driver) : driver_(driver) {}
  ~BufferObjects();
  BufferObjects(const BufferObjects&) = delete;
  BufferObjects& operator=(const BufferObjects&) = delete;

  void generate(GLsizei count, GLuint* names);
  /// The object of that name, which is made if there is none.
  BufferObject& find_or_create(GLuint name);
  /// nullptr for 0 and for names that were never bound.
  BufferObject* find(GLuint name);
  void remove(GLuint name);

  /// False when the driver has no memory for it: the store is then empty.
  bool set_data(BufferObject& buffer, GLsizeiptr size, const void* data, GLenum usage);
  void set_sub_data(BufferObject& buffer, GLintptr offset, GLsizeiptr size, const void* data);
  bool get_sub_data(BufferObject& buffer, GLintptr offset, GLsizeiptr size, void* data);
  /// nullptr when the driver refuses.
  void* map(BufferObject& buffer, GLenum access);
  bool unmap(BufferObject& buffer);

  /// For the library's own reading, while the application has not mapped the buffer.
  const void* map_for_reading(const BufferObject& buffer);
  void unmap_after_reading(const BufferObject& buffer);

 private:
  void bind(const BufferObject& buffer);

  const Driver& driver_;
  /// driver_name 0: the name is reserved, and becomes an object when it is bound first.
  std::unordered_map<GLuint, BufferObject> objects_;
  std::uint64_t last_version_ = 0;
};

}  // namespace legacy_gl
