// The recorder's batch: what Begin/End, small client arrays and meshes that join it have brought
// together.
#include "submit/batch.hpp"

#include "geometry/clip_test.hpp"
#include "geometry/primitives.hpp"
#include "geometry/tiny_normals.hpp"
#include "record/pending.hpp"
#include "submit/prepare.hpp"
#include "translate/draw_inputs_parts.hpp"

namespace legacy_gl {

namespace {

/// Whether the reference draws this run in its primitive pipeline, which splits quads the other
/// way.
bool splits_in_pipeline(const DrawInputs& inputs, const Recorder& recorder,
                        const PrimitiveRun& run) {
  if (run.mode != GL_QUADS || run.indexed) return false;
  if (inputs.key.flat) return true;
  const unsigned stride = recorder.offsets().stride;
  return any_outside(inputs.transform.modelview_projection, EnabledClipPlanes(inputs),
                     recorder.data() + std::size_t{run.first} * stride, run.count, stride,
                     recorder.offsets().position_size == 4);
}

void draw_runs(Context& context, std::uint32_t base_vertex) {
  DriverObjects& objects = *context.driver;
  const Driver& driver = context.driver->functions;
  Submission& submission = *context.submission;
  const Recorder& recorder = context.recorder;
  const std::vector<PrimitiveRun>& runs = recorder.runs();
  const auto needs_indices = [](const PrimitiveRun& run) {
    return run.indexed || !draws_without_indices(run.mode);
  };
  for (std::size_t at = 0; at < runs.size();) {
    // Neighbours that the driver can draw in one call go together.
    const GLenum mode = core_mode(runs[at].mode);
    const bool indexed = needs_indices(runs[at]);
    submission.firsts.clear();
    submission.counts.clear();
    submission.indices.clear();
    std::size_t end = at;
    do {
      const PrimitiveRun& run = runs[end++];
      if (indexed) {
        append_indices(run, recorder.elements(), base_vertex,
                       splits_in_pipeline(submission.inputs, recorder, run), submission.indices);
      } else {
        submission.firsts.push_back(static_cast<GLint>(run.first + base_vertex));
        submission.counts.push_back(static_cast<GLsizei>(run.count));
      }
    } while (end < runs.size() && core_mode(runs[end].mode) == mode &&
             needs_indices(runs[end]) == indexed && (!indexed || joins_in_one_draw(mode)) &&
             !runs[at].crosses_clip_volume && !runs[end].crosses_clip_volume);
    at = end;
    if (!use_program(context, mode, recorder.vertex_count())) continue;
    if (indexed) {
      const std::size_t size = submission.indices.size() * sizeof(std::uint32_t);
      const std::size_t offset =
          objects.index_stream.write(submission.indices.data(), size, sizeof(std::uint32_t));
      context.statistics.index_bytes_uploaded += size;
      driver.DrawElements(mode, static_cast<GLsizei>(submission.indices.size()), GL_UNSIGNED_INT,
                          reinterpret_cast<const void*>(offset));
      ++context.statistics.draws;
    } else if (submission.firsts.size() > 1 && driver.MultiDrawArrays) {
      driver.MultiDrawArrays(mode, submission.firsts.data(), submission.counts.data(),
                             static_cast<GLsizei>(submission.firsts.size()));
      ++context.statistics.draws;
    } else {
      for (std::size_t i = 0; i < submission.firsts.size(); ++i)
        driver.DrawArrays(mode, submission.firsts[i], submission.counts[i]);
      context.statistics.draws += submission.firsts.size();
    }
  }
}

std::uint32_t upload_vertices(Context& context) {
  const Recorder& recorder = context.recorder;
  const std::size_t stride = recorder.offsets().stride * sizeof(float);
  const std::size_t size = recorder.vertex_count() * stride;
  const std::size_t offset = context.driver->vertex_stream.write(recorder.data(), size, stride);
  context.statistics.vertex_bytes_uploaded += size;
  context.statistics.vertices += recorder.vertex_count();
  return static_cast<std::uint32_t>(offset / stride);
}

}  // namespace

void enlarge_recorded_normals(Context& context, std::uint32_t first) {
  Recorder& recorder = context.recorder;
  if (!context.transform.normalize_enabled ||
      !(recorder.layout().fields & (kFieldNormal | kFieldShaded)))
    return;
  const std::size_t stride = recorder.offsets().stride;
  enlarge_tiny_normals(recorder.data() + first * stride + recorder.offsets().normal, stride,
                       recorder.vertex_count() - first);
}

void draw_batch_as_recorded(Context& context) {
  DriverObjects& objects = *context.driver;
  const Recorder& recorder = context.recorder;
  DrawBounds bounds;
  DrawFacts facts;
  if (culls_lights(context) &&
      find_bounds(context, recorder.layout(), recorder.data(), recorder.vertex_count(), bounds))
    facts.bounds = &bounds;
  update_inputs(context, recorder.layout(), facts);
  if (all_beyond_one_plane(context.submission->inputs.transform.modelview_projection,
                           recorder.data(), recorder.vertex_count(), recorder.offsets().stride,
                           recorder.offsets().position_size == 4)) {
    ++context.statistics.primitives_clipped;
    return;
  }
  apply_inputs(context);
  const std::uint32_t base_vertex = upload_vertices(context);
  objects.bind_vertex_array(objects.vertex_arrays.find_or_build(
      recorder.layout(), objects.vertex_stream.name(), objects.index_stream.name()));
  draw_runs(context, base_vertex);
  ++context.statistics.batches;
}

}  // namespace legacy_gl
