#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "geometry/primitive_run.hpp"
#include "geometry/vertex_layout.hpp"
#include "state/deleted_names.hpp"

namespace legacy_gl {

/// Begin/End pairs of a display list, ready to draw: no work a vertex when the list is called.
/// Vertices that are alike are kept once where primitives are independent; strips and fans keep
/// their own order.
struct ListMesh : std::enable_shared_from_this<ListMesh> {
  /// Neighbouring primitives that the driver draws in one call.
  struct Draw {
    GLenum mode = 0;  ///< of the core profile
    bool indexed = false;
    std::uint32_t first = 0, count = 0;  ///< in `indices`, or in `firsts` and `counts`
  };

  VertexLayout layout;
  std::vector<float> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<GLint> firsts;
  std::vector<GLsizei> counts;
  std::vector<Draw> draws;
  std::uint32_t welded = 0;  ///< vertices that were given and are not kept

  /// The primitives as they were given, for what only the recorder can draw (unfilled polygons). An
  /// indexed run counts `elements`.
  std::vector<PrimitiveRun> runs;
  std::vector<std::uint32_t> elements;

  /// All primitives as triangles, of a small mesh of polygons: how it joins a batch of objects.
  /// Empty where it does not.
  std::vector<std::uint32_t> triangles;

  glm::vec3 lowest{0}, highest{0};  ///< of the positions
  float longest_normal = 0;         ///< where it has normals
  bool unit_normals = false;        ///< it has, and each is a unit vector as float32 rounds one
  bool tiny_normals = false;        ///< some may be too short for the driver (tiny_normals.hpp)
  float largest_color = 0;          ///< component of its colours, where it has them

  /// Contexts that keep the mesh in their driver learn when it is gone.
  mutable DeletionNotices<const ListMesh*> deletion_notices;

  /// Makes `draws` of `runs`.
  void draw_runs();

  /// Called once, when nothing joins the mesh any more.
  void finish();

  std::uint32_t vertex_count() const {
    return static_cast<std::uint32_t>(vertices.size() / offsets_of(layout).stride);
  }
};

}  // namespace legacy_gl
