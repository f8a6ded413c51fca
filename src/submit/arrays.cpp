#include "submit/arrays.hpp"

#include <algorithm>

#include "geometry/wide_lines.hpp"
#include "submit/arrays_direct.hpp"
#include "submit/arrays_streamed.hpp"
#include "submit/choose_path.hpp"
#include "submit/draw_scope.hpp"
#include "submit/path_state.hpp"
#include "submit/prepare.hpp"

namespace legacy_gl {

namespace {

/// Whole elements of `size` bytes, `stride` apart, in `bytes`.
std::uint32_t elements_in(std::size_t bytes, std::size_t size, std::size_t stride) {
  if (bytes < size) return 0;
  return static_cast<std::uint32_t>(std::min<std::size_t>((bytes - size) / stride + 1, UINT32_MAX));
}

}  // namespace

std::span<const std::byte> ReadableArrays::read(BufferObject& buffer) {
  Contents contents = context_.driver->buffers.read(buffer);
  if (!contents) return {};
  const std::span<const std::byte> bytes(*contents);
  contents_[contents_count_++] = std::move(contents);
  return bytes;
}

const ArrayViews& ReadableArrays::views() {
  static constexpr std::byte kNothing{};
  for (unsigned i = 0; i < kArrayCount; ++i) {
    const ClientArray& array = context_.arrays.arrays[i];
    if (!array.enabled) continue;
    if (array.buffer_deleted || !array.buffer) {
      if (!array.buffer_deleted)
        views_[i] = make_view(array, static_cast<const std::byte*>(array.pointer));
      continue;
    }
    const std::span<const std::byte> bytes = read(*array.buffer);
    const std::size_t offset = reinterpret_cast<std::uintptr_t>(array.pointer);
    const bool inside = offset < bytes.size();
    ArrayView& view = views_[i] = make_view(array, inside ? bytes.data() + offset : &kNothing);
    view.readable = elements_in(inside ? bytes.size() - offset : 0,
                                std::size_t{view.size} * type_size(view.type), view.stride);
  }
  return views_;
}

ElementView ReadableArrays::elements(const ArrayDraw& draw) {
  const GLenum type = draw.element_type;
  if (!context_.arrays.element_buffer)
    return {static_cast<const std::byte*>(draw.elements), type, draw.elements ? draw.count : 0};
  const std::span<const std::byte> bytes = read(*context_.arrays.element_buffer);
  const std::size_t offset = reinterpret_cast<std::uintptr_t>(draw.elements);
  if (offset >= bytes.size()) return {nullptr, type, 0};
  const unsigned size = type_size(type);
  return {bytes.data() + offset, type,
          std::min(draw.count, elements_in(bytes.size() - offset, size, size))};
}

bool draws_from_mapped_buffer(Context& context, bool elements) {
  const auto is_mapped = [](const BufferPointer& buffer) { return buffer && buffer->mapped; };
  for (const ClientArray& array : context.arrays.arrays)
    if (array.enabled && is_mapped(array.buffer)) return true;
  return elements && is_mapped(context.arrays.element_buffer);
}

void draw_arrays(Context& context, const ArrayDraw& draw) {
  if (!context.arrays.arrays[kVertexArray].enabled) return;
  const PathState state = path_state(context);
  DrawRequest request{.source = DrawRequest::Source::kArrays,
                      .has_polygons = is_polygonal(draw.mode),
                      .has_lines = is_line(draw.mode),
                      .plain_quads = draw.mode == GL_QUADS && !draw.is_indexed()};
  const std::optional<DirectArrays> direct = find_direct_arrays(context, draw);
  request.fetched_by_driver = direct.has_value();
  if (const PathChoice choice = choose_path(request, state);
      choice.path == DrawPath::kArraysDirect) {
    flush_pending(context);
    const DrawScope scope(context, choice, draw.mode, draw.count);
    return draw_arrays_direct(context, draw, *direct);
  }

  ReadableArrays readable(context);
  const ElementView elements = draw.is_indexed() ? readable.elements(draw) : ElementView{};
  const std::optional<ElementRange> range = find_dense_range(draw, elements, readable.views());
  request.fetched_by_driver = false;
  request.many_and_dense = range.has_value();
  request.has_tiny_normals = range && may_have_tiny_normals(context, readable.views(), *range);
  PathChoice choice = choose_path(request, state);
  if (choice.path == DrawPath::kArraysStreamed) {
    flush_pending(context);
    const DrawScope scope(context, choice, draw.mode, draw.count);
    if (draw_arrays_streamed(context, draw, readable.views(), elements, *range)) return;
    choice = {DrawPath::kRecorder, "the driver has no memory for a stream"};
  }
  const DrawScope scope(context, choice, draw.mode, draw.count);
  if (draw.is_indexed()) submit_elements(context, readable.views(), draw.mode, elements);
  else submit_arrays(context, readable.views(), draw.mode, draw.first, draw.count);
}

}  // namespace legacy_gl
