// Polygons that glPolygonMode turns into lines or points (GL 2.1 spec 3.5.4).
#include <array>
#include <cmath>
#include <cstring>

#include "execute/framebuffer.hpp"
#include "geometry/line_stipple.hpp"
#include "geometry/wide_lines.hpp"
#include "record/pending.hpp"
#include "submit/expanded.hpp"
#include "submit/prepare.hpp"
#include "translate/draw_inputs_parts.hpp"

namespace legacy_gl {

namespace {

/// GL 2.1 spec 3.5.5, "r".
double depth_resolution(const Context& context) {
  const PolygonState& polygon = context.raster.polygon;
  const bool enabled = polygon.offset_line_enabled || polygon.offset_point_enabled;
  if (!enabled || polygon.offset_units == 0) return 0;
  return std::ldexp(1.0, -framebuffer_bits(context, FramebufferChannel::kDepth));
}

struct Vertices {
  const float* data;
  std::size_t bytes, stride;
};

/// Both at once, at multiples of their strides: what comes between two writes to a stream may take
/// the place of the first.
std::array<std::size_t, 2> write_both(StreamBuffer& stream, const Vertices& first,
                                      const Vertices& second) {
  if (second.bytes == 0) return {stream.write(first.data, first.bytes, first.stride), 0};
  std::size_t at = 0;
  auto* const to = static_cast<std::byte*>(
      stream.map(first.bytes + second.stride + second.bytes, first.stride, at));
  const std::size_t behind = (at + first.bytes + second.stride - 1) / second.stride * second.stride;
  if (!to) return {at, behind};
  std::memcpy(to, first.data, first.bytes);
  std::memcpy(to + (behind - at), second.data, second.bytes);
  stream.unmap();
  return {at, behind};
}

}  // namespace

void widen_lines_of(Context& context, const VertexLayout& layout, const float* vertices) {
  Submission& submission = *context.submission;
  const WideLineState state{
      .modelview_projection = submission.inputs.transform.modelview_projection,
      .viewport = context.raster.viewport,
      .width = whole_line_width(context.raster.line)};
  submission.wide_vertices.clear();
  submission.wide_ends.clear();
  for (const PrimitiveGroup& group : submission.expanded.groups) {
    if (is_line(group.mode))
      widen_lines(layout, vertices, group.mode,
                  std::span(submission.expanded.indices).subspan(group.first, group.count), state,
                  submission.wide_vertices);
    submission.wide_ends.push_back(submission.wide_vertices.size());
  }
}

void stipple_lines_of(const Context& context) {
  Submission& submission = *context.submission;
  ExpandedBatch& expanded = submission.expanded;
  const Recorder& recorder = context.recorder;
  if (!expanded.own_vertices) {
    expanded.own_vertices = true;
    expanded.layout = recorder.layout();
    expanded.vertices.assign(
        recorder.data(),
        recorder.data() + std::size_t{recorder.vertex_count()} * recorder.offsets().stride);
  }
  const EnabledClipPlanes planes(submission.inputs);
  stipple_lines({.line = context.raster.line,
                 .modelview_projection = submission.inputs.transform.modelview_projection,
                 .viewport = context.raster.viewport,
                 .clip_planes = planes,
                 .flat = submission.inputs.key.flat,
                 .lit = submission.inputs.key.lit},
                expanded);
}

void draw_expanded(Context& context) {
  DriverObjects& objects = *context.driver;
  const Driver& driver = context.driver->functions;
  Submission& submission = *context.submission;
  const Recorder& recorder = context.recorder;
  const std::vector<PrimitiveRun>& runs = recorder.runs();
  const bool wide = widens_lines(context);
  const bool stippled = is_stippled(context.raster.line);
  prepare(context, recorder.layout());

  const ProgramKey& key = submission.inputs.key;
  const UnfilledState state{
      .polygon = context.raster.polygon,
      .viewport = context.raster.viewport,
      .modelview_projection = submission.inputs.transform.modelview_projection,
      .two_side = key.two_side,
      .flat = key.flat,
      .lighting_position = key.flat && key.lit && lighting_reads_position(key),
      .depth_resolution = depth_resolution(context),
      .line_stipple = stippled};
  ExpandedBatch& expanded = submission.expanded;
  expand_unfilled(
      {recorder.layout(), recorder.data(), recorder.vertex_count(), runs, recorder.elements()},
      state, expanded);
  if (stippled) stipple_lines_of(context);
  if (expanded.indices.empty()) return;

  const VertexLayout layout = expanded.own_vertices ? expanded.layout : recorder.layout();
  const std::size_t stride = offsets_of(layout).stride * sizeof(float);
  const std::size_t size = expanded.own_vertices ? expanded.vertices.size() * sizeof(float)
                                                 : recorder.vertex_count() * stride;
  const float* const vertices = expanded.own_vertices ? expanded.vertices.data() : recorder.data();
  if (wide) widen_lines_of(context, layout, vertices);
  const std::size_t wide_stride = offsets_of(widened_layout(layout)).stride * sizeof(float);
  const std::size_t wide_bytes = wide ? submission.wide_vertices.size() * sizeof(float) : 0;
  const auto [offset, wide_offset] =
      write_both(objects.vertex_stream, {vertices, size, stride},
                 {submission.wide_vertices.data(), wide_bytes, wide_stride});
  const auto base_vertex = static_cast<std::uint32_t>(offset / stride);
  for (std::uint32_t& index : expanded.indices) index += base_vertex;
  const std::size_t index_bytes = expanded.indices.size() * sizeof(std::uint32_t);
  const std::size_t indices =
      objects.index_stream.write(expanded.indices.data(), index_bytes, sizeof(std::uint32_t));
  context.statistics.vertex_bytes_uploaded += size + wide_bytes;
  context.statistics.vertices += recorder.vertex_count();
  context.statistics.index_bytes_uploaded += index_bytes;

  for (std::size_t g = 0; g < expanded.groups.size(); ++g) {
    const PrimitiveGroup& group = expanded.groups[g];
    if (!group.count) continue;
    ProgramKey variant = key;
    if (group.mode == GL_POINTS) choose_points(context, variant);
    variant.fragments.coverage = coverage_of(context.raster, group.mode);
    variant.back_only = group.back;
    variant.lighting_position = state.lighting_position;
    variant.depth_offset =
        group.mode != GL_TRIANGLES && (expanded.layout.fields & kFieldDepthOffset);
    const bool widened = wide && is_line(group.mode);
    if (widened) {
      variant.line_offset = true;
      variant.depth_offset = variant.fragments.fog_coordinate = false;
      const std::size_t begin = g ? submission.wide_ends[g - 1] : 0, end = submission.wide_ends[g];
      if (begin == end || !use_program(context, variant, recorder.vertex_count())) continue;
      context.driver->bind_vertex_array(objects.vertex_arrays.find_or_build(
          widened_layout(layout), objects.vertex_stream.name(), objects.index_stream.name()));
      driver.DrawArrays(GL_LINES,
                        static_cast<GLint>((wide_offset + begin * sizeof(float)) / wide_stride),
                        static_cast<GLsizei>((end - begin) * sizeof(float) / wide_stride));
      ++context.statistics.draws;
      continue;
    }
    if (!use_program(context, variant, recorder.vertex_count())) continue;
    context.driver->bind_vertex_array(objects.vertex_arrays.find_or_build(
        layout, objects.vertex_stream.name(), objects.index_stream.name()));
    driver.DrawElements(
        group.mode, static_cast<GLsizei>(group.count), GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(indices + group.first * sizeof(std::uint32_t)));
    ++context.statistics.draws;
  }
  ++context.statistics.batches;
}

}  // namespace legacy_gl
