// Small objects lit here, so that objects of any lights, materials, modes and matrices share a
// draw: what they would wait for a program, and the driver for each change of state, costs more
// than that.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "geometry/float4.hpp"
#include "record/current_normal.hpp"
#include "record/pending.hpp"
#include "software/software_fast_path.hpp"
#include "software/tuning.hpp"
#include "software/vertex_lighting.hpp"
#include "submit/batch.hpp"
#include "submit/prepare.hpp"

namespace legacy_gl {

namespace {

using tuning::kMostLitVertices;

constexpr VertexLayout kLitFrom{kFieldNormal, 0, 0, 0};
constexpr VertexLayout kLitTo{kFieldTransformed | kFieldShaded, 0, 0, 0};
constexpr unsigned kStride = Recorder::kShadedStride;

/// Vertices of one face on their way to be lit.
class Chunk {
 public:
  static constexpr std::uint32_t kVertices = kMostLitVertices;

  void add(const float* position, const float* normal, float* color) {
    LightingBlock& block = blocks_[count_ / LightingBlock::kVertices];
    const std::uint32_t at = count_ % LightingBlock::kVertices;
    for (unsigned axis = 0; axis < 3; ++axis) {
      block.position[axis][at] = position[axis];
      block.normal[axis][at] = normal[axis];
    }
    colors_[count_++] = color;
  }

  void light(const DrawInputs& derived, unsigned face) {
    const std::uint32_t whole = std::exchange(count_, 0);
    for (std::uint32_t first = 0; first < whole; first += LightingBlock::kVertices) {
      LightingBlock& block = blocks_[first / LightingBlock::kVertices];
      const std::uint32_t count = std::min(whole - first, LightingBlock::kVertices);
      for (unsigned axis = 0; axis < 3; ++axis)  // what is not there is lit like the last
        for (std::uint32_t at = count; at < LightingBlock::kVertices; ++at) {
          block.position[axis][at] = block.position[axis][count - 1];
          block.normal[axis][at] = block.normal[axis][count - 1];
        }
      light_block(derived, face, block);
      for (std::uint32_t at = 0; at < count; ++at)
        for (unsigned c = 0; c < 4; ++c) colors_[first + at][c] = block.color[c][at];
    }
  }

 private:
  std::array<LightingBlock, kVertices / LightingBlock::kVertices> blocks_;
  std::array<float*, kVertices> colors_;
  std::uint32_t count_ = 0;
};

/// The vertices of a mesh that are drawn, by the face that they are lit for: in the order in which
/// they are asked for.
class VertexSlots {
 public:
  VertexSlots() {
    for (auto& face : slots_) face.fill(kNone);
  }
  std::uint32_t find(std::uint32_t vertex, unsigned face) {
    std::uint32_t& slot = slots_[face][vertex];
    if (slot == kNone) {
      slot = count_++;
      vertices_[slot] = vertex << 1 | face;
    }
    return slot;
  }
  std::uint32_t count() const { return count_; }
  std::uint32_t vertex(std::uint32_t slot) const { return vertices_[slot] >> 1; }
  unsigned face(std::uint32_t slot) const { return vertices_[slot] & 1; }

 private:
  static constexpr std::uint32_t kNone = ~0u;
  std::array<std::array<std::uint32_t, kMostLitVertices>, 2> slots_;
  std::array<std::uint32_t, 2 * kMostLitVertices> vertices_;
  std::uint32_t count_ = 0;
};

/// Where a mesh's vertices have their positions and normals; the current normal where it has none.
class MeshVertices {
 public:
  MeshVertices(const Context& context, const ListMesh& mesh)
      : vertices_(mesh.vertices.data()),
        offsets_(offsets_of(mesh.layout)),
        has_normals_(mesh.layout.fields & kFieldNormal),
        current_(normal_to_draw(context)) {}
  const float* position(std::uint32_t vertex) const {
    return vertices_ + std::size_t{vertex} * offsets_.stride;
  }
  const float* normal(std::uint32_t vertex) const {
    return has_normals_ ? position(vertex) + offsets_.normal : &current_[0];
  }

 private:
  const float* vertices_;
  VertexOffsets offsets_;
  bool has_normals_;
  glm::vec3 current_;
};

Columns to_clip(const Context& context) {
  return columns(context.transform.projection.top().single *
                 context.transform.modelview.top().single);
}

/// Where lighting finds a vertex that has a w. One at infinity is very far away.
void divide_by_w(const float* position, float* to) {
  constexpr float kFar = 1e15f;
  const float scale = position[3] != 0 ? 1 / position[3] : kFar;
  for (unsigned axis = 0; axis < 3; ++axis) to[axis] = position[axis] * scale;
}

/// Twice the area that the triangle of these clip coordinates has on the screen, but for a positive
/// factor.
double area(const Float4& a, const Float4& b, const Float4& c) {
  const auto minor = [](const Float4& p, const Float4& q, unsigned i, unsigned j) {
    return double{p[i]} * double{q[j]} - double{p[j]} * double{q[i]};
  };
  return double{a[0]} * minor(b, c, 1, 3) - double{a[1]} * minor(b, c, 0, 3) +
         double{a[3]} * minor(b, c, 0, 1);
}

/// Products of these stay far inside float32's range.
constexpr float kBounded = 1e6f;

bool is_bounded(const glm::vec4& color) {
  const glm::vec4 size = glm::abs(color);
  return size.x < kBounded && size.y < kBounded && size.z < kBounded;
}

bool are_bounded(const Materials& materials) {
  return std::all_of(materials.begin(), materials.end(), [](const Material& m) {
    return is_bounded(m.ambient) && is_bounded(m.diffuse) && is_bounded(m.specular) &&
           is_bounded(m.emission);
  });
}

bool are_bounded(const std::vector<Light>& lights) {
  return std::all_of(lights.begin(), lights.end(), [](const Light& light) {
    return is_bounded(light.ambient) && is_bounded(light.diffuse) && is_bounded(light.specular) &&
           light.constant_attenuation > 1 / kBounded;
  });
}

}  // namespace

struct SoftwareFastPath::PlacedMesh {
  std::array<Float4, kMostLitVertices> clip;  ///< coordinates of the mesh's vertices
  ClipFlags flags;

  PlacedMesh(const glm::mat4& to_clip, const ListMesh& mesh) {
    const Columns matrix = columns(to_clip);
    const unsigned stride = offsets_of(mesh.layout).stride;
    const float* p = mesh.vertices.data();
    for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i, p += stride) {
      clip[i] = product(matrix, p[0], p[1], p[2], 1);
      flags.add(clip[i]);
    }
  }
};

bool SoftwareFastPath::may_light(const Context& context) {
  DriverObjects& objects = *context.driver;
  return context.paths.cpu_lighting && context.lighting.enabled &&
         objects.programs.has_stand_ins() && !context.fog.enabled &&
         !active_textures(context.texture).mask && Recorder::relevant_layout(context) == kLitFrom &&
         !culls_lights(context) && !replaces_lines(context) &&
         !context.raster.point.is_attenuated();
}

bool SoftwareFastPath::update_lighting(Context& context, const DrawFacts& facts) {
  if (!may_light(context)) return false;
  context.dirty |= context.submission->dirty.take(context.dirty, DirtyReaders::kShading) &
                   ~std::uint32_t{kDirtyRaster};
  lighting_.update(context, kLitFrom, facts);
  return lights_blocks(lighting_.key);
}

/// With an affine modelview and materials of bounded values the answer depends on nothing that a
/// change of matrix or material changes: it is asked at every glBegin.
bool SoftwareFastPath::shades_next_draw(Context& context) {
  if (!may_light(context)) return false;
  constexpr std::uint32_t kWithoutEffect = kDirtyTransform | kDirtyMaterial | kDirtyRaster;
  const LightingState& lighting = context.lighting;
  const bool usual = context.options.quality == LEGACY_GL_QUALITY_DEFAULT &&
                     lighting.model.color_control == GL_SINGLE_COLOR &&
                     is_affine(context.transform.modelview.pending_top().base.exact) &&
                     are_bounded(lighting.materials);
  const std::uint32_t changed =
      context.submission->dirty.take(context.dirty, DirtyReaders::kShadingState);
  if (changed & ~kWithoutEffect) shades_affine_draws_ = false;
  if (usual && shades_affine_draws_) return true;
  const bool shaded = update_lighting(context, {}) && !lighting_.key.two_side;
  shades_affine_draws_ =
      usual && shaded && are_bounded(lighting.lights) && is_bounded(lighting.model.ambient);
  return shaded;
}

bool SoftwareFastPath::shade_batch(Context& context) {
  Recorder& recorder = context.recorder;
  if (!recorder.is_shaded()) {
    if (recorder.inside_begin_end() || recorder.layout() != kLitFrom ||
        recorder.vertex_count() > kMostLitVertices || !shades_next_draw(context))
      return false;
    recorder.become_shaded(context);
  }
  shade_vertices(context);
  return true;
}

void SoftwareFastPath::shade_vertices(Context& context) {
  Recorder& recorder = context.recorder;
  std::uint32_t at = recorder.first_untransformed();
  const std::uint32_t end = recorder.vertex_count();
  if (at == end) return;
  enlarge_recorded_normals(context, at);
  update_lighting(context, {});
  const Columns clip_matrix = to_clip(context);
  ClipFlags flags;
  Chunk chunk;
  while (at < end) {
    const std::uint32_t until = std::min(end, at + Chunk::kVertices);
    for (; at < until; ++at) {
      float* const vertex = recorder.data() + std::size_t{at} * kStride;
      const Float4 clip = product(clip_matrix, vertex[0], vertex[1], vertex[2], vertex[3]);
      flags.add(clip);
      if (vertex[3] != 1) divide_by_w(vertex, vertex);
      chunk.add(vertex, vertex + 4, vertex + 4);
      store(vertex, clip);
    }
    chunk.light(lighting_, kFront);
  }
  recorder.set_all_transformed();
  if (recorder.inside_begin_end()) return;
  ++context.statistics.draws_lit_on_cpu;
  recorder.end_small_draw(flags.crosses());
}

bool SoftwareFastPath::can_shade_mesh(Context& context, const ListMesh& mesh) {
  DrawFacts facts;
  facts.unit_normals = mesh.unit_normals;
  return !mesh.triangles.empty() && mesh.vertex_count() <= kMostLitVertices &&
         !(mesh.layout.fields & kFieldPositionW) && update_lighting(context, facts);
}

bool SoftwareFastPath::append_shaded_mesh(Context& context, const ListMesh& mesh) {
  Recorder& recorder = context.recorder;
  if (!can_shade_mesh(context, mesh)) return false;
  if (!recorder.all_shaded() && recorder.has_pending()) {
    if (!shade_pending(context)) flush_pending(context);
    if (!can_shade_mesh(context, mesh)) return false;  // lighting_ held the pending draw's inputs
  }
  const PlacedMesh placed(lighting_.transform.modelview_projection, mesh);
  if (placed.flags.outside()) {
    ++context.statistics.primitives_clipped;
    return true;
  }
  if (!recorder.has_pending()) recorder.become_shaded(context);
  if (lighting_.key.two_side) append_both_faces(context, mesh, placed);
  else append_front(context, mesh, placed);
  recorder.set_all_transformed();
  recorder.end_small_draw(placed.flags.crosses());
  ++context.statistics.draws_lit_on_cpu;
  recorder.flush_if_large(context);
  return true;
}

void SoftwareFastPath::append_front(Context& context, const ListMesh& mesh,
                                    const PlacedMesh& placed) {
  Recorder& recorder = context.recorder;
  const std::uint32_t base = recorder.vertex_count();
  std::uint32_t* elements = recorder.append_elements(
      context, GL_TRIANGLES, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const std::uint32_t vertex : mesh.triangles) *elements++ = base + vertex;
  float* to = recorder.append_shaded(mesh.vertex_count());
  const MeshVertices vertices(context, mesh);
  Chunk chunk;
  for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i, to += kStride) {
    store(to, placed.clip[i]);
    chunk.add(vertices.position(i), vertices.normal(i), to + 4);
  }
  chunk.light(lighting_, kFront);
}

/// A vertex that triangles of both faces share is there twice.
void SoftwareFastPath::append_both_faces(Context& context, const ListMesh& mesh,
                                         const PlacedMesh& placed) {
  Recorder& recorder = context.recorder;
  const std::uint32_t base = recorder.vertex_count();
  std::uint32_t* elements = recorder.append_elements(
      context, GL_TRIANGLES, static_cast<std::uint32_t>(mesh.triangles.size()));
  VertexSlots slots;
  const bool clockwise = context.raster.polygon.front_face == GL_CW;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const std::uint32_t* const corners = &mesh.triangles[t];
    const double twice =
        area(placed.clip[corners[0]], placed.clip[corners[1]], placed.clip[corners[2]]);
    const unsigned face = (clockwise ? -twice : twice) < 0 ? kBack : kFront;
    for (unsigned corner = 0; corner < 3; ++corner)
      *elements++ = base + slots.find(corners[corner], face);
  }
  float* to = recorder.append_shaded(slots.count());
  const MeshVertices vertices(context, mesh);
  std::array<Chunk, 2> chunks;
  for (std::uint32_t i = 0; i < slots.count(); ++i, to += kStride) {
    const std::uint32_t index = slots.vertex(i);
    store(to, placed.clip[index]);
    chunks[slots.face(i)].add(vertices.position(index), vertices.normal(index), to + 4);
  }
  for (const unsigned face : {kFront, kBack}) chunks[face].light(lighting_, face);
}

}  // namespace legacy_gl
