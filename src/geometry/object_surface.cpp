#include "geometry/object_surface.hpp"

#include <algorithm>

namespace legacy_gl {

namespace {

using Place = ObjectSurface::Place;

/// Every two triangles that share an edge. Those between places that count as one have none.
void find_edges(ObjectSurface& surface) {
  struct Side {
    Place a, b;
    std::uint16_t triangle;
  };
  std::vector<Side> sides;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    if (a == b || b == c || c == a) continue;
    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}})
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<std::uint16_t>(t)});
  }
  const auto order = [](const Side& s) { return s.a << 8 | s.b; };
  std::stable_sort(sides.begin(), sides.end(),
                   [&](const Side& s, const Side& t) { return order(s) < order(t); });
  for (auto s = sides.begin(); s != sides.end(); ++s)
    for (auto t = s + 1; t != sides.end() && order(*t) == order(*s); ++t)
      surface.edges.push_back({s->a, s->b, s->triangle, t->triangle});
}

}  // namespace

ObjectSurface find_object_surface(const ListMesh& mesh) {
  Surface found = find_surface(mesh);
  if (found.corners.size() != mesh.triangles.size()) return {};
  ObjectSurface surface;
  surface.winding = found.winding;
  surface.thickness = found.thickness;
  surface.places = std::move(found.places);
  const std::size_t stride = offsets_of(mesh.layout).stride;
  for (std::size_t at = 0; at < mesh.vertices.size(); at += stride) {
    const glm::vec3 position(mesh.vertices[at], mesh.vertices[at + 1], mesh.vertices[at + 2]);
    const auto place = std::find(surface.places.begin(), surface.places.end(), position);
    surface.place_of_vertex.push_back(static_cast<Place>(place - surface.places.begin()));
  }
  for (std::size_t at = 0; at < found.corners.size(); at += 3) {
    std::array<Place, 3>& places = surface.triangles.emplace_back();
    std::array<Place, 3>& vertices = surface.corners.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      places[k] = static_cast<Place>(found.corners[at + k].place);
      vertices[k] = static_cast<Place>(found.corners[at + k].vertex);
    }
  }
  if (surface.winding != Surface::Winding::kOpen) find_edges(surface);
  return surface;
}

}  // namespace legacy_gl
