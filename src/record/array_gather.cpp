#include "record/array_gather.hpp"

#include <algorithm>
#include <cstring>

#include "record/recorder.hpp"

namespace legacy_gl {

ArrayGather::ArrayGather(const legacy_gl_context& context, const ArrayViews& views,
                         const VertexLayout& layout)
    : context_(context), layout_(layout) {
  const VertexOffsets offsets = offsets_of(layout);
  stride_ = offsets.stride;
  add(views, kVertexArray, 0, offsets.position_size);
  if (layout.fields & (kFieldNormal | kFieldShaded)) add(views, kNormalArray, offsets.normal, 3);
  if (layout.fields & kFieldColor) add(views, kColorArray, offsets.color, 4);
  if (layout.fields & kFieldSecondaryColor)
    add(views, kSecondaryColorArray, offsets.secondary_color, 3);
  if (layout.fields & kFieldFogCoord) add(views, kFogCoordArray, offsets.fog_coord, 1);
  if (layout.texcoords)
    for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
      if (layout.texcoords & 1u << unit)
        add(views, kTexCoordArray + unit, offsets.texcoords[unit], texcoord_size(layout, unit));
  if (layout.fields & kFieldEdgeFlag) add(views, kEdgeFlagArray, offsets.edge_flag, 1);
  interleave_ = find_interleave();
}

template <unsigned... kSizes>
void ArrayGather::interleave(const Field* fields, std::uint32_t first, std::uint32_t count,
                             float* to) {
  for (std::size_t i = first; i < std::size_t{first} + count; ++i) {
    const Field* field = fields;
    const auto copy = [&](unsigned size) {
      std::memcpy(to, field->view->data + i * field->view->stride, size * sizeof(float));
      to += size;
      ++field;
    };
    (copy(kSizes), ...);
  }
}

ArrayGather::Interleave ArrayGather::find_interleave() const {
  if (provided_ < stride_) return nullptr;
  unsigned sizes = 0;  // as decimal digits
  for (unsigned i = 0; i < field_count_; ++i) {
    const ArrayView& view = *fields_[i].view;
    if (view.type != GL_FLOAT || view.size != fields_[i].size) return nullptr;
    sizes = 10 * sizes + view.size;
  }
  switch (sizes) {
    case 3: return &interleave<3>;
    case 32: return &interleave<3, 2>;
    case 33: return &interleave<3, 3>;
    case 34: return &interleave<3, 4>;
    case 332: return &interleave<3, 3, 2>;
    case 334: return &interleave<3, 3, 4>;
    case 342: return &interleave<3, 4, 2>;
    case 3342: return &interleave<3, 3, 4, 2>;
    default: return nullptr;
  }
}

bool ArrayGather::all_exist(std::uint64_t end) const {
  return std::all_of(fields_.begin(), fields_.begin() + field_count_,
                     [end](const Field& field) { return end <= field.view->readable; });
}

void ArrayGather::add(const ArrayViews& views, unsigned array, unsigned offset, unsigned size) {
  const ArrayView& view = views[array];
  if (!view.data) return;
  fields_[field_count_++] = {&view, find_reader(view.type, is_normalised(array), view.size, size),
                             offset, size};
  provided_ += size;
}

float* ArrayGather::operator()(std::uint32_t first, std::uint32_t count, float* to) const {
  if (interleave_ && all_exist(std::uint64_t{first} + count)) {
    interleave_(fields_.data(), first, count, to);
    return to + count * stride_;
  }
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

std::uint8_t wide_texcoord_arrays(const ArrayViews& views) {
  unsigned units = 0;
  for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
    if (const ArrayView& view = views[kTexCoordArray + unit]; view.data && view.size > 2)
      units |= 1u << unit;
  return static_cast<std::uint8_t>(units);
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
