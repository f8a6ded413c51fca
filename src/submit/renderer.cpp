#include "submit/renderer.hpp"

#include <algorithm>

#include "cpu_pipeline/feedback.hpp"
#include "cpu_pipeline/selection.hpp"
#include "geometry/primitives.hpp"
#include "geometry/wide_lines.hpp"
#include "record/pending.hpp"
#include "record/record_mesh.hpp"
#include "submit/batch.hpp"
#include "submit/bitmaps.hpp"
#include "submit/choose_path.hpp"
#include "submit/draw_scope.hpp"
#include "submit/expanded.hpp"
#include "submit/mesh.hpp"
#include "submit/path_state.hpp"
#include "submit/prepare.hpp"

namespace legacy_gl {

namespace {

constexpr PathChoice kJoinsBatch = {DrawPath::kRecorder,
                                    "a small mesh joins the batch, transformed or lit on the CPU"};

FastPath* fast_path_of(const Context& context) { return context.submission->fast_path.get(); }

bool has_polygons(const std::vector<PrimitiveRun>& runs) {
  return std::any_of(runs.begin(), runs.end(),
                     [](const PrimitiveRun& run) { return is_polygonal(run.mode); });
}

bool has_lines(const std::vector<PrimitiveRun>& runs) {
  return std::any_of(runs.begin(), runs.end(),
                     [](const PrimitiveRun& run) { return is_line(run.mode); });
}

/// Draws the recorder's batch, whose vertices are final.
void draw_rendered(Context& context) {
  Recorder& recorder = context.recorder;
  FastPath* const fast_path = fast_path_of(context);
  if (!fast_path || !fast_path->finish_batch(context)) enlarge_recorded_normals(context, 0);
  if (recorder.runs().empty()) return;  // nothing of it is visible
  const PathState state = path_state(context);
  const DrawRequest request{
      .source = DrawRequest::Source::kBatch,
      .has_polygons = state.unfilled && has_polygons(recorder.runs()),
      .has_lines = state.replaces_lines && has_lines(recorder.runs()),
  };
  const PathChoice choice = choose_path(request, state);
  const DrawScope scope(context, choice, recorder.runs(), recorder.vertex_count());
  if (choice.path == DrawPath::kExpanded) draw_expanded(context);
  else draw_batch_as_recorded(context);
}

}  // namespace

PathState path_state(const Context& context) {
  return {.renders = context.selection.is_rendering(),
          .unfilled = is_unfilled(context.raster.polygon),
          .replaces_lines = replaces_lines(context),
          .normalizes = context.transform.normalize_enabled,
          .paths = context.paths};
}

void DriverRenderer::draw_batch(Context& context) {
  Recorder& recorder = context.recorder;
  if (context.selection.is_rendering()) {
    draw_rendered(context);
    return recorder.clear();
  }
  const DrawScope scope(context, choose_path({}, path_state(context)), recorder.runs(),
                        recorder.vertex_count());
  if (context.selection.is_selecting()) select_recorded(context);
  else feed_back_recorded(context);
}

void DriverRenderer::draw_bitmaps(Context& context) { legacy_gl::draw_bitmaps(context); }

void DriverRenderer::draw_mesh(Context& context, const ListMesh& mesh) {
  const PathState state = path_state(context);
  const DrawRequest request{
      .source = DrawRequest::Source::kMesh,
      .has_polygons = state.unfilled && has_polygons(mesh.runs),
      .has_lines = state.replaces_lines && has_lines(mesh.runs),
      .has_tiny_normals = mesh.tiny_normals,
  };
  const PathChoice choice = choose_path(request, state);
  if (choice.path == DrawPath::kRecorder) {
    const DrawScope scope(context, choice, mesh.runs, mesh.vertex_count());
    return record_mesh(context, mesh);
  }
  FastPath* const fast_path = fast_path_of(context);
  if (fast_path && fast_path->append_mesh(context, mesh)) {
    const DrawScope scope(context, kJoinsBatch, mesh.runs, mesh.vertex_count());
    return;
  }
  flush_pending(context);
  const DrawScope scope(context, choice, mesh.runs, mesh.vertex_count());
  draw_mesh_from_buffers(context, mesh);
}

bool DriverRenderer::detach_from_matrices(Context& context) {
  FastPath* const fast_path = fast_path_of(context);
  return fast_path && fast_path->detach_from_matrices(context);
}

bool DriverRenderer::shade_batch(Context& context) {
  FastPath* const fast_path = fast_path_of(context);
  return fast_path && fast_path->shade_batch(context);
}

void DriverRenderer::recover(Context& context) noexcept {
  forget_driver_state(context);
  context.driver->bitmaps.clear();
  context.submission->dirty.note(kDirtyAll);
  context.submission->uniforms.forget_staged();
}

bool DriverRenderer::shades_next_draw(Context& context) {
  FastPath* const fast_path = fast_path_of(context);
  return fast_path && fast_path->shades_next_draw(context);
}

}  // namespace legacy_gl
