// Large draws of client arrays: once through the cache, from the application's memory to the
// driver's.
#include <algorithm>
#include <cstring>
#include <optional>

#include "geometry/primitives.hpp"
#include "geometry/tiny_normals.hpp"
#include "record/array_gather.hpp"
#include "software/hidden_sides.hpp"
#include "submit/arrays.hpp"
#include "submit/backend.hpp"

namespace legacy_gl {

namespace {

/// Fewer vertices go through the recorder, where draws of one state join.
constexpr std::uint32_t kWorthwhileVertices = 1024;

/// The vertices that the draw reads; nothing when they are few, or too far apart.
std::optional<ElementRange> find_range(const ArrayDraw& draw, const ElementView& elements,
                                       const ArrayView& positions) {
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

/// Some normal may be so short that the recorder has to make it longer.
bool may_be_tiny(const Context& context, const ArrayView& normals, const ElementRange& range) {
  return context.transform.normalize_enabled && normals.data &&
         Recorder::relevant_layout(context).fields & kFieldNormal &&
         range.highest < normals.readable &&
         has_tiny_components(normals, range.lowest, range.highest - range.lowest + 1);
}

}  // namespace

/// The index of vertex `range.lowest` in the stream buffer.
std::optional<std::uint32_t> Backend::stream_vertices(Context& context, const ArrayGather& gather,
                                                      const ElementRange& range) {
  const std::uint32_t count = range.highest - range.lowest + 1;
  const std::size_t stride = gather.stride() * sizeof(float);
  std::size_t offset = 0;
  auto* to = static_cast<std::byte*>(vertices_.map(count * stride, stride, offset));
  if (!to) return {};
  if (gather.writes_in_order()) {
    gather(range.lowest, count, reinterpret_cast<float*>(to));
  } else {
    // A block at a time: the driver's memory may be write-combined, where fields one by one are
    // slow.
    float_scratch_.resize(ArrayGather::kBlockVertices * gather.stride());
    for (std::uint32_t done = 0; done < count;) {
      const std::uint32_t block = std::min(ArrayGather::kBlockVertices, count - done);
      gather(range.lowest + done, block, float_scratch_.data());
      std::memcpy(to, float_scratch_.data(), block * stride);
      to += block * stride;
      done += block;
    }
  }
  vertices_.unmap();
  context.statistics.vertices += count;
  context.statistics.vertex_bytes_uploaded += count * stride;
  return static_cast<std::uint32_t>(offset / stride);
}

bool Backend::draw_streamed(Context& context, const ArrayDraw& draw) {
  if (draw.count < kWorthwhileVertices || is_unfilled(context.raster.polygon)) return false;
  if (is_line(draw.mode) && replaces_lines(context)) return false;
  if (draw.mode == GL_QUADS && !draw.is_indexed()) return false;  // the split depends on positions
  ReadableArrays readable(context);
  const ArrayView& positions = readable.views()[kVertexArray];
  const ElementView elements = draw.is_indexed() ? readable.elements(draw) : ElementView{};
  const std::optional<ElementRange> range = find_range(draw, elements, positions);
  if (!range || may_be_tiny(context, readable.views()[kNormalArray], *range)) return false;

  flush_pending(context);
  VertexLayout layout = Recorder::relevant_layout(context);
  if (has_other_w(positions, range->lowest, range->highest - range->lowest + 1))
    layout.fields |= kFieldPositionW;
  layout.wide_texcoords |=
      static_cast<std::uint8_t>(wide_texcoord_arrays(readable.views()) & layout.texcoords);
  const ArrayGather gather(context, readable.views(), layout);
  if (skips_unseen(context) && draw.mode >= GL_TRIANGLES && !(layout.fields & kFieldPositionW) &&
      shows_nearest_alone(context))
    if (const auto mesh = repeated_arrays_.find(draw, layout, gather, elements, *range)) {
      draw_mesh(context, *mesh);
      return true;
    }
  prepare(context, layout);
  if (!use_program(context, draw.mode, draw.count)) return true;
  const std::optional<std::uint32_t> base = stream_vertices(context, gather, *range);
  if (!base) return false;
  bind_vertex_array(arrays_.find_or_build(layout, vertices_.name(), indices_.name()));

  const GLenum mode = core_mode(draw.mode);
  const std::uint32_t shift = *base - range->lowest;
  if (draw.is_indexed() && draws_without_indices(draw.mode) && driver.DrawElementsBaseVertex) {
    const void* const offset = write_indices(
        context, elements.data, elements.count * std::size_t{type_size(elements.type)});
    driver.DrawElementsBaseVertex(mode, static_cast<GLsizei>(elements.count), elements.type, offset,
                                  static_cast<GLint>(shift));
  } else if (draw.is_indexed() || !draws_without_indices(draw.mode)) {
    element_scratch_.clear();
    if (draw.is_indexed()) read_elements(elements, element_scratch_);
    const std::uint32_t count = draw.is_indexed() ? elements.count : draw.count;
    index_scratch_.clear();
    append_indices({draw.mode, draw.first, count, draw.is_indexed()}, element_scratch_, shift,
                   derived_.key.flat, index_scratch_);
    const void* const offset = write_indices(context, index_scratch_.data(),
                                             index_scratch_.size() * sizeof(std::uint32_t));
    driver.DrawElements(mode, static_cast<GLsizei>(index_scratch_.size()), GL_UNSIGNED_INT, offset);
  } else {
    driver.DrawArrays(mode, static_cast<GLint>(*base), static_cast<GLsizei>(draw.count));
  }
  ++context.statistics.draws;
  ++context.statistics.batches;
  return true;
}

}  // namespace legacy_gl
