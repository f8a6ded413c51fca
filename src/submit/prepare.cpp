#include "submit/prepare.hpp"

#include "geometry/line_stipple.hpp"
#include "geometry/wide_lines.hpp"
#include "record/pending.hpp"
#include "shadergen/generate.hpp"

namespace legacy_gl {

void update_inputs(Context& context, const VertexLayout& layout, const DrawFacts& facts) {
  Submission& submission = *context.submission;
  context.dirty |=
      submission.dirty.take(context.dirty, DirtyReaders::kInputs) & ~std::uint32_t{kDirtyRaster};
  submission.inputs.update(context, layout, facts);
}

void apply_inputs(Context& context) {
  Submission& submission = *context.submission;
  submission.uniforms.upload(context, submission.inputs, submission.general_program);
  apply_raster(context);
  if (submission.inputs.key.textures.count)
    context.driver->textures.bind(active_textures(context.texture));
}

void prepare(Context& context, const VertexLayout& layout) {
  update_inputs(context, layout);
  apply_inputs(context);
}

void apply_raster(Context& context) {
  if (!(context.dirty & kDirtyRaster)) return;
  context.submission->dirty.note(kDirtyRaster);
  context.dirty &= ~std::uint32_t{kDirtyRaster};
  context.driver->raster.apply(context.driver->functions, context.raster,
                               context.transform.clip.enabled);
}

bool use_program(Context& context, GLenum mode, std::uint64_t vertices) {
  const ProgramKey& polygons = context.submission->inputs.key;
  const Coverage coverage = coverage_of(context.raster, mode);
  if (mode != GL_POINTS && coverage == Coverage::kWhole)
    return use_program(context, polygons, vertices);
  ProgramKey key = polygons;
  if (mode == GL_POINTS) choose_points(context, key);
  key.fragments.coverage = coverage;
  return use_program(context, key, vertices);
}

bool use_program(Context& context, const ProgramKey& key, std::uint64_t vertices) {
  DriverObjects& objects = *context.driver;
  const auto [program, general] = objects.programs.choose(key, vertices, context.statistics);
  if (!program) {
    diagnose(context, "the driver refused a generated program: " + objects.programs.error());
    return false;
  }
  if (objects.bind_program(program)) ++context.statistics.program_switches;
  Submission& submission = *context.submission;
  submission.general_program = general;
  if (general) submission.uniforms.upload(context, submission.inputs, true);
  return true;
}

void choose_points(const Context& context, ProgramKey& key) {
  key.points = true;
  const PointState& point = context.raster.point;
  if (!point.is_attenuated_or_fades()) return;
  key.point_fade = context.raster.multisample.enabled && point.fade_threshold > 0 &&
                   framebuffer_facts(context).has_sample_buffers;
  key.point_distance = true;
}

const FramebufferFacts& framebuffer_facts(const Context& context) {
  std::optional<FramebufferFacts>& facts = context.driver->framebuffer_facts;
  if (!facts) {
    GLint sample_buffers = 0;
    context.driver->functions.GetIntegerv(GL_SAMPLE_BUFFERS, &sample_buffers);
    facts = {sample_buffers > 0};
  }
  return *facts;
}

bool widens_lines(const Context& context) {
  return !context.driver->functions.traits.draws_wide_lines &&
         whole_line_width(context.raster.line) > 1;
}

bool replaces_lines(const Context& context) {
  return widens_lines(context) || is_stippled(context.raster.line);
}

const void* write_indices(Context& context, const void* indices, std::size_t size) {
  if (size == 0) return nullptr;
  context.statistics.index_bytes_uploaded += size;
  return reinterpret_cast<const void*>(
      context.driver->index_stream.write(indices, size, sizeof(std::uint32_t)));
}

void forget_driver_state(Context& context) {
  context.driver->forget_bindings();
  context.submission->dirty.note(kDirtyRaster);
  context.submission->inputs.stale.fill(true);
  context.dirty |= kDirtyRaster;
}

void free_deleted(Context& context) {
  context.driver->textures.free_deleted(*context.texture.shared->deleted);
  context.driver->free_deleted();
}

std::string program_source(Context& context) {
  flush_pending(context);
  update_inputs(context, Recorder::relevant_layout(context));
  ProgramKey key = context.submission->inputs.key;
  key.fragments.coverage = coverage_of(context.raster, GL_TRIANGLES);
  const ProgramSource source = generate(key, context.driver->functions.dialect);
  return source.vertex + "\n" + source.fragment;
}

}  // namespace legacy_gl
