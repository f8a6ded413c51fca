#include "record/array_submit.hpp"

#include <algorithm>
#include <cstring>

#include "record/array_gather.hpp"
#include "record/pending.hpp"

namespace legacy_gl {

namespace {

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

void read_elements(const ElementView& elements, std::vector<std::uint32_t>& values) {
  values.resize(elements.count);
  with_elements(elements,
                [&values](std::uint32_t i, std::uint32_t element) { values[i] = element; });
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
      context, count, has_other_w(positions, first, count), wide_texcoord_arrays(views));
  ArrayGather(context, views, context.recorder.layout())(first, count, vertices);
  context.recorder.append_run(context, mode, count);
  context.recorder.flush_if_large(context);
}

void submit_elements(Context& context, const ArrayViews& views, GLenum mode, ElementView elements) {
  const ArrayView& positions = views[kVertexArray];
  elements.count = whole_primitives(mode, elements.count);
  if (elements.count == 0 || !positions.data) return;
  Recorder& recorder = context.recorder;
  const ElementRange range = element_range(elements);
  if (!worth_indexing(range, elements.count) || range.highest >= positions.readable) {
    float* vertices = recorder.append_vertices(context, elements.count, positions.size == 4,
                                               wide_texcoord_arrays(views));
    const ArrayGather gather(context, views, recorder.layout());
    with_elements(elements, [&](std::uint32_t, std::uint32_t element) {
      vertices = gather(element, 1, vertices);
    });
    recorder.append_run(context, mode, elements.count);
  } else {
    const std::uint32_t vertex_count = range.highest - range.lowest + 1;
    float* const vertices = recorder.append_vertices(
        context, vertex_count, has_other_w(positions, range.lowest, vertex_count),
        wide_texcoord_arrays(views));
    ArrayGather(context, views, recorder.layout())(range.lowest, vertex_count, vertices);
    const std::uint32_t offset = recorder.vertex_count() - vertex_count - range.lowest;
    std::uint32_t* const indices = recorder.append_elements(context, mode, elements.count);
    with_elements(elements,
                  [=](std::uint32_t i, std::uint32_t element) { indices[i] = element + offset; });
  }
  recorder.flush_if_large(context);
}

}  // namespace legacy_gl
