#include "immediate/array_gather.hpp"

#include <algorithm>

#include "immediate/recorder.hpp"

namespace legacy_gl {

ArrayGather::ArrayGather(const legacy_gl_context& context, const ArrayViews& views,
                         const VertexLayout& layout)
    : context_(context), layout_(layout) {
  const VertexOffsets offsets = offsets_of(layout);
  stride_ = offsets.stride;
  add(views, kVertexArray, 0, offsets.position_size);
  if (layout.fields & kFieldNormal) add(views, kNormalArray, offsets.normal, 3);
  if (layout.fields & kFieldColor) add(views, kColorArray, offsets.color, 4);
  if (layout.fields & kFieldSecondaryColor)
    add(views, kSecondaryColorArray, offsets.secondary_color, 3);
  if (layout.fields & kFieldEdgeFlag) add(views, kEdgeFlagArray, offsets.edge_flag, 1);
}

void ArrayGather::add(const ArrayViews& views, unsigned array, unsigned offset, unsigned size) {
  const ArrayView& view = views[array];
  if (!view.data) return;
  fields_[field_count_++] = {&view, find_reader(view.type, is_normalised(array), view.size, size),
                             offset, size};
  provided_ += size;
}

float* ArrayGather::operator()(std::uint32_t first, std::uint32_t count, float* to) const {
  while (count) {
    const std::uint32_t block = std::min(kBlockVertices, count);
    if (provided_ < stride_) Recorder::put_current(context_, layout_, to, block);
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

bool has_other_w(const ArrayView& positions, std::uint32_t first, std::uint32_t count) {
  if (positions.size < 4) return false;
  ArrayView w = positions;
  w.data += 3 * type_size(w.type);
  w.size = 1;
  const ReadFunction read = find_reader(w.type, false, 1, 1);
  std::array<float, ArrayGather::kBlockVertices> values;
  while (count) {
    const std::uint32_t block = std::min(ArrayGather::kBlockVertices, count);
    w.read(read, first, block, values.data(), 1, 1);
    if (std::any_of(values.begin(), values.begin() + block, [](float v) { return v != 1; }))
      return true;
    first += block;
    count -= block;
  }
  return false;
}

}  // namespace legacy_gl
