#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/list_mesh.hpp"

namespace legacy_gl {

/// The triangles of a mesh by the places where they meet.
struct Surface {
  /// A closed surface hides one side of its triangles from every eye outside it: what the eye meets
  /// first is an outer side. `winding` says how outer sides are wound for that eye.
  enum class Winding : std::uint8_t { kOpen, kCounterclockwise, kClockwise };

  struct Corner {
    std::uint32_t place = 0;
    std::uint32_t vertex = 0;  ///< of the mesh; of those that are alike in everything the first
  };

  Winding winding = Winding::kOpen;
  /// Vertices at one place are alike in everything that the mesh says of them: no edge shows.
  bool smooth = false;
  /// Where it is closed: how far the planes of its triangles are from the middle of their part at
  /// least, in parts of the part's size.
  float thickness = 0;
  std::vector<glm::vec3> places;
  std::vector<Corner> corners;  ///< three for each triangle, the provoking one last
};

/// Meshes of fewer vertices are not worth a list of triangles of their own; small objects join
/// batches.
inline constexpr std::uint32_t kWorthwhileSurface = 128;

/// The mesh has nothing but polygons. Closed are surfaces of which every part is seen whole from
/// its middle (balls, boxes, cones and whatever is convex), each edge the way of two triangles
/// there and back. Edges that miss each other by rounding alone count as one.
Surface find_surface(const ListMesh& mesh);

}  // namespace legacy_gl
