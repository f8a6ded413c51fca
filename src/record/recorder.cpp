#include "record/recorder.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "record/pending.hpp"

namespace legacy_gl {

namespace {

/// A batch this large is drawn at the next glEnd: memory stays bounded, and the driver starts
/// early.
constexpr std::size_t kFlushFloats = std::size_t{1} << 16;
constexpr std::size_t kFirstFloats = std::size_t{1} << 14;

template <typename V>
float* put(float* at, const V& value, unsigned size) {
  std::memcpy(at, &value[0], size * sizeof(float));
  return at + size;
}

/// Everything behind the position.
float* put_fields(const Context& context, const VertexLayout& layout, float* at) {
  if (layout.fields & (kFieldNormal | kFieldShaded)) at = put(at, context.current.normal, 3);
  if (layout.fields & kFieldColor) at = put(at, context.current.color, 4);
  if (layout.fields & kFieldSecondaryColor) at = put(at, context.current.secondary_color, 3);
  if (layout.fields & kFieldFogCoord) *at++ = context.current.fog_coordinate;
  if (layout.texcoords) {
    for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
      if (layout.texcoords & 1u << unit)
        at = put(at, context.current.texture_coordinates[unit], texcoord_size(layout, unit));
  }
  if (layout.materials) {
    for (unsigned i = 0; i < 2 * kPropertyCount; ++i)
      if (layout.materials & (1u << i))
        at = put(at,
                 material_value(context.lighting.materials, i / kPropertyCount, i % kPropertyCount),
                 material_size(i % kPropertyCount));
  }
  if (layout.fields & kFieldEdgeFlag) *at++ = context.current.edge_flag ? 1.0f : 0.0f;
  return at;
}

/// Two floats do not say all of it.
bool is_wide(const glm::vec4& coordinates) { return coordinates.z != 0 || coordinates.w != 1; }

bool list_of_independent_primitives(GLenum mode) {
  return mode == GL_POINTS || mode == GL_LINES || mode == GL_TRIANGLES || mode == GL_QUADS;
}

/// `run` goes on where `last` ends.
bool joins(const PrimitiveRun& last, const PrimitiveRun& run) {
  return last.mode == run.mode && last.indexed == run.indexed && !last.crosses_clip_volume &&
         !run.crosses_clip_volume && list_of_independent_primitives(run.mode) &&
         last.first + last.count == run.first;
}

}  // namespace

VertexLayout Recorder::relevant_layout(const Context& context) {
  VertexLayout layout;
  if (context.lighting.enabled) {
    layout.fields = kFieldNormal;
    if (context.lighting.color_material.enabled) layout.fields |= kFieldColor;
  } else {
    layout.fields = kFieldColor;
    if (context.color_sum_enabled) layout.fields |= kFieldSecondaryColor;
  }
  if (context.fog.enabled && context.fog.coordinate_source == GL_FOG_COORD)
    layout.fields |= kFieldFogCoord;
  if (is_unfilled(context.raster.polygon)) layout.fields |= kFieldEdgeFlag;
  if (const ActiveTextures& textures = active_textures(context.texture); textures.mask) {
    if (textures.reads_normal) layout.fields |= kFieldNormal;
    layout.texcoords = textures.from_vertex;
    for (unsigned unit = 0; unit < textures.count; ++unit)
      if (layout.texcoords & 1u << unit && is_wide(context.current.texture_coordinates[unit]))
        layout.wide_texcoords |= static_cast<std::uint8_t>(1u << unit);
  }
  if (context.selection.is_feeding_back() && context.feedback.has_texture()) {
    layout.fields |= kFieldNormal;
    layout.texcoords |= 1;
    layout.wide_texcoords |= 1;
  }
  return layout;
}

void Recorder::start_batch(Context& context) {
  // A small object is not to be divided between two batches.
  if (is_shaded() &&
      (recorded_floats() + std::size_t{kSmallDrawVertices} * kShadedStride > kFlushFloats ||
       !shades_next_draw(context)))
    draw_pending(context);
  if (has_pending()) return;
  if (context.bitmaps_pending) draw_pending(context);
  VertexLayout layout = relevant_layout(context);
  note_small_draw(context);
  joining_ = worth_trying();
  if (skip_) --skip_;
  if (joining_ && context.lighting.enabled) layout.materials = usual_materials_;
  set_layout(layout);
  cursor_ = storage_.get();
}

void Recorder::note_small_draw(const Context& context) {
  constexpr std::uint32_t kOfObjects = kDirtyTransform | kDirtyMaterial;
  const bool alike = !(context.dirty & ~kOfObjects);
  similar_draws_ = alike ? std::min(similar_draws_ + 1, kSimilarDraws) : 0;
}

bool Recorder::joins_small_draws(const Context& context) {
  if (!has_pending()) note_small_draw(context);
  const bool joins = has_pending() ? joining_ : worth_trying();
  if (skip_ && !has_pending()) --skip_;
  tried_joining_ = tried_joining_ || joins;
  return joins;
}

void Recorder::end_small_draw(bool crosses_clip_volume) {
  tried_joining_ = true;
  if (vertex_count() == small_draw_first_) return;
  ++small_draws_;
  small_draw_first_ = vertex_count();
  const std::size_t run = std::exchange(small_draw_run_, runs_.size());
  if (crosses_clip_volume) {
    for (std::size_t i = run; i < runs_.size(); ++i) runs_[i].crosses_clip_volume = true;
  } else if (run && run + 1 == runs_.size() && runs_[run].mode != GL_QUADS &&
             joins(runs_[run - 1], runs_[run])) {
    runs_[run - 1].count += runs_[run].count;
    runs_.pop_back();
    small_draw_run_ = runs_.size();
  }
}

void Recorder::become_shaded(Context& context) {
  VertexLayout lit;
  lit.fields = kFieldTransformed | kFieldShaded;
  if (has_pending()) return widen(context, lit);
  start_batch(context);
  set_layout(lit);
}

float* Recorder::append_shaded(std::uint32_t count) {
  reserve(count);
  float* const vertices = cursor_;
  cursor_ += std::size_t{count} * offsets_.stride;
  return vertices;
}

void Recorder::put_template(const Context& context, float* vertex) {
  VertexLayout others = layout_;
  others.materials = 0;
  put_fields(context, others, vertex + offsets_.position_size);
  if (layout_.materials) put_materials(context, vertex + offsets_.materials_begin);
  if (layout_.fields & kFieldEdgeFlag)
    vertex[offsets_.edge_flag] = context.current.edge_flag ? 1.0f : 0.0f;
}

void Recorder::add_fields(const Context& context, std::uint16_t fields) {
  VertexLayout layout = layout_;
  layout.fields |= fields;
  if (layout != layout_) widen(context, layout);
}

float* Recorder::put_materials(const Context& context, float* at) {
  if (!materials_cached_) {
    float* to = materials_.data();
    for (unsigned i = 0; i < 2 * kPropertyCount; ++i)
      if (layout_.materials & (1u << i))
        to = put(to,
                 material_value(context.lighting.materials, i / kPropertyCount, i % kPropertyCount),
                 material_size(i % kPropertyCount));
    materials_cached_ = true;
  }
  const unsigned count = offsets_.materials_end - offsets_.materials_begin;
  return std::copy_n(materials_.data(), count, at);
}

void Recorder::set_layout(const VertexLayout& layout) {
  layout_ = layout;
  offsets_ = offsets_of(layout);
  materials_cached_ = false;
  shape_ = Shape::kOther;
  if (layout.fields == (kFieldTransformed | kFieldShaded)) shape_ = Shape::kShaded;
  if (layout.materials || layout.wide_texcoords || layout.texcoords > 1) return;
  if (layout.texcoords) {
    if (layout.fields == kFieldNormal) shape_ = Shape::kNormalAndTexcoord;
    if (layout.fields == kFieldColor) shape_ = Shape::kColorAndTexcoord;
    return;
  }
  if (layout.fields == kFieldNormal) shape_ = Shape::kNormal;
  if (layout.fields == kFieldColor) shape_ = Shape::kColor;
  if (layout.fields == (kFieldNormal | kFieldColor)) shape_ = Shape::kNormalAndColor;
}

void Recorder::set_limit() {
  limit_ = inside_begin_end() ? storage_.get() + (capacity_floats_ - offsets_.stride + 1) : nullptr;
}

void Recorder::reserve(std::uint32_t more_vertices) {
  const std::size_t used = static_cast<std::size_t>(cursor_ - storage_.get());
  const std::size_t wanted = used + std::size_t{more_vertices} * offsets_.stride;
  if (wanted > capacity_floats_) {
    const std::size_t capacity = std::max({wanted, 2 * capacity_floats_, kFirstFloats});
    std::unique_ptr<float[]> storage(new float[capacity + kSlackFloats]);
    if (used) std::memcpy(storage.get(), storage_.get(), used * sizeof(float));
    storage_ = std::move(storage);
    capacity_floats_ = capacity;
  }
  cursor_ = storage_.get() + used;
  set_limit();
}

void Recorder::begin(Context& context, GLenum mode) {
  start_batch(context);
  set_activity(kInside, true);
  mode_ = mode;
  reserve(4);
  first_ = vertex_count();
}

float* Recorder::emit(Context& context) {
  if (cursor_ >= limit_) reserve(1);
  float* const vertex = cursor_;
  put_template(context, vertex);
  cursor_ = vertex + offsets_.stride;
  return vertex;
}

void Recorder::vertex(Context& context, float x, float y, float z) {
  float* const vertex = cursor_;
  if (vertex >= limit_) [[unlikely]]
    return vertex_slowly(context, x, y, z);
  const auto position = [=] {
    vertex[0] = x;
    vertex[1] = y;
    vertex[2] = z;
  };
  switch (shape_) {
    case Shape::kNormal:
      position();
      cursor_ = put(vertex + 3, context.current.normal, 3);
      break;
    case Shape::kShaded:
      position();
      vertex[3] = 1;
      put(vertex + 4, context.current.normal, 3);
      cursor_ = vertex + 8;
      break;
    case Shape::kColor:
      position();
      cursor_ = put(vertex + 3, context.current.color, 4);
      break;
    case Shape::kNormalAndColor:
      position();
      cursor_ = put(put(vertex + 3, context.current.normal, 3), context.current.color, 4);
      break;
    case Shape::kNormalAndTexcoord:
      position();
      cursor_ = put(put(vertex + 3, context.current.normal, 3),
                    context.current.texture_coordinates[0], 2);
      break;
    case Shape::kColorAndTexcoord:
      position();
      cursor_ =
          put(put(vertex + 3, context.current.color, 4), context.current.texture_coordinates[0], 2);
      break;
    case Shape::kOther: vertex_slowly(context, x, y, z); break;
  }
}

/// What is complete of a long glBegin(GL_TRIANGLES) and its like is drawn while it is being given:
/// it is still in the processor's caches, and the memory stays bounded.
void Recorder::draw_part(Context& context) {
  if (is_shaded()) before_lighting_change(context);  // the rest keeps its colours
  const unsigned size = mode_ == GL_TRIANGLES ? 3 : mode_ == GL_LINES ? 2 : 1;
  const std::uint32_t rest = (vertex_count() - first_) % size;
  const std::size_t rest_floats = std::size_t{rest} * offsets_.stride;
  std::array<float, 2 * kMaxVertexFloats> kept;
  std::copy_n(cursor_ - rest_floats, rest_floats, kept.begin());
  const VertexLayout layout = layout_;
  end(context);
  if (!runs_.empty()) draw_part_of_batch(context);
  begin(context, mode_);
  if (rest) {
    set_layout(layout);
    reserve(rest + 1);
    cursor_ = std::copy_n(kept.begin(), rest_floats, cursor_);
    if (is_shaded()) set_all_transformed();
  }
}

void Recorder::vertex_slowly(Context& context, float x, float y, float z) {
  if (!inside_begin_end()) return;  // undefined outside Begin/End (GL 2.1 spec 2.6.1): ignored
  const bool independent = mode_ == GL_TRIANGLES || mode_ == GL_LINES || mode_ == GL_POINTS;
  if (independent && cursor_ >= limit_ && recorded_floats() + kMaxVertexFloats > kFlushFloats)
    draw_part(context);
  float* const vertex = emit(context);
  vertex[0] = x;
  vertex[1] = y;
  vertex[2] = z;
  if (offsets_.position_size == 4) vertex[3] = 1;
}

void Recorder::vertex(Context& context, float x, float y, float z, float w) {
  if (!inside_begin_end()) return;
  if (w != 1 && offsets_.position_size == 3) {
    VertexLayout with_w = layout_;
    with_w.fields |= kFieldPositionW;
    widen(context, with_w);
  }
  float* const vertex = emit(context);
  vertex[0] = x;
  vertex[1] = y;
  vertex[2] = z;
  if (offsets_.position_size == 4) vertex[3] = w;
}

void Recorder::close_run(Context& context, GLenum mode, std::uint32_t first) {
  const std::uint32_t count = whole_primitives(mode, vertex_count() - first);
  cursor_ = storage_.get() + std::size_t{first + count} * offsets_.stride;
  if (count) add_run(context, {mode, first, count});
}

void Recorder::add_run(Context& context, const PrimitiveRun& run) {
  if (!runs_.empty()) {
    ++context.statistics.begin_end_merged;
    PrimitiveRun& last = runs_.back();
    if (runs_.size() > small_draw_run_ && joins(last, run)) {
      last.count += run.count;
      return;
    }
  }
  runs_.push_back(run);
  runs_changed();
}

void Recorder::put_current(const Context& context, const VertexLayout& layout, float* vertices,
                           std::uint32_t count) {
  const VertexOffsets offsets = offsets_of(layout);
  const std::size_t stride = offsets.stride, position_size = offsets.position_size;
  put_fields(context, layout, vertices + position_size);
  for (std::uint32_t i = 1; i < count; ++i)
    std::memcpy(vertices + i * stride + position_size, vertices + position_size,
                (stride - position_size) * sizeof(float));
}

void Recorder::flush_if_large(Context& context) {
  if (recorded_floats() > kFlushFloats) draw_part_of_batch(context);
}

void Recorder::end(Context& context) {
  set_activity(kInside, false);
  limit_ = nullptr;
  close_run(context, mode_, first_);
  flush_if_large(context);
}

float* Recorder::append_vertices(Context& context, std::uint32_t count, bool with_w,
                                 std::uint8_t wide_texcoords) {
  start_batch(context);
  VertexLayout wide = layout_;
  if (with_w) wide.fields |= kFieldPositionW;
  wide.wide_texcoords |= static_cast<std::uint8_t>(wide_texcoords & wide.texcoords);
  if (wide != layout_) widen(context, wide);
  reserve(count);
  float* const vertices = cursor_;
  cursor_ += std::size_t{count} * offsets_.stride;
  return vertices;
}

void Recorder::append_run(Context& context, GLenum mode, std::uint32_t count) {
  close_run(context, mode, vertex_count() - count);
}

std::uint32_t* Recorder::append_elements(Context& context, GLenum mode, std::uint32_t count) {
  const std::size_t first = elements_.size();
  elements_.resize(first + count);
  add_run(context, {mode, static_cast<std::uint32_t>(first), count, true});
  return elements_.data() + first;
}

void Recorder::widen(const Context& context, const VertexLayout& layout) {
  const std::uint32_t count = vertex_count();
  const VertexOffsets old = offsets_;
  const VertexOffsets wide = offsets_of(layout);
  const std::size_t wanted = std::max(capacity_floats_, 2 * std::size_t{count + 4} * wide.stride);
  std::swap(storage_, spare_);
  std::swap(capacity_floats_, spare_floats_);
  if (capacity_floats_ < wanted) {
    storage_.reset(new float[wanted + kSlackFloats]);
    capacity_floats_ = wanted;
  }
  const unsigned old_rest = old.stride - old.position_size;
  for (std::uint32_t i = 0; i < count; ++i) {
    const float* const from = spare_.get() + std::size_t{i} * old.stride;
    float* const to = storage_.get() + std::size_t{i} * wide.stride;
    // New fields take the values of now; the old ones then overwrite their own.
    put_fields(context, layout, to + wide.position_size);
    to[3] = wide.position_size == 4 && old.position_size == 3 ? 1.0f : to[3];
    std::memcpy(to, from, old.position_size * sizeof(float));
    if (layout.materials == layout_.materials && layout.wide_texcoords == layout_.wide_texcoords) {
      std::memcpy(to + wide.position_size, from + old.position_size, old_rest * sizeof(float));
      continue;
    }
    const auto keep = [&](unsigned target, unsigned source, unsigned size) {
      std::memcpy(to + target, from + source, size * sizeof(float));
    };
    if (layout_.fields & kFieldNormal) keep(wide.normal, old.normal, 3);
    if (layout_.fields & kFieldColor) keep(wide.color, old.color, 4);
    if (layout_.fields & kFieldSecondaryColor) keep(wide.secondary_color, old.secondary_color, 3);
    if (layout_.fields & kFieldFogCoord) keep(wide.fog_coord, old.fog_coord, 1);
    for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit) {
      if (!(layout_.texcoords & 1u << unit)) continue;
      if (texcoord_size(layout, unit) == 4) {
        to[wide.texcoords[unit] + 2] = 0;
        to[wide.texcoords[unit] + 3] = 1;
      }
      keep(wide.texcoords[unit], old.texcoords[unit], texcoord_size(layout_, unit));
    }
    if (layout_.fields & kFieldEdgeFlag) keep(wide.edge_flag, old.edge_flag, 1);
    if (layout_.fields & kFieldLightingPosition)
      keep(wide.lighting_position, old.lighting_position, old.position_size);
    for (unsigned m = 0; m < 2 * kPropertyCount; ++m)
      if (layout_.materials & (1u << m))
        keep(wide.materials[m], old.materials[m], material_size(m % kPropertyCount));
  }
  set_layout(layout);
  cursor_ = storage_.get() + std::size_t{count} * wide.stride;
  set_limit();
}

void Recorder::abandon() {
  clear();
  first_ = 0;
  materials_cached_ = false;
  limit_ = nullptr;  // the next vertex reserves room
}

void Recorder::carry_materials(Context& context, MaterialMask mask) {
  materials_cached_ = false;
  if (!context.lighting.enabled) return;
  VertexLayout layout = layout_;
  layout.materials = static_cast<MaterialMask>(layout.materials | mask);
  if (layout != layout_) widen(context, layout);
}

void Recorder::carry_wide_texcoords(Context& context, unsigned unit) {
  if (is_idle() || !(layout_.texcoords & 1u << unit)) return;
  VertexLayout layout = layout_;
  layout.wide_texcoords |= static_cast<std::uint8_t>(1u << unit);
  if (layout != layout_) widen(context, layout);
}

void Recorder::clear() {
  if (tried_joining_) {
    // Three objects in a batch pay for the trouble; otherwise it is tried ever more rarely.
    constexpr std::uint32_t kWorthJoining = 3, kMostSkipped = 4096;
    const bool paid = small_draws_ >= kWorthJoining;
    backoff_ = paid ? 0 : std::min(2 * backoff_ + 16, kMostSkipped);
    skip_ = backoff_;
    usual_materials_ = paid ? layout_.materials : MaterialMask{0};
  }
  tried_joining_ = false;
  small_draws_ = small_draw_first_ = first_untransformed_ = 0;
  small_draw_run_ = 0;
  runs_.clear();
  runs_changed();
  elements_.clear();
  cursor_ = storage_.get();
}

}  // namespace legacy_gl
