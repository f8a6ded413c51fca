#pragma once
#include <cstdint>

#include "immediate/array_submit.hpp"

struct legacy_gl_context;

namespace legacy_gl {

/// The enabled arrays and the bound elements in memory, for as long as this lives: buffer objects are mapped.
class ReadableArrays {
 public:
  explicit ReadableArrays(legacy_gl_context& context) : context_(context) {}
  ~ReadableArrays();
  ReadableArrays(const ReadableArrays&) = delete;
  ReadableArrays& operator=(const ReadableArrays&) = delete;

  const ArrayViews& views();
  /// `pointer`: an address, or an offset into the element buffer that is bound. Elements past its end are cut off.
  ElementView elements(GLenum type, const void* pointer, std::uint32_t count);

 private:
  struct Mapping {
    GLuint name = 0;
    const std::byte* data = nullptr;
    std::size_t size = 0;
  };
  const Mapping& map(GLuint name);

  legacy_gl_context& context_;
  ArrayViews views_;
  std::array<Mapping, kArrayCount + 1> mappings_;
  unsigned mapping_count_ = 0;
};

/// An enabled array, or with `elements` the element array, is in a buffer that the application has mapped.
bool draws_from_mapped_buffer(legacy_gl_context& context, bool elements);

void draw_arrays(legacy_gl_context& context, GLenum mode, std::uint32_t first, std::uint32_t count);
void draw_elements(legacy_gl_context& context, GLenum mode, std::uint32_t count, GLenum type,
                   const void* pointer);

}  // namespace legacy_gl
