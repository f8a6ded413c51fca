#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/surface.hpp"

namespace legacy_gl {

/// The surface of a small mesh, and what joins its triangles.
struct ObjectSurface {
  using Place = std::uint8_t;

  /// Neighbours at an edge.
  struct Edge {
    Place a, b;
    std::uint16_t left, right;  ///< triangles
  };

  Surface::Winding winding = Surface::Winding::kOpen;
  float thickness = 0;                 ///< as Surface has it
  std::vector<glm::vec3> places;       ///< each position once
  std::vector<Place> place_of_vertex;  ///< of the mesh
  /// Of ListMesh::triangles. Places that rounding alone keeps apart count as one here.
  std::vector<std::array<Place, 3>> triangles;
  /// Vertices of the triangles; of those that are alike the first.
  std::vector<std::array<Place, 3>> corners;
  std::vector<Edge> edges;  ///< of a closed surface
};

/// The mesh has `triangles`.
ObjectSurface find_object_surface(const ListMesh& mesh);

}  // namespace legacy_gl
