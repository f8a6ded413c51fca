// Polygons that glPolygonMode turns into lines or points (GL 2.1 spec 3.5.4).
#include <algorithm>
#include <cmath>

#include "execute/framebuffer.hpp"
#include "geometry/line_stipple.hpp"
#include "submit/backend.hpp"
#include "translate/draw_inputs_parts.hpp"

namespace legacy_gl {

namespace {

/// What is lit depends on where it is.
bool reads_lighting_position(const ProgramKey& key) {
  return key.lit && (key.local_viewer ||
                     std::any_of(key.lights.begin(), key.lights.end(), [](const LightRun& run) {
                       return run.count && run.kind & kLightPoint;
                     }));
}

/// GL 2.1 spec 3.5.5, "r".
double depth_resolution(const Context& context) {
  const PolygonState& polygon = context.raster.polygon;
  const bool enabled = polygon.offset_line_enabled || polygon.offset_point_enabled;
  if (!enabled || polygon.offset_units == 0) return 0;
  return std::ldexp(1.0, -framebuffer_bits(context, FramebufferChannel::kDepth));
}

}  // namespace

void Backend::widen_lines_of(Context& context, const VertexLayout& layout, const float* vertices) {
  const WideLineState state{.modelview_projection = derived_.transform.modelview_projection,
                            .viewport = context.raster.viewport,
                            .width = whole_line_width(context.raster.line)};
  wide_scratch_.clear();
  wide_ends_.clear();
  for (const PrimitiveGroup& group : unfilled_scratch_.groups) {
    if (is_line(group.mode))
      widen_lines(layout, vertices, group.mode,
                  std::span(unfilled_scratch_.indices).subspan(group.first, group.count), state,
                  wide_scratch_);
    wide_ends_.push_back(wide_scratch_.size());
  }
}

void Backend::stipple_lines_of(const Context& context) {
  ExpandedBatch& expanded = unfilled_scratch_;
  const Recorder& recorder = context.recorder;
  if (!expanded.own_vertices) {
    expanded.own_vertices = true;
    expanded.layout = recorder.layout();
    expanded.vertices.assign(
        recorder.data(),
        recorder.data() + std::size_t{recorder.vertex_count()} * recorder.offsets().stride);
  }
  const EnabledClipPlanes planes(derived_);
  stipple_lines({.line = context.raster.line,
                 .modelview_projection = derived_.transform.modelview_projection,
                 .viewport = context.raster.viewport,
                 .clip_planes = planes,
                 .flat = derived_.key.flat},
                expanded);
}

bool Backend::draw_unfilled(Context& context) {
  const Recorder& recorder = context.recorder;
  const std::vector<PrimitiveRun>& runs = recorder.runs();
  const bool wide = widens_lines(context), unfilled = is_unfilled(context.raster.polygon);
  const bool stippled = is_stippled(context.raster.line);
  if (std::none_of(runs.begin(), runs.end(), [=](const PrimitiveRun& run) {
        return (unfilled && is_polygonal(run.mode)) || ((wide || stippled) && is_line(run.mode));
      }))
    return false;
  prepare(context, recorder.layout());

  const ProgramKey& key = derived_.key;
  const UnfilledState state{.polygon = context.raster.polygon,
                            .viewport = context.raster.viewport,
                            .modelview_projection = derived_.transform.modelview_projection,
                            .two_side = key.two_side,
                            .flat = key.flat,
                            .lighting_position = key.flat && reads_lighting_position(key),
                            .depth_resolution = depth_resolution(context),
                            .line_stipple = stippled};
  ExpandedBatch& expanded = unfilled_scratch_;
  expand_unfilled(
      {recorder.layout(), recorder.data(), recorder.vertex_count(), runs, recorder.elements()},
      state, expanded);
  if (stippled) stipple_lines_of(context);
  if (expanded.indices.empty()) return true;

  const VertexLayout layout = expanded.own_vertices ? expanded.layout : recorder.layout();
  const std::size_t stride = offsets_of(layout).stride * sizeof(float);
  const std::size_t size = expanded.own_vertices ? expanded.vertices.size() * sizeof(float)
                                                 : recorder.vertex_count() * stride;
  const float* const vertices = expanded.own_vertices ? expanded.vertices.data() : recorder.data();
  if (wide) widen_lines_of(context, layout, vertices);
  const auto base_vertex =
      static_cast<std::uint32_t>(vertices_.write(vertices, size, stride) / stride);
  for (std::uint32_t& index : expanded.indices) index += base_vertex;
  const std::size_t index_bytes = expanded.indices.size() * sizeof(std::uint32_t);
  const std::size_t indices =
      indices_.write(expanded.indices.data(), index_bytes, sizeof(std::uint32_t));
  context.statistics.vertex_bytes_uploaded += size;
  context.statistics.vertices += recorder.vertex_count();
  context.statistics.index_bytes_uploaded += index_bytes;

  std::size_t wide_vertices = 0, wide_stride = 0;
  if (wide && !wide_scratch_.empty()) {
    wide_stride = offsets_of(widened_layout(layout)).stride;
    const std::size_t bytes = wide_scratch_.size() * sizeof(float);
    wide_vertices = vertices_.write(wide_scratch_.data(), bytes, wide_stride * sizeof(float)) /
                    (wide_stride * sizeof(float));
    context.statistics.vertex_bytes_uploaded += bytes;
  }
  for (std::size_t g = 0; g < expanded.groups.size(); ++g) {
    const PrimitiveGroup& group = expanded.groups[g];
    if (!group.count) continue;
    ProgramKey variant = key;
    if (group.mode == GL_POINTS) draw_points(context, variant);
    variant.fragments.coverage = coverage_of(context.raster, group.mode);
    variant.back_only = group.back;
    variant.lighting_position = state.lighting_position;
    variant.depth_offset =
        group.mode != GL_TRIANGLES && (expanded.layout.fields & kFieldDepthOffset);
    const bool widened = wide && is_line(group.mode);
    if (widened) {
      variant.line_offset = true;
      variant.depth_offset = variant.fragments.fog_coordinate = false;
      const std::size_t begin = g ? wide_ends_[g - 1] : 0, end = wide_ends_[g];
      if (begin == end || !use_program(context, variant, recorder.vertex_count())) continue;
      bind_vertex_array(
          arrays_.find_or_build(widened_layout(layout), vertices_.name(), indices_.name()));
      driver.DrawArrays(GL_LINES, static_cast<GLint>(wide_vertices + begin / wide_stride),
                        static_cast<GLsizei>((end - begin) / wide_stride));
      ++context.statistics.draws;
      continue;
    }
    if (!use_program(context, variant, recorder.vertex_count())) continue;
    bind_vertex_array(arrays_.find_or_build(layout, vertices_.name(), indices_.name()));
    driver.DrawElements(
        group.mode, static_cast<GLsizei>(group.count), GL_UNSIGNED_INT,
        reinterpret_cast<const void*>(indices + group.first * sizeof(std::uint32_t)));
    ++context.statistics.draws;
  }
  ++context.statistics.batches;
  return true;
}

}  // namespace legacy_gl
