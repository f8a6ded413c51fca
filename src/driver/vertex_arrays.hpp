#pragma once
#include <map>

#include "driver/driver.hpp"
#include "geometry/vertex_layout.hpp"

namespace legacy_gl {

/// A buffer that is drawn from again and again; it is bound to the target afterwards.
GLuint build_buffer(const Driver& driver, GLenum target, const void* data, std::size_t size);

/// A vertex array object for vertices of `layout` in `vertex_buffer` from its start on; it is bound
/// afterwards.
GLuint build_vertex_array(const Driver& driver, const VertexLayout& layout, GLuint vertex_buffer,
                          GLuint index_buffer);

/// One vertex array object for each layout and buffer, specified once and never again: drivers may
/// compile their vertex fetch for it.
class VertexArrays {
 public:
  explicit VertexArrays(const Driver& driver) : driver_(driver) {}
  ~VertexArrays();
  VertexArrays(const VertexArrays&) = delete;
  VertexArrays& operator=(const VertexArrays&) = delete;

  /// Vertices of `layout` in `vertex_buffer` from its start on; indices in `index_buffer`.
  GLuint find_or_build(const VertexLayout& layout, GLuint vertex_buffer, GLuint index_buffer);

 private:
  struct Key {
    std::uint64_t layout;
    GLuint vertex_buffer, index_buffer;
    auto operator<=>(const Key&) const = default;
  };
  const Driver& driver_;
  std::map<Key, GLuint> arrays_;
};

}  // namespace legacy_gl
