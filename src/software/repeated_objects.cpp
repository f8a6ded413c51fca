#include "software/repeated_objects.hpp"

#include <algorithm>
#include <bit>

#include "geometry/float4.hpp"
#include "geometry/object_surface.hpp"
#include "geometry/primitives.hpp"
#include "software/recent_entries.hpp"

namespace legacy_gl {

namespace {

constexpr std::size_t kStride = Recorder::kLitStride;
/// An object that was met often gives way to others after so many of them.
constexpr unsigned kMostSeen = 16;

bool may_be_kept(const Recorder::Object& object) {
  return std::all_of(object.runs, object.runs + object.run_count, [](const PrimitiveRun& run) {
    return !run.indexed && run.mode >= GL_TRIANGLES;
  });
}

std::uint64_t hash_of(const Recorder::Object& object) {
  std::uint64_t hash = object.vertex_count;
  for (const std::uint32_t vertex : {0u, object.vertex_count / 2, object.vertex_count - 1})
    for (unsigned axis = 0; axis < 3; ++axis) {
      const float coordinate = object.vertices[vertex * kStride + axis];
      hash = (hash ^ std::bit_cast<std::uint32_t>(coordinate)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
  return hash * 0x9e3779b97f4a7c15u;
}

/// Of each vertex the position and the normal; nothing is said of the float behind them.
bool same_vertices(const float* a, const float* b, std::uint32_t count) {
  const Int4 three{-1, -1, -1, 0};
  Int4 difference{};
  for (std::uint32_t i = 0; i < count; ++i, a += kStride, b += kStride)
    difference |= (std::bit_cast<Int4>(load(a)) ^ std::bit_cast<Int4>(load(b))) |
                  ((std::bit_cast<Int4>(load(a + 4)) ^ std::bit_cast<Int4>(load(b + 4))) & three);
  return !(difference[0] | difference[1] | difference[2] | difference[3]);
}

/// nullptr when it is not closed, or has a vertex with a w.
std::shared_ptr<const ListMesh> mesh_of(const std::vector<float>& vertices,
                                        const std::vector<PrimitiveRun>& runs) {
  auto mesh = std::make_shared<ListMesh>();
  mesh->layout.fields = kFieldNormal;
  for (std::size_t at = 0; at < vertices.size(); at += kStride) {
    if (vertices[at + 3] != 1) return nullptr;
    const float* const vertex = &vertices[at];
    mesh->vertices.insert(mesh->vertices.end(), vertex, vertex + 3);
    mesh->vertices.insert(mesh->vertices.end(), vertex + 4, vertex + 7);
  }
  for (const PrimitiveRun& run : runs) {
    if (run.mode == GL_QUADS) append_indices(run, {}, 0, false, mesh->elements);
    else append_triangles(run, {}, mesh->elements);
  }
  mesh->runs = {{GL_TRIANGLES, 0, static_cast<std::uint32_t>(mesh->elements.size()), true}};
  mesh->finish();
  if (mesh->triangles.empty() || mesh->tiny_normals) return nullptr;
  return mesh->object_surface().winding == Surface::Winding::kOpen ? nullptr : mesh;
}

}  // namespace

RepeatedObjects::Found RepeatedObjects::find(const Recorder& recorder) {
  const Recorder::Object object = recorder.last_object();
  if (object.vertex_count == 0 || object.vertex_count > Recorder::kSmallObject ||
      !may_be_kept(object))
    return {};
  const std::uint64_t hash = hash_of(object);
  Entry& entry = entries_[hash >> (64 - kHashBits)];
  if (entry.hash != hash) {
    if (entry.seen) --entry.seen;
    else entry = Entry{.hash = hash, .seen = 1};
    return {};
  }
  entry.seen = std::min(entry.seen + 1, kMostSeen);
  const auto same_run = [&](const PrimitiveRun& run, const PrimitiveRun& kept) {
    return run.mode == kept.mode && run.first - object.first_vertex == kept.first &&
           run.count == kept.count;
  };
  if (entry.vertices.empty()) {
    if (entry.seen < kCopiesWhenMet) return {};
    entry.vertices.assign(object.vertices, object.vertices + object.vertex_count * kStride);
    entry.runs.assign(object.runs, object.runs + object.run_count);
    for (PrimitiveRun& run : entry.runs) {
      run.first -= object.first_vertex;
      run.apart = false;
    }
    entry.found = {mesh_of(entry.vertices, entry.runs),
                   std::any_of(entry.runs.begin(), entry.runs.end(),
                               [](const PrimitiveRun& run) { return run.mode == GL_QUADS; })};
    return entry.found;
  }
  const bool same = entry.vertices.size() == object.vertex_count * kStride &&
                    std::equal(object.runs, object.runs + object.run_count, entry.runs.begin(),
                               entry.runs.end(), same_run) &&
                    same_vertices(object.vertices, entry.vertices.data(), object.vertex_count);
  if (same || entry.failures >= kMostFailures) return same ? entry.found : Found{};
  entry.seen = 0;
  entry.vertices.clear();
  entry.found = {};
  ++entry.failures;
  return {};
}

}  // namespace legacy_gl
