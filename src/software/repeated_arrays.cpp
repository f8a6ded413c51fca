#include "software/repeated_arrays.hpp"

#include <algorithm>
#include <cstring>

#include "geometry/surface.hpp"

namespace legacy_gl {

namespace {

std::size_t bytes_of(const ElementView& elements) {
  return elements.count * std::size_t{type_size(elements.type)};
}

}  // namespace

bool RepeatedArrays::is_unchanged(const Entry& entry, const ArrayGather& gather,
                                  const ElementView& elements) {
  if (entry.elements.size() != bytes_of(elements) ||
      (elements.count &&
       std::memcmp(entry.elements.data(), elements.data, entry.elements.size()) != 0))
    return false;
  block_.resize(ArrayGather::kBlockVertices * gather.stride());
  const float* kept = entry.mesh->vertices.data();
  const std::uint32_t count = entry.mesh->vertex_count();
  for (std::uint32_t done = 0; done < count;) {
    const std::uint32_t block = std::min(ArrayGather::kBlockVertices, count - done);
    gather(entry.range.lowest + done, block, block_.data());
    const std::size_t floats = block * gather.stride();
    if (std::memcmp(block_.data(), kept, floats * sizeof(float)) != 0) return false;
    kept += floats;
    done += block;
  }
  return true;
}

/// Closed surfaces alone are kept; what is open counts as a failure for good.
void RepeatedArrays::copy(Entry& entry, const ArrayGather& gather, const ElementView& elements) {
  const ElementRange& range = entry.range;
  const std::uint32_t vertices = range.highest - range.lowest + 1;
  entry.failures = kMostFailures;
  if (vertices * gather.stride() > RecentEntries<Entry>::kMostFloats) return;
  auto mesh = std::make_shared<ListMesh>();
  mesh->layout = entry.layout;
  mesh->vertices.resize(vertices * gather.stride());
  gather(range.lowest, vertices, mesh->vertices.data());
  const bool indexed = entry.draw.is_indexed();
  if (indexed) {
    read_elements(elements, mesh->elements);
    for (std::uint32_t& element : mesh->elements) element -= range.lowest;
  }
  mesh->runs.push_back({entry.draw.mode, 0, indexed ? elements.count : entry.draw.count, indexed});
  mesh->finish();
  auto surface = std::make_shared<Surface>(find_surface(*mesh));
  if (surface->winding == Surface::Winding::kOpen) return;
  mesh->surface = std::move(surface);
  mesh->draw_runs();
  entry.elements.assign(elements.data, elements.data + bytes_of(elements));
  entry.mesh = std::move(mesh);
  entry.failures = 0;
  entries_.make_room();
}

std::shared_ptr<ListMesh> RepeatedArrays::find(const ArrayDraw& draw, const VertexLayout& layout,
                                               const ArrayGather& gather,
                                               const ElementView& elements,
                                               const ElementRange& range) {
  Entry fresh;
  fresh.draw = draw;
  fresh.layout = layout;
  fresh.range = range;
  Entry& entry = entries_.find_or_add(
      [&](const Entry& e) { return e.draw == draw && e.layout == layout && e.range == range; },
      fresh);
  if (entry.failures >= kMostFailures) return nullptr;
  if (!entry.mesh) {
    if (++entry.seen >= kCopiesWhenMet) copy(entry, gather, elements);
    return entry.mesh;
  }
  if (is_unchanged(entry, gather, elements)) {
    entry.failures = 0;
    return entry.mesh;
  }
  ++entry.failures;
  entry.seen = 0;
  entry.mesh.reset();
  return nullptr;
}

}  // namespace legacy_gl
