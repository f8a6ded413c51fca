#include "immediate/array_submit.hpp"

#include <algorithm>
#include <cstring>

#include "state/context.hpp"

namespace legacy_gl {

namespace {

/// Vertices are converted array by array in blocks of this many, so that a block stays in the nearest cache.
constexpr std::uint32_t kBlockVertices = 256;

/// A field of the batch's vertices that an array provides.
struct Field {
  const ArrayView* view;
  ReadFunction read;
  unsigned offset, size;  ///< in floats
};

/// Converts vertices into the recorder's layout of now.
class Gather {
 public:
  Gather(const Context& context, const ArrayViews& views)
      : context_(context), stride_(context.recorder.offsets().stride) {
    const VertexLayout& layout = context.recorder.layout();
    const VertexOffsets& offsets = context.recorder.offsets();
    add(views, kVertexArray, 0, offsets.position_size);
    if (layout.fields & kFieldNormal) add(views, kNormalArray, offsets.normal, 3);
    if (layout.fields & kFieldColor) add(views, kColorArray, offsets.color, 4);
    if (layout.fields & kFieldSecondaryColor)
      add(views, kSecondaryColorArray, offsets.secondary_color, 3);
    if (layout.fields & kFieldEdgeFlag) add(views, kEdgeFlagArray, offsets.edge_flag, 1);
  }

  float* operator()(std::uint32_t first, std::uint32_t count, float* to) const {
    while (count) {
      const std::uint32_t block = std::min(kBlockVertices, count);
      if (provided_ < stride_) context_.recorder.put_current(context_, to, block);
      for (unsigned i = 0; i < field_count_; ++i) {
        const Field& field = fields_[i];
        field.view->read(field.read, first, block, to + field.offset, stride_, field.size);
      }
      first += block;
      count -= block;
      to += block * stride_;
    }
    return to;
  }

 private:
  void add(const ArrayViews& views, unsigned array, unsigned offset, unsigned size) {
    const ArrayView& view = views[array];
    if (!view.data) return;
    fields_[field_count_++] = {&view, find_reader(view.type, is_normalised(array), view.size, size),
                               offset, size};
    provided_ += size;
  }

  const Context& context_;
  std::size_t stride_;
  std::array<Field, kArrayCount> fields_;
  unsigned field_count_ = 0;
  std::size_t provided_ = 0;
};

/// Positions of four components whose w is 1 throughout need no w.
bool has_other_w(const ArrayView& positions, std::uint32_t first, std::uint32_t count) {
  if (positions.size < 4) return false;
  ArrayView w = positions;
  w.data += 3 * type_size(w.type);
  w.size = 1;
  const ReadFunction read = find_reader(w.type, false, 1, 1);
  std::array<float, kBlockVertices> values;
  while (count) {
    const std::uint32_t block = std::min(kBlockVertices, count);
    w.read(read, first, block, values.data(), 1, 1);
    if (std::any_of(values.begin(), values.begin() + block, [](float v) { return v != 1; }))
      return true;
    first += block;
    count -= block;
  }
  return false;
}

template <typename Visit>
void with_elements(const ElementView& elements, Visit visit) {
  const auto each = [&](auto zero) {
    using T = decltype(zero);
    for (std::uint32_t i = 0; i < elements.count; ++i) {
      T value;  // client memory need not be aligned
      std::memcpy(&value, elements.data + i * sizeof(T), sizeof value);
      visit(i, std::uint32_t{value});
    }
  };
  switch (elements.type) {
    case GL_UNSIGNED_BYTE: return each(GLubyte{});
    case GL_UNSIGNED_SHORT: return each(GLushort{});
    default: return each(GLuint{});
  }
}

}  // namespace

std::vector<std::uint32_t> read_elements(const ElementView& elements) {
  std::vector<std::uint32_t> values(elements.count);
  with_elements(elements, [&values](std::uint32_t i, std::uint32_t element) { values[i] = element; });
  return values;
}

ElementRange element_range(const ElementView& elements) {
  ElementRange range{UINT32_MAX, 0};
  with_elements(elements, [&range](std::uint32_t, std::uint32_t element) {
    range.lowest = std::min(range.lowest, element);
    range.highest = std::max(range.highest, element);
  });
  return range;
}

bool worth_indexing(const ElementRange& range, std::uint32_t count) {
  return range.highest - range.lowest < 2 * std::uint64_t{count};
}

void submit_arrays(Context& context, const ArrayViews& views, GLenum mode, std::uint32_t first,
                   std::uint32_t count) {
  const ArrayView& positions = views[kVertexArray];
  if (!positions.data || first >= positions.readable) return;
  count = whole_primitives(mode, std::min(count, positions.readable - first));
  if (count == 0) return;
  float* const vertices = context.recorder.append_vertices(
      context, count, has_other_w(positions, first, count));
  Gather(context, views)(first, count, vertices);
  context.recorder.append_run(context, mode, count);
  context.recorder.flush_if_large(context);
}

void submit_elements(Context& context, const ArrayViews& views, GLenum mode,
                     ElementView elements) {
  const ArrayView& positions = views[kVertexArray];
  elements.count = whole_primitives(mode, elements.count);
  if (elements.count == 0 || !positions.data) return;
  Recorder& recorder = context.recorder;
  const ElementRange range = element_range(elements);
  if (!worth_indexing(range, elements.count) || range.highest >= positions.readable) {
    float* vertices = recorder.append_vertices(context, elements.count, positions.size == 4);
    const Gather gather(context, views);
    with_elements(elements, [&](std::uint32_t, std::uint32_t element) {
      vertices = gather(element, 1, vertices);
    });
    recorder.append_run(context, mode, elements.count);
  } else {
    const std::uint32_t vertex_count = range.highest - range.lowest + 1;
    float* const vertices = recorder.append_vertices(
        context, vertex_count, has_other_w(positions, range.lowest, vertex_count));
    Gather(context, views)(range.lowest, vertex_count, vertices);
    const std::uint32_t offset = recorder.vertex_count() - vertex_count - range.lowest;
    std::uint32_t* const indices = recorder.append_elements(context, mode, elements.count);
    with_elements(elements, [=](std::uint32_t i, std::uint32_t element) {
      indices[i] = element + offset;
    });
  }
  recorder.flush_if_large(context);
}

}  // namespace legacy_gl
