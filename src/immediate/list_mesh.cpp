#include "immediate/list_mesh.hpp"

#include <algorithm>

#include "immediate/primitives.hpp"

namespace legacy_gl {

void ListMesh::finish() {
  const unsigned stride = offsets_of(layout).stride;
  if (vertices.empty()) return;
  lowest = highest = {vertices[0], vertices[1], vertices[2]};
  for (std::size_t at = 0; at < vertices.size(); at += stride)
    for (int axis = 0; axis < 3; ++axis) {
      const float value = vertices[at + static_cast<std::size_t>(axis)];
      lowest[axis] = std::min(lowest[axis], value);
      highest[axis] = std::max(highest[axis], value);
    }
  if (vertex_count() > Recorder::kSmallObject) return;
  for (const PrimitiveRun& run : runs)
    if (!append_triangles(run, elements, triangles)) return triangles.clear();
}

}  // namespace legacy_gl
