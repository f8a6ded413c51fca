// Small objects lit here, so that objects of any lights, materials, modes and matrices share a
// draw: what they would wait for a program, and the driver for each change of state, costs more
// than that.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <span>
#include <utility>

#include "geometry/float4.hpp"
#include "geometry/tiny_normals.hpp"
#include "software/hidden_sides.hpp"
#include "software/vertex_lighting.hpp"
#include "submit/backend.hpp"

namespace legacy_gl {

namespace {

constexpr VertexLayout kLitFrom{kFieldNormal, 0, 0, 0};
constexpr VertexLayout kLitTo{kFieldTransformed | kFieldLit, 0, 0, 0};
constexpr unsigned kStride = Recorder::kLitStride;

/// Vertices of one face on their way to be lit.
class Chunk {
 public:
  static constexpr std::uint32_t kVertices = Recorder::kSmallObject;

  void add(const float* position, const float* normal, float* color) {
    LightingBlock& block = blocks_[count_ / LightingBlock::kVertices];
    const std::uint32_t at = count_ % LightingBlock::kVertices;
    for (unsigned axis = 0; axis < 3; ++axis) {
      block.position[axis][at] = position[axis];
      block.normal[axis][at] = normal[axis];
    }
    colors_[count_++] = color;
  }

  void light(const Derived& derived, unsigned face) {
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
class Places {
 public:
  Places() {
    for (auto& face : places_) face.fill(kNone);
  }
  std::uint32_t find(std::uint32_t vertex, unsigned face) {
    std::uint32_t& place = places_[face][vertex];
    if (place == kNone) {
      place = count_++;
      vertices_[place] = vertex << 1 | face;
    }
    return place;
  }
  std::uint32_t count() const { return count_; }
  std::uint32_t vertex(std::uint32_t place) const { return vertices_[place] >> 1; }
  unsigned face(std::uint32_t place) const { return vertices_[place] & 1; }

 private:
  static constexpr std::uint32_t kNone = ~0u;
  std::array<std::array<std::uint32_t, Recorder::kSmallObject>, 2> places_;
  std::array<std::uint32_t, 2 * Recorder::kSmallObject> vertices_;
  std::uint32_t count_ = 0;
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
constexpr float kModest = 1e6f;

bool is_modest(const glm::vec4& color) {
  const glm::vec4 size = glm::abs(color);
  return size.x < kModest && size.y < kModest && size.z < kModest;
}

bool are_modest(const Materials& materials) {
  return std::all_of(materials.begin(), materials.end(), [](const Material& m) {
    return is_modest(m.ambient) && is_modest(m.diffuse) && is_modest(m.specular) &&
           is_modest(m.emission);
  });
}

bool are_modest(const std::vector<Light>& lights) {
  return std::all_of(lights.begin(), lights.end(), [](const Light& light) {
    return is_modest(light.ambient) && is_modest(light.diffuse) && is_modest(light.specular) &&
           light.constant_attenuation > 1 / kModest;
  });
}

}  // namespace

struct Backend::PlacedObject {
  std::array<Float4, Recorder::kSmallObject> clip;  ///< coordinates of the surface's places
  ClipFlags flags;

  PlacedObject(const glm::mat4& to_clip, const ObjectSurface& surface) {
    const Columns matrix = columns(to_clip);
    for (std::size_t i = 0; i < surface.places.size(); ++i) {
      const glm::vec3& p = surface.places[i];
      clip[i] = product(matrix, p.x, p.y, p.z, 1);
      flags.add(clip[i]);
    }
  }
};

bool Backend::may_light(Context& context) const {
  return driver.traits.matches_cpu_arithmetic && context.lighting.enabled && programs_.has_stand_ins() &&
         !context.fog.enabled && !active_textures(context).mask &&
         Recorder::relevant_layout(context) == kLitFrom && !looks_at_reach(context) &&
         !replaces_lines(context) && !context.raster.point.is_attenuated();
}

bool Backend::derive_lighting(Context& context, const DrawFacts& facts) {
  if (!may_light(context)) return false;
  context.dirty |= take_dirty_bits(context, kLightingReader) & ~std::uint32_t{kDirtyRaster};
  lighting_.update(context, kLitFrom, driver.dialect, facts);
  return lights_blocks(lighting_.key);
}

/// The number of all that decides about objects but their matrices and materials.
std::uint32_t Backend::surroundings(Context& context) {
  apply_raster(context);
  const std::uint32_t changed = take_dirty_bits(context, kKeptObjectsReader);
  context.dirty = 0;  // they are put by
  return surroundings_.number_of(context, framebuffer_facts(context), changed);
}

/// Matrices and materials that are like most do not change the answer in the same surroundings.
bool Backend::stays_lit(Context& context) {
  if (!may_light(context)) return false;
  const LightingState& lighting = context.lighting;
  const bool usual = context.options.quality == LEGACY_GL_QUALITY_DEFAULT &&
                     lighting.model.color_control == GL_SINGLE_COLOR &&
                     is_affine(context.transform.modelview.pending_top().base.exact) &&
                     are_modest(lighting.materials);
  const std::uint32_t number = surroundings(context);
  if (usual && number == lit_surroundings_) return true;
  const bool lit = derive_lighting(context, {}) && !lighting_.key.two_side;
  lit_surroundings_ =
      usual && lit && are_modest(lighting.lights) && is_modest(lighting.model.ambient) ? number : 0;
  return lit;
}

bool Backend::light_recorded(Context& context) {
  Recorder& recorder = context.recorder;
  if (!recorder.is_lit()) {
    if (recorder.inside_begin_end() || recorder.goes_on() || recorder.layout() != kLitFrom ||
        recorder.vertex_count() > Recorder::kSmallObject || !stays_lit(context))
      return false;
    recorder.become_lit(context);
  }
  light_vertices(context);
  return true;
}

void Backend::light_vertices(Context& context) {
  Recorder& recorder = context.recorder;
  std::uint32_t at = recorder.first_untransformed();
  const std::uint32_t end = recorder.vertex_count();
  if (at == end || join_repeated_object(context)) return;
  draw_followed(context);
  enlarge_normals(context, at);
  derive_lighting(context, {});
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
  ++context.statistics.objects_lit;
  recorder.end_object(flags.crosses());
}

bool Backend::joins_lit_objects(Context& context, const ListMesh& mesh) {
  DrawFacts facts;
  facts.unit_normals = mesh.unit_normals;
  return !mesh.triangles.empty() && !(mesh.layout.fields & kFieldPositionW) &&
         derive_lighting(context, facts);
}

/// What of the object may be seen; `clip` holds its places, which are in the view if it is
/// `inside`.
const std::vector<std::uint16_t>& Backend::seen_triangles(Context& context,
                                                          const ObjectSurface& surface,
                                                          const Float4* clip, bool inside) {
  if (!inside || !skips_unseen(context)) return seen_object_.all(surface);
  const FramebufferFacts& framebuffer = framebuffer_facts(context);
  if (framebuffer.multisampled) return seen_object_.all(surface);
  const ViewportState& viewport = context.raster.viewport;
  SeenObject::View view{ScreenScale(viewport)};
  if (surface.winding != Surface::Winding::kOpen && shows_nearest_alone(context))
    view.hidden = inner_winding(surface.winding, lighting_.transform.modelview_projection);
  view.depth_steps =
      std::ldexp((viewport.depth_far - viewport.depth_near) / 2, framebuffer.depth_bits);
  return seen_object_.find(surface, clip, view);
}

/// Where the mesh would be kept, if it can be lit here.
std::optional<KeptObjects::Key> Backend::kept_key(Context& context, const ListMesh& mesh) {
  constexpr unsigned kDecide = kFieldNormal | kFieldPositionW;
  if (mesh.triangles.empty() || (mesh.layout.fields & kDecide) != kFieldNormal ||
      !may_light(context))
    return {};
  return KeptObjects::Key{mesh, surroundings(context), context.transform.modelview.pending_top(),
                          context.lighting.materials};
}

const KeptObjects::Entry* Backend::find_kept(const std::optional<KeptObjects::Key>& key) {
  return key ? kept_objects_.find(*key, kept_batches_.expected()) : nullptr;
}

bool Backend::join_lit_mesh(Context& context, const ListMesh& mesh) {
  Recorder& recorder = context.recorder;
  if (!recorder.all_lit()) {
    if (!joins_lit_objects(context, mesh)) return false;
    if (recorder.has_pending() && !light_object(context)) flush_pending(context);
  }
  const std::optional<KeptObjects::Key> key = kept_key(context, mesh);
  if (const KeptObjects::Entry* const kept = find_kept(key)) {
    append_kept_object(context, *kept);
  } else {
    if (!joins_lit_objects(context, mesh)) return false;
    const PlacedObject placed(lighting_.transform.modelview_projection, mesh.object_surface());
    append_lit_object(context, mesh, placed, key && kept_objects_.wants());
  }
  recorder.flush_if_large(context);
  return true;
}

/// The recorded object is taken from a mesh that it equals.
bool Backend::join_repeated_object(Context& context) {
  Recorder& recorder = context.recorder;
  if (!skips_unseen(context) || recorder.inside_begin_end() ||
      recorder.first_untransformed() != recorder.last_object().first_vertex)
    return false;
  const auto [mesh, has_quads] = repeated_objects_.find(recorder);
  if (!mesh) return false;
  const std::optional<KeptObjects::Key> key = kept_key(context, *mesh);
  if (const KeptObjects::Entry* const kept = find_kept(key)) {
    recorder.take_back_object();
    append_kept_object(context, *kept);
    return true;
  }
  if (!joins_lit_objects(context, *mesh)) return false;
  const PlacedObject placed(lighting_.transform.modelview_projection, mesh->object_surface());
  // Where quads are clipped or flat they are split the other way.
  if (has_quads && (placed.flags.crosses() || lighting_.key.flat)) return false;
  recorder.take_back_object();
  append_lit_object(context, *mesh, placed, key && kept_objects_.wants());
  return true;
}

/// Of the state that lighting_ has. A vertex that triangles of both faces share is there twice.
void Backend::append_lit_object(Context& context, const ListMesh& mesh, const PlacedObject& placed,
                                bool keeps) {
  Recorder& recorder = context.recorder;
  const ObjectSurface& surface = mesh.object_surface();
  if (placed.flags.outside()) {
    ++context.statistics.primitives_clipped;
    if (keeps) kept_objects_.keep({.outside = true});
    return;
  }
  const auto& clip = placed.clip;
  const std::vector<std::uint16_t>& seen =
      seen_triangles(context, surface, clip.data(), !placed.flags.crosses());
  const std::size_t unseen = surface.triangles.size() - seen.size();
  context.statistics.triangles_unseen += unseen;
  if (seen.empty()) {
    if (keeps) kept_objects_.keep({.unseen_triangles = unseen});
    return;
  }
  draw_followed(context);
  if (!recorder.has_pending()) recorder.become_lit(context);
  const std::uint32_t base = recorder.vertex_count();
  Places places;
  std::uint32_t* elements =
      recorder.append_elements(context, GL_TRIANGLES, static_cast<std::uint32_t>(3 * seen.size()));
  const bool clockwise = context.raster.polygon.front_face == GL_CW;
  for (const std::uint16_t t : seen) {
    unsigned face = kFront;
    if (lighting_.key.two_side) {
      const auto& [a, b, c] = surface.triangles[t];
      const double twice = area(clip[a], clip[b], clip[c]);
      face = (clockwise ? -twice : twice) < 0 ? kBack : kFront;
    }
    for (const std::uint32_t vertex : surface.corners[t])
      *elements++ = base + places.find(vertex, face);
  }
  float* vertex = recorder.append_lit(places.count());
  const VertexOffsets from = offsets_of(mesh.layout);
  const bool has_normal = mesh.layout.fields & kFieldNormal;
  const glm::vec3 current_normal = current_normal_to_draw(context);
  std::array<Chunk, 2> chunks;
  for (std::uint32_t i = 0; i < places.count(); ++i, vertex += kStride) {
    const std::uint32_t index = places.vertex(i);
    const float* const p = mesh.vertices.data() + std::size_t{index} * from.stride;
    store(vertex, clip[surface.place_of_vertex[index]]);
    chunks[places.face(i)].add(p, has_normal ? p + from.normal : &current_normal[0], vertex + 4);
  }
  for (const unsigned face : {kFront, kBack}) chunks[face].light(lighting_, face);
  recorder.set_all_transformed();
  recorder.end_object(placed.flags.crosses());
  ++context.statistics.objects_lit;
  if (!keeps) return;
  const std::span<const std::uint32_t> all_elements = recorder.elements();
  kept_objects_.keep(
      {.unseen_triangles = unseen, .apart = placed.flags.crosses()},
      {recorder.data() + std::size_t{base} * kStride, std::size_t{places.count()} * kStride},
      all_elements.last(3 * seen.size()), base);
}

void Backend::append_kept_object(Context& context, const KeptObjects::Entry& kept) {
  Recorder& recorder = context.recorder;
  const auto& [facts, vertices, triangles] = kept.object;
  context.statistics.primitives_clipped += facts.outside;
  context.statistics.triangles_unseen += facts.unseen_triangles;
  if (triangles.empty()) return;
  ++context.statistics.objects_lit;
  ++context.statistics.objects_kept;
  if (kept_batches_.follow(kept)) return;
  draw_followed(context);
  if (!recorder.has_pending()) {
    recorder.become_lit(context);
    if (kept_batches_.begin(kept)) return recorder.set_goes_on(true);
  }
  const std::uint32_t base = recorder.vertex_count();
  std::uint32_t* elements =
      recorder.append_elements(context, GL_TRIANGLES, static_cast<std::uint32_t>(triangles.size()));
  for (const std::uint16_t element : triangles) *elements++ = base + element;
  std::copy(vertices.begin(), vertices.end(),
            recorder.append_lit(static_cast<std::uint32_t>(vertices.size() / kStride)));
  recorder.set_all_transformed();
  recorder.end_object(facts.apart);
  kept_batches_.note(recorder, kept);
}

/// What came of the batch that is followed, before what comes now.
void Backend::draw_followed(Context& context) {
  if (!kept_batches_.is_followed()) return;
  const auto [batch, elements_end] = kept_batches_.stop();
  context.recorder.set_goes_on(false);
  derive(context, kLitTo);
  apply_derived(context);
  bind_vertex_array(batch.array);
  ++context.statistics.batches;
  context.statistics.vertices += batch.vertex_count;
  for (const PrimitiveRun& run : batch.runs) {
    if (run.first >= elements_end || !use_program(context, run.mode, batch.vertex_count)) break;
    driver.DrawElements(
        run.mode, static_cast<GLsizei>(std::min(run.count, elements_end - run.first)),
        GL_UNSIGNED_INT, reinterpret_cast<const void*>(run.first * sizeof(std::uint32_t)));
    ++context.statistics.draws;
  }
}

}  // namespace legacy_gl
