#include "geometry/list_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/primitives.hpp"
#include "geometry/tiny_normals.hpp"

namespace legacy_gl {

namespace {

/// How far from 1 float32 leaves the length of a vector that was made unit length. Taken as 1, the
/// 128th power of a cosine is off by 0.007 of a step of 8 bits.
constexpr double kRoundingOfUnits = 2e-7;

}  // namespace

void ListMesh::draw_runs() {
  for (const PrimitiveRun& run : runs) {
    const GLenum mode = core_mode(run.mode);
    const bool indexed = run.indexed || !draws_without_indices(run.mode);
    const auto first = static_cast<std::uint32_t>(indexed ? indices.size() : firsts.size());
    if (draws.empty() || draws.back().mode != mode || draws.back().indexed != indexed ||
        (indexed && !joins_in_one_draw(mode)))
      draws.push_back({mode, indexed, first, 0});
    if (indexed) {
      append_indices(run, elements, 0, true, indices);
      draws.back().count = static_cast<std::uint32_t>(indices.size()) - draws.back().first;
    } else {
      firsts.push_back(static_cast<GLint>(run.first));
      counts.push_back(static_cast<GLsizei>(run.count));
      ++draws.back().count;
    }
  }
}

void ListMesh::finish() {
  const VertexOffsets offsets = offsets_of(layout);
  const unsigned stride = offsets.stride;
  if (vertices.empty()) return;
  lowest = highest = {vertices[0], vertices[1], vertices[2]};
  for (std::size_t at = 0; at < vertices.size(); at += stride)
    for (int axis = 0; axis < 3; ++axis) {
      const float value = vertices[at + static_cast<std::size_t>(axis)];
      lowest[axis] = std::min(lowest[axis], value);
      highest[axis] = std::max(highest[axis], value);
    }
  unit_normals = layout.fields & kFieldNormal;
  tiny_normals =
      unit_normals && has_tiny_components(&vertices[offsets.normal], stride, vertex_count());
  for (std::size_t at = 0; at < vertices.size(); at += stride) {
    const float* const normal = &vertices[at] + offsets.normal;
    const float* const color = &vertices[at] + offsets.color;
    if (layout.fields & kFieldNormal) {
      const double length =
          std::hypot(static_cast<double>(normal[0]), static_cast<double>(normal[1]),
                     static_cast<double>(normal[2]));
      unit_normals = unit_normals && std::abs(length - 1) < kRoundingOfUnits;
      longest_normal = std::max(longest_normal, static_cast<float>(length) * (1 + 1e-6f));
    }
    if (layout.fields & kFieldColor)
      largest_color =
          std::max({largest_color, std::abs(color[0]), std::abs(color[1]), std::abs(color[2])});
  }
  if (vertex_count() > kSmallDrawVertices) return;
  for (const PrimitiveRun& run : runs)
    if (!append_triangles(run, elements, triangles)) return triangles.clear();
}

}  // namespace legacy_gl
