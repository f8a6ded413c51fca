#pragma once
#include <vector>

#include "geometry/primitive_run.hpp"
#include "record/array_reader.hpp"

struct legacy_gl_context;

namespace legacy_gl {

/// Indices as the application stores them.
struct ElementView {
  const std::byte* data = nullptr;
  GLenum type = GL_UNSIGNED_INT;  ///< unsigned byte, short or int
  std::uint32_t count = 0;
};

void read_elements(const ElementView& elements, std::vector<std::uint32_t>& values);

struct ElementRange {
  std::uint32_t lowest = 0, highest = 0;
  bool operator==(const ElementRange&) const = default;
};
ElementRange element_range(const ElementView& elements);

/// Vertices are copied once and drawn by indices, unless the elements name few of the range that
/// they span.
bool worth_indexing(const ElementRange& range, std::uint32_t count);

/// Puts vertices first to first + count - 1 into the recorder as primitives of `mode`: what the
/// state makes relevant, from the arrays or from the current values.
void submit_arrays(legacy_gl_context& context, const ArrayViews& views, GLenum mode,
                   std::uint32_t first, std::uint32_t count);

/// The same for the vertices that `elements` names.
void submit_elements(legacy_gl_context& context, const ArrayViews& views, GLenum mode,
                     ElementView elements);

}  // namespace legacy_gl
