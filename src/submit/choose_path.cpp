#include "submit/choose_path.hpp"

namespace legacy_gl {

namespace {

/// The primitives themselves are needed, not only their vertices.
bool makes_primitives(const DrawRequest& request, const PathState& state) {
  return (state.unfilled && request.has_polygons) || (state.replaces_lines && request.has_lines);
}

DrawPath path_of_arrays(const DrawRequest& request, const PathState& state) {
  if (makes_primitives(request, state)) return DrawPath::kRecorder;
  if (request.fetched_by_driver && state.paths.arrays_direct) return DrawPath::kArraysDirect;
  if (!request.many_and_dense || request.plain_quads || !state.paths.arrays_streamed)
    return DrawPath::kRecorder;
  // The recorder makes short normals longer.
  if (request.has_tiny_normals && state.normalizes) return DrawPath::kRecorder;
  return DrawPath::kArraysStreamed;
}

DrawPath path_of_mesh(const DrawRequest& request, const PathState& state) {
  if (makes_primitives(request, state) || !state.paths.list_meshes) return DrawPath::kRecorder;
  if (request.has_tiny_normals && state.normalizes) return DrawPath::kRecorder;
  return DrawPath::kMesh;
}

}  // namespace

DrawPath choose_path(const DrawRequest& request, const PathState& state) {
  switch (request.source) {
    case DrawRequest::Source::kArrays:
      return state.renders ? path_of_arrays(request, state) : DrawPath::kRecorder;
    case DrawRequest::Source::kMesh:
      return state.renders ? path_of_mesh(request, state) : DrawPath::kRecorder;
    case DrawRequest::Source::kBatch: break;
  }
  if (!state.renders) return DrawPath::kCpuPipeline;
  return makes_primitives(request, state) ? DrawPath::kExpanded : DrawPath::kBatch;
}

const char* name_of(DrawPath path) {
  switch (path) {
    case DrawPath::kRecorder: return "recorder";
    case DrawPath::kCpuPipeline: return "CPU pipeline";
    case DrawPath::kBatch: return "batch";
    case DrawPath::kExpanded: return "expanded batch";
    case DrawPath::kMesh: return "mesh";
    case DrawPath::kArraysDirect: return "arrays in buffers";
    case DrawPath::kArraysStreamed: return "streamed arrays";
  }
  return "";
}

}  // namespace legacy_gl
