#include "submit/backend.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "geometry/clip_test.hpp"
#include "geometry/primitives.hpp"
#include "geometry/tiny_normals.hpp"
#include "shadergen/generate.hpp"
#include "translate/draw_inputs_parts.hpp"

namespace legacy_gl {

namespace {

constexpr std::size_t kVertexRingBytes = std::size_t{8} << 20;
constexpr std::size_t kIndexRingBytes = std::size_t{2} << 20;
constexpr std::size_t kUniformRingBytes = std::size_t{1} << 20;

}  // namespace

Backend::Backend(const Driver& loaded, legacy_gl_programs programs, ProgramFiles files)
    : driver(loaded),
      buffers_(driver),
      queries_(driver),
      textures_(driver),
      programs_(driver, programs, std::move(files)),
      vertices_(driver, GL_ARRAY_BUFFER, kVertexRingBytes, StreamBuffer::Use::kOneDraw),
      indices_(driver, GL_COPY_WRITE_BUFFER, kIndexRingBytes, StreamBuffer::Use::kOneDraw),
      uniforms_(driver, GL_UNIFORM_BUFFER, kUniformRingBytes, StreamBuffer::Use::kManyDraws),
      arrays_(driver),
      meshes_(driver),
      buffer_arrays_(driver),
      bitmaps_(driver),
      pixel_texture_(driver),
      kept_batches_(driver) {
  if (!driver.traits.draws_wide_lines) raster_.keep_lines_thin();
  GLint alignment = 0;
  driver.GetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
  if (alignment > 0) uniform_alignment_ = static_cast<std::size_t>(alignment);
}

std::string Backend::program_source(Context& context) {
  flush_pending(context);
  derive(context, Recorder::relevant_layout(context));
  ProgramKey key = derived_.key;
  key.fragments.coverage = coverage_of(context.raster, GL_TRIANGLES);
  const ProgramSource source = generate(key, driver.dialect);
  return source.vertex + "\n" + source.fragment;
}

bool Backend::widens_lines(const Context& context) const {
  return !driver.traits.draws_wide_lines && whole_line_width(context.raster.line) > 1;
}

bool Backend::replaces_lines(const Context& context) const {
  return widens_lines(context) || is_stippled(context.raster.line);
}

void Backend::reset_driver_state() {
  bound_program_ = bound_array_ = 0;  // no name of ours
  raster_.forget();
  framebuffer_facts_.reset();
  unseen_[kKeptObjectsReader] = kDirtyAll;
  textures_.forget_bindings();
  derived_.stale.fill(true);
}

void Backend::apply_raster(Context& context) {
  if (!(context.dirty & kDirtyRaster)) return;
  unseen_[kKeptObjectsReader] |= kDirtyRaster;
  context.dirty &= ~std::uint32_t{kDirtyRaster};
  raster_.apply(driver, context.raster, context.transform.clip.enabled);
}

std::byte* Backend::stage_block(Context& context, UniformBlock block, std::size_t size,
                                std::size_t room) {
  const std::size_t offset =
      (block_scratch_.size() + uniform_alignment_ - 1) / uniform_alignment_ * uniform_alignment_;
  block_scratch_.resize(offset + room);
  staged_[staged_count_++] = {block, offset, room};
  derived_.stale[block] = false;
  context.statistics.uniform_bytes_uploaded += size;
  ++context.statistics.uniform_block_updates;
  return block_scratch_.data() + offset;
}

void Backend::stage_block(Context& context, UniformBlock block, const void* data,
                          std::size_t size) {
  std::memcpy(stage_block(context, block, size, size), data, size);
}

void Backend::upload_staged() {
  if (staged_count_ == 0) return;
  const std::size_t at =
      uniforms_.write(block_scratch_.data(), block_scratch_.size(), uniform_alignment_);
  for (unsigned i = 0; i < staged_count_; ++i)
    driver.BindBufferRange(GL_UNIFORM_BUFFER, staged_[i].block, uniforms_.name(),
                           static_cast<GLintptr>(at + staged_[i].offset),
                           static_cast<GLsizeiptr>(staged_[i].room));
  staged_count_ = 0;
  block_scratch_.clear();
}

void Backend::upload_uniforms(Context& context) {
  const std::uint64_t round = uniforms_.rounds();
  upload_stale_blocks(context);
  if (uniforms_.rounds() == round) return;
  // The ring began anew: blocks that are not stale are bound to memory that is no longer theirs.
  derived_.stale.fill(true);
  upload_stale_blocks(context);
}

void Backend::stage_with_tail(Context& context, UniformBlock block, const void* head,
                              std::size_t head_size, const void* tail, std::size_t tail_size,
                              std::size_t room) {
  const std::size_t size = head_size + tail_size;
  std::byte* const to = stage_block(context, block, size, std::max(room, size));
  if (head_size) std::memcpy(to, head, head_size);
  if (tail_size) std::memcpy(to + head_size, tail, tail_size);
}

void Backend::upload_stale_blocks(Context& context) {
  stage_stale_blocks(context);
  upload_staged();
}

/// All that go up together share one mapping of the ring.
void Backend::stage_stale_blocks(Context& context) {
  if (derived_.stale[kTransformBlock])
    stage_block(context, kTransformBlock, &derived_.transform, sizeof derived_.transform);
  if (derived_.stale[kPointsBlock] && context.raster.point.is_attenuated_or_fades())
    stage_block(context, kPointsBlock, &derived_.points, sizeof derived_.points);
  const FragmentKey& fragments = derived_.key.fragments;
  if (derived_.stale[kFragmentsBlock] && (fragments.has_fog() || fragments.has_alpha_test()))
    stage_block(context, kFragmentsBlock, &derived_.fragments, sizeof derived_.fragments);
  if (derived_.stale[kClipPlanesBlock] && fragments.clip_planes)
    stage_block(context, kClipPlanesBlock, &derived_.clip_planes, sizeof derived_.clip_planes);
  if (derived_.stale[kPolygonStippleBlock] && context.raster.polygon.stipple_enabled)
    stage_block(context, kPolygonStippleBlock, &derived_.polygon_stipple,
                sizeof derived_.polygon_stipple);
  if (derived_.key.textures.count && derived_.stale[kTexturesBlock])
    stage_with_tail(context, kTexturesBlock, &derived_.textures, sizeof derived_.textures,
                    derived_.texture_units.data(),
                    derived_.texture_units.size() * sizeof(TextureUnitUniforms), 0);
  if (!derived_.key.lit) return;
  const bool general = general_program_;
  if (general && derived_.stale[kGeneralBlock]) {
    derived_.fill_general(context);
    stage_block(context, kGeneralBlock, &derived_.general, sizeof derived_.general);
  }
  // Programs that are not made for this number of lights have arrays of a power of two.
  std::size_t capacity = kGeneralLights;
  while (capacity < derived_.lights.size()) capacity *= 2;
  if (derived_.stale[kLightsBlock] && (general || !derived_.lights.empty()))
    stage_with_tail(context, kLightsBlock, nullptr, 0, derived_.lights.data(),
                    derived_.lights.size() * sizeof(LightUniforms),
                    capacity * sizeof(LightUniforms));
  for (unsigned face = 0; face < (derived_.key.two_side ? 2u : 1u); ++face) {
    if (!derived_.stale[kFrontBlock + face]) continue;
    const FaceUniforms& uniforms = derived_.faces[face];
    stage_with_tail(context, static_cast<UniformBlock>(kFrontBlock + face), &uniforms.head,
                    sizeof uniforms.head, uniforms.products.data(),
                    uniforms.products.size() * sizeof(LightProducts),
                    sizeof uniforms.head + capacity * sizeof(LightProducts));
  }
  if (derived_.stale[kPreciseBlock] && derived_.key.quality == Quality::kPrecise)
    stage_with_tail(context, kPreciseBlock, &derived_.precise, sizeof derived_.precise,
                    derived_.lights_low.data(), derived_.lights_low.size() * sizeof(LightLow), 0);
}

std::uint32_t Backend::take_dirty_bits(const Context& context, DirtyReader reader) {
  for (std::uint32_t& unseen : unseen_) unseen |= context.dirty;
  return std::exchange(unseen_[reader], 0);
}

void Backend::derive(Context& context, const VertexLayout& layout, const DrawFacts& facts) {
  context.dirty |= take_dirty_bits(context, kDerivedReader) & ~std::uint32_t{kDirtyRaster};
  derived_.update(context, layout, driver.dialect, facts);
}

void Backend::prepare(Context& context, const VertexLayout& layout) {
  derive(context, layout);
  apply_derived(context);
}

void Backend::apply_derived(Context& context) {
  upload_uniforms(context);
  apply_raster(context);
  if (derived_.key.textures.count) textures_.bind(active_textures(context));
}

bool Backend::use_program(Context& context, GLenum mode, std::uint64_t vertices) {
  const Coverage coverage = coverage_of(context.raster, mode);
  if (mode != GL_POINTS && coverage == Coverage::kWhole)
    return use_program(context, derived_.key, vertices);
  ProgramKey key = derived_.key;
  if (mode == GL_POINTS) draw_points(context, key);
  key.fragments.coverage = coverage;
  return use_program(context, key, vertices);
}

void Backend::draw_points(const Context& context, ProgramKey& key) {
  key.points = true;
  const PointState& point = context.raster.point;
  if (!point.is_attenuated_or_fades()) return;
  key.point_fade = context.raster.multisample.enabled && point.fade_threshold > 0 &&
                   framebuffer_facts(context).has_sample_buffers;
  key.point_distance = true;
}

bool Backend::use_program(Context& context, const ProgramKey& key, std::uint64_t vertices) {
  const auto [program, general] = programs_.choose(key, vertices, context.statistics);
  if (!program) {
    diagnose(context, "the driver refused a generated program: " + programs_.error());
    return false;
  }
  if (program != bound_program_) {
    programs_.bind(program, bound_program_ != 0);
    bound_program_ = program;
    ++context.statistics.program_switches;
  }
  general_program_ = general;
  if (general) upload_uniforms(context);
  return true;
}

void Backend::bind_vertex_array(GLuint array) {
  if (array == bound_array_) return;
  driver.BindVertexArray(array);
  bound_array_ = array;
}

std::uint32_t Backend::upload_vertices(Context& context) {
  const Recorder& recorder = context.recorder;
  const std::size_t stride = recorder.offsets().stride * sizeof(float);
  const std::size_t size = recorder.vertex_count() * stride;
  const std::size_t offset = vertices_.write(recorder.data(), size, stride);
  context.statistics.vertex_bytes_uploaded += size;
  context.statistics.vertices += recorder.vertex_count();
  return static_cast<std::uint32_t>(offset / stride);
}

/// Whether the reference draws this run in its primitive pipeline, which splits quads the other
/// way.
bool Backend::splits_in_pipeline(const Recorder& recorder, const PrimitiveRun& run) const {
  if (run.mode != GL_QUADS || run.indexed) return false;
  if (derived_.key.flat) return true;
  const unsigned stride = recorder.offsets().stride;
  return any_outside(derived_.transform.modelview_projection, EnabledClipPlanes(derived_),
                     recorder.data() + std::size_t{run.first} * stride, run.count, stride,
                     recorder.offsets().position_size == 4);
}

void Backend::draw_runs(Context& context, std::uint32_t base_vertex) {
  const Recorder& recorder = context.recorder;
  const std::vector<PrimitiveRun>& runs = recorder.runs();
  const auto needs_indices = [](const PrimitiveRun& run) {
    return run.indexed || !draws_without_indices(run.mode);
  };
  for (std::size_t at = 0; at < runs.size();) {
    // Neighbours that the driver can draw in one call go together.
    const GLenum mode = core_mode(runs[at].mode);
    const bool indexed = needs_indices(runs[at]);
    first_scratch_.clear();
    count_scratch_.clear();
    index_scratch_.clear();
    std::size_t end = at;
    do {
      const PrimitiveRun& run = runs[end++];
      if (indexed) {
        append_indices(run, recorder.elements(), base_vertex, splits_in_pipeline(recorder, run),
                       index_scratch_);
      } else {
        first_scratch_.push_back(static_cast<GLint>(run.first + base_vertex));
        count_scratch_.push_back(static_cast<GLsizei>(run.count));
      }
    } while (end < runs.size() && core_mode(runs[end].mode) == mode &&
             needs_indices(runs[end]) == indexed && (!indexed || joins_in_one_draw(mode)) &&
             !runs[at].apart && !runs[end].apart);
    at = end;
    if (!use_program(context, mode, recorder.vertex_count())) continue;
    if (indexed) {
      const std::size_t size = index_scratch_.size() * sizeof(std::uint32_t);
      const std::size_t offset = indices_.write(index_scratch_.data(), size, sizeof(std::uint32_t));
      context.statistics.index_bytes_uploaded += size;
      driver.DrawElements(mode, static_cast<GLsizei>(index_scratch_.size()), GL_UNSIGNED_INT,
                          reinterpret_cast<const void*>(offset));
      ++context.statistics.draws;
    } else if (first_scratch_.size() > 1 && driver.MultiDrawArrays) {
      driver.MultiDrawArrays(mode, first_scratch_.data(), count_scratch_.data(),
                             static_cast<GLsizei>(first_scratch_.size()));
      ++context.statistics.draws;
    } else {
      for (std::size_t i = 0; i < first_scratch_.size(); ++i)
        driver.DrawArrays(mode, first_scratch_[i], count_scratch_[i]);
      context.statistics.draws += first_scratch_.size();
    }
  }
}

/// Of recorded vertices from `first` on.
void Backend::enlarge_normals(Context& context, std::uint32_t first) {
  Recorder& recorder = context.recorder;
  if (!context.transform.normalize_enabled ||
      !(recorder.layout().fields & (kFieldNormal | kFieldLit)))
    return;
  const std::size_t stride = recorder.offsets().stride;
  enlarge_tiny_normals(recorder.data() + first * stride + recorder.offsets().normal, stride,
                       recorder.vertex_count() - first);
}

void Backend::draw_batch(Context& context) {
  Recorder& recorder = context.recorder;
  if (recorder.runs().empty()) return;
  if (recorder.is_lit()) light_vertices(context);
  else if (recorder.layout().fields & kFieldTransformed) transform_vertices(context);
  else enlarge_normals(context, 0);
  if (recorder.runs().empty()) return;  // nothing of it is seen
  if ((is_unfilled(context.raster.polygon) || replaces_lines(context)) && draw_unfilled(context))
    return;
  DrawBounds bounds;
  DrawFacts facts;
  if (looks_at_reach(context) && find_bounds(context, bounds)) facts.bounds = &bounds;
  derive(context, recorder.layout(), facts);
  if (all_beyond_one_plane(derived_.transform.modelview_projection, recorder.data(),
                           recorder.vertex_count(), recorder.offsets().stride,
                           recorder.offsets().position_size == 4)) {
    ++context.statistics.primitives_clipped;
    return;
  }
  apply_derived(context);
  const std::uint32_t base_vertex = upload_vertices(context);
  const GLuint array = arrays_.find_or_build(recorder.layout(), vertices_.name(), indices_.name());
  bind_vertex_array(array);
  draw_runs(context, base_vertex);
  ++context.statistics.batches;
  if (recorder.is_lit() && kept_batches_.drawn(recorder)) bound_array_ = 0;  // another was bound
}

/// The parts that were as they had been, before one that is not.
void Backend::draw_held(Context& context) {
  if (repeated_batches_.held_vertices() == 0) return;
  Recorder& recorder = context.recorder;
  const VertexLayout layout = recorder.layout();
  const std::uint32_t count = recorder.vertex_count();
  const std::vector<float> vertices(
      recorder.data(), recorder.data() + std::size_t{count} * recorder.offsets().stride);
  const std::vector<PrimitiveRun> runs = recorder.runs();
  const std::shared_ptr<ListMesh> mesh = repeated_batches_.mesh();
  recorder.load(mesh->layout, mesh->vertices.data(), repeated_batches_.held_vertices(),
                mesh->runs.data(), repeated_batches_.held_runs());
  draw_batch(context);
  recorder.load(layout, vertices.data(), count, runs.data(), runs.size());
}

void Backend::draw_recorded(Context& context, bool last) {
  draw_followed(context);
  using Answer = RepeatedBatches::Answer;
  const Answer answer =
      skips_unseen(context) ? repeated_batches_.take(context, last) : Answer::kDraw;
  if (answer == Answer::kComplete) draw_mesh(context, *repeated_batches_.mesh());
  if (answer == Answer::kDifferent) draw_held(context);
  if (answer == Answer::kDraw || answer == Answer::kDifferent) draw_batch(context);
  kept_batches_.forget_noted();
  if (repeated_batches_.goes_on()) context.recorder.forget_part();
  else context.recorder.clear();
}

}  // namespace legacy_gl
