// Large draws of client arrays: once through the cache, from the application's memory to the
// driver's.
#include "submit/arrays_streamed.hpp"

#include <algorithm>
#include <cstring>

#include "geometry/primitives.hpp"
#include "geometry/tiny_normals.hpp"
#include "record/array_gather.hpp"
#include "submit/prepare.hpp"

namespace legacy_gl {

namespace {

/// Fewer vertices go through the recorder, where draws of one state join.
constexpr std::uint32_t kWorthwhileVertices = 1024;

/// The index of vertex `range.lowest` in the stream buffer.
std::optional<std::uint32_t> stream_vertices(Context& context, const ArrayGather& gather,
                                             const ElementRange& range) {
  DriverObjects& objects = *context.driver;
  Submission& submission = *context.submission;
  const std::uint32_t count = range.highest - range.lowest + 1;
  const std::size_t stride = gather.stride() * sizeof(float);
  std::size_t offset = 0;
  // Before anything is mapped: it may throw.
  submission.floats.resize(ArrayGather::kBlockVertices * gather.stride());
  auto* to = static_cast<std::byte*>(objects.vertex_stream.map(count * stride, stride, offset));
  if (!to) return {};
  if (gather.writes_in_order()) {
    gather(range.lowest, count, reinterpret_cast<float*>(to));
  } else {
    // A block at a time: the driver's memory may be write-combined, where fields one by one are
    // slow.
    for (std::uint32_t done = 0; done < count;) {
      const std::uint32_t block = std::min(ArrayGather::kBlockVertices, count - done);
      gather(range.lowest + done, block, submission.floats.data());
      std::memcpy(to, submission.floats.data(), block * stride);
      to += block * stride;
      done += block;
    }
  }
  objects.vertex_stream.unmap();
  context.statistics.vertices += count;
  context.statistics.vertex_bytes_uploaded += count * stride;
  return static_cast<std::uint32_t>(offset / stride);
}

}  // namespace

std::optional<ElementRange> find_dense_range(const ArrayDraw& draw, const ElementView& elements,
                                             const ArrayViews& views) {
  const ArrayView& positions = views[kVertexArray];
  if (draw.count < kWorthwhileVertices || !positions.data) return {};
  ElementRange range{draw.first, draw.first + draw.count - 1};
  if (draw.is_indexed()) {
    if (elements.count < kWorthwhileVertices) return {};
    range = element_range(elements);
    if (!worth_indexing(range, elements.count)) return {};
  }
  if (range.highest >= positions.readable) return {};
  return range;
}

bool may_have_tiny_normals(const Context& context, const ArrayViews& views,
                           const ElementRange& range) {
  const ArrayView& normals = views[kNormalArray];
  return context.transform.normalize_enabled && normals.data &&
         Recorder::relevant_layout(context).fields & kFieldNormal &&
         range.highest < normals.readable &&
         has_tiny_components(normals, range.lowest, range.highest - range.lowest + 1);
}

bool draw_arrays_streamed(Context& context, const ArrayDraw& draw, const ArrayViews& views,
                          const ElementView& elements, const ElementRange& range) {
  DriverObjects& objects = *context.driver;
  const Driver& driver = context.driver->functions;
  Submission& submission = *context.submission;
  const ArrayView& positions = views[kVertexArray];
  VertexLayout layout = Recorder::relevant_layout(context);
  if (has_other_w(positions, range.lowest, range.highest - range.lowest + 1))
    layout.fields |= kFieldPositionW;
  layout.wide_texcoords |=
      static_cast<std::uint8_t>(wide_texcoord_arrays(views) & layout.texcoords);
  const ArrayGather gather(context, views, layout);
  prepare(context, layout);
  if (!use_program(context, draw.mode, draw.count)) return true;
  const std::optional<std::uint32_t> base = stream_vertices(context, gather, range);
  if (!base) return false;
  context.driver->bind_vertex_array(objects.vertex_arrays.find_or_build(
      layout, objects.vertex_stream.name(), objects.index_stream.name()));

  const GLenum mode = core_mode(draw.mode);
  const std::uint32_t shift = *base - range.lowest;
  if (draw.is_indexed() && draws_without_indices(draw.mode) && driver.DrawElementsBaseVertex) {
    const void* const offset = write_indices(
        context, elements.data, elements.count * std::size_t{type_size(elements.type)});
    driver.DrawElementsBaseVertex(mode, static_cast<GLsizei>(elements.count), elements.type, offset,
                                  static_cast<GLint>(shift));
  } else if (draw.is_indexed() || !draws_without_indices(draw.mode)) {
    submission.elements.clear();
    if (draw.is_indexed()) read_elements(elements, submission.elements);
    const std::uint32_t count = draw.is_indexed() ? elements.count : draw.count;
    submission.indices.clear();
    append_indices({draw.mode, draw.first, count, draw.is_indexed()}, submission.elements, shift,
                   submission.inputs.key.flat, submission.indices);
    const void* const offset = write_indices(context, submission.indices.data(),
                                             submission.indices.size() * sizeof(std::uint32_t));
    driver.DrawElements(mode, static_cast<GLsizei>(submission.indices.size()), GL_UNSIGNED_INT,
                        offset);
  } else {
    driver.DrawArrays(mode, static_cast<GLint>(*base), static_cast<GLsizei>(draw.count));
  }
  ++context.statistics.draws;
  ++context.statistics.batches;
  return true;
}

}  // namespace legacy_gl
