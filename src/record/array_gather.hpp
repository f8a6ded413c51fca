#pragma once
#include <array>
#include <cstdint>

#include "geometry/vertex_layout.hpp"
#include "record/array_reader.hpp"

struct legacy_gl_context;

namespace legacy_gl {

/// Converts vertices of client arrays into a layout; what no array provides has the current value
/// in each vertex.
class ArrayGather {
 public:
  /// Vertices are converted array by array; so many of them stay in the nearest cache meanwhile.
  static constexpr std::uint32_t kBlockVertices = 256;

  ArrayGather(const legacy_gl_context& context, const ArrayViews& views,
              const VertexLayout& layout);

  /// Vertices first to first + count - 1; returns the end.
  float* operator()(std::uint32_t first, std::uint32_t count, float* to) const;

  /// Floats of one vertex.
  std::size_t stride() const { return stride_; }
  /// Each vertex is written whole, one after the other: good for memory that is not cached.
  bool writes_in_order() const { return interleave_ != nullptr; }

 private:
  /// A field of the layout that an array provides; offset and size in floats.
  struct Field {
    const ArrayView* view;
    ReadFunction read;
    unsigned offset, size;
  };
  using Interleave = void (*)(const Field* fields, std::uint32_t first, std::uint32_t count,
                              float* to);
  template <unsigned... kSizes>
  static void interleave(const Field* fields, std::uint32_t first, std::uint32_t count, float* to);
  Interleave find_interleave() const;
  bool all_exist(std::uint64_t end) const;
  void add(const ArrayViews& views, unsigned array, unsigned offset, unsigned size);

  const legacy_gl_context& context_;
  VertexLayout layout_;
  std::size_t stride_;
  std::array<Field, kArrayCount> fields_;
  unsigned field_count_ = 0;
  std::size_t provided_ = 0;
  Interleave interleave_ = nullptr;  ///< for arrays that hold just the floats of the layout
};

/// Texture units whose array gives r or q.
std::uint8_t wide_texcoord_arrays(const ArrayViews& views);

/// Positions of four components whose w is 1 throughout need no w.
bool has_other_w(const ArrayView& positions, std::uint32_t first, std::uint32_t count);

}  // namespace legacy_gl
