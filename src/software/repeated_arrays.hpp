#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/list_mesh.hpp"
#include "record/array_gather.hpp"
#include "software/recent_entries.hpp"
#include "submit/arrays.hpp"

namespace legacy_gl {

/// Large draws of client arrays that come again and again with the same contents: a closed surface
/// among them is kept as a mesh, of which only what is seen is drawn. The contents are compared in
/// every draw, since a program may change its memory at any time.
class RepeatedArrays {
 public:
  /// The mesh that is drawn in place of the arrays' vertices in `range`; nullptr: none is kept, or
  /// its contents are other ones by now.
  std::shared_ptr<ListMesh> find(const ArrayDraw& draw, const VertexLayout& layout,
                                 const ArrayGather& gather, const ElementView& elements,
                                 const ElementRange& range);

 private:
  struct Entry {
    ArrayDraw draw;
    VertexLayout layout;
    ElementRange range;
    std::uint64_t last_used = 0;
    unsigned seen = 0;
    unsigned failures = 0;  ///< times in a row that the contents were other ones
    std::shared_ptr<ListMesh> mesh;
    std::vector<std::byte> elements;
  };

  bool is_unchanged(const Entry& entry, const ArrayGather& gather, const ElementView& elements);
  void copy(Entry& entry, const ArrayGather& gather, const ElementView& elements);

  RecentEntries<Entry> entries_;
  std::vector<float> block_;
};

}  // namespace legacy_gl
