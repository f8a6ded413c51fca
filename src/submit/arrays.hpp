#pragma once
#include <cstdint>
#include <span>

#include "driver/buffer_objects.hpp"
#include "record/array_submit.hpp"
#include "record/pending.hpp"

struct legacy_gl_context;

namespace legacy_gl {

/// A draw from the enabled client arrays: `count` vertices from `first` on, or those that `count`
/// elements name.
struct ArrayDraw {
  GLenum mode = GL_POINTS;
  std::uint32_t first = 0;  ///< 0 with elements
  std::uint32_t count = 0;
  GLenum element_type = 0;  ///< 0: no elements
  const void* elements =
      nullptr;  ///< an address, or an offset into the element buffer that is bound
  bool is_indexed() const { return element_type != 0; }
  bool operator==(const ArrayDraw&) const = default;
};

/// The enabled arrays and the bound elements in memory, for as long as this lives.
class ReadableArrays {
 public:
  explicit ReadableArrays(legacy_gl_context& context) : context_(context) {}
  ReadableArrays(const ReadableArrays&) = delete;
  ReadableArrays& operator=(const ReadableArrays&) = delete;

  const ArrayViews& views();
  /// Elements past the end of a buffer object are cut off.
  ElementView elements(const ArrayDraw& draw);

 private:
  using Contents = std::shared_ptr<const BufferObject::Contents>;
  /// Nothing when the driver does not give them.
  std::span<const std::byte> read(BufferObject& buffer);

  legacy_gl_context& context_;
  ArrayViews views_;
  std::array<Contents, kArrayCount + 1> contents_;
  unsigned contents_count_ = 0;
};

/// An enabled array, or with `elements` the element array, is in a buffer that the application has
/// mapped.
bool draws_from_mapped_buffer(legacy_gl_context& context, bool elements);

/// Draws at once from buffer objects where that is possible, and puts the vertices into the
/// recorder where not.
void draw_arrays(legacy_gl_context& context, const ArrayDraw& draw);

}  // namespace legacy_gl
