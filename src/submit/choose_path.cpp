#include "submit/choose_path.hpp"

namespace legacy_gl {

namespace {

constexpr const char* kTinyNormals = "the recorder makes short normals longer";
constexpr const char* kNoPrimitives = "the primitives are drawn as they are";

/// Why the primitives themselves are needed, not only their vertices; nullptr where they are not.
const char* why_primitives_are_made(const DrawRequest& request, const PathState& state) {
  if (state.unfilled && request.has_polygons) return "glPolygonMode makes lines or points of it";
  if (state.replaces_lines && request.has_lines)
    return "lines are stippled, or wider than the driver draws";
  return nullptr;
}

PathChoice path_of_arrays(const DrawRequest& request, const PathState& state) {
  if (const char* const rule = why_primitives_are_made(request, state))
    return {DrawPath::kRecorder, rule};
  if (request.fetched_by_driver && state.paths.arrays_direct)
    return {DrawPath::kArraysDirect, "the driver reads the buffer objects as they are"};
  if (!request.many_and_dense)
    return {DrawPath::kRecorder, "the vertices are few, or far apart in the arrays"};
  if (request.plain_quads)
    return {DrawPath::kRecorder, "how GL_QUADS are split depends on positions"};
  if (!state.paths.arrays_streamed)
    return {DrawPath::kRecorder, "LEGACY_GL_DISABLE has arrays_streamed"};
  if (request.has_tiny_normals && state.normalizes) return {DrawPath::kRecorder, kTinyNormals};
  return {DrawPath::kArraysStreamed, "the vertices are many, and close together in the arrays"};
}

PathChoice path_of_mesh(const DrawRequest& request, const PathState& state) {
  if (const char* const rule = why_primitives_are_made(request, state))
    return {DrawPath::kRecorder, rule};
  if (!state.paths.list_meshes) return {DrawPath::kRecorder, "LEGACY_GL_DISABLE has list_meshes"};
  if (request.has_tiny_normals && state.normalizes) return {DrawPath::kRecorder, kTinyNormals};
  return {DrawPath::kMesh, kNoPrimitives};
}

PathChoice path_of_batch(const DrawRequest& request, const PathState& state) {
  if (const char* const rule = why_primitives_are_made(request, state))
    return {DrawPath::kExpanded, rule};
  return {DrawPath::kBatch, kNoPrimitives};
}

}  // namespace

PathChoice choose_path(const DrawRequest& request, const PathState& state) {
  if (!state.renders) {
    const bool is_batch = request.source == DrawRequest::Source::kBatch;
    return {is_batch ? DrawPath::kCpuPipeline : DrawPath::kRecorder,
            "glRenderMode is not GL_RENDER"};
  }
  switch (request.source) {
    case DrawRequest::Source::kArrays: return path_of_arrays(request, state);
    case DrawRequest::Source::kMesh: return path_of_mesh(request, state);
    case DrawRequest::Source::kBatch: break;
  }
  return path_of_batch(request, state);
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
