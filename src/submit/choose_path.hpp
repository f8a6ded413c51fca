#pragma once
// How a draw reaches the driver: the one place that decides it.
#include <cstdint>

#include "context/optional_paths.hpp"
#include "state/gl_types.hpp"

namespace legacy_gl {

/// The ways to the driver.
enum class DrawPath {
  kRecorder,        ///< record/recorder: the primitives join a batch, which is a draw of its own
  kCpuPipeline,     ///< cpu_pipeline/: selection and feedback draw nothing
  kBatch,           ///< submit/batch.cpp: the recorder's batch as it is
  kExpanded,        ///< submit/expanded.cpp: a batch whose primitives are made into others
  kMesh,            ///< submit/mesh.cpp: a display list's mesh from its own buffers
  kArraysDirect,    ///< submit/arrays_direct.cpp: client arrays from where they lie in buffers
  kArraysStreamed,  ///< submit/arrays_streamed.cpp: client arrays by one copy into a stream
};
const char* name_of(DrawPath path);

/// Something to draw. (Pixel rectangles and bitmaps have one way each and ask nobody.)
struct DrawRequest {
  enum class Source { kBatch, kMesh, kArrays };
  Source source = Source::kBatch;
  bool has_polygons = false;  ///< triangles, quads, polygons, strips, fans
  bool has_lines = false;
  bool has_tiny_normals = false;  ///< some may be too short for the driver (tiny_normals.hpp)

  // Of client arrays:
  bool fetched_by_driver = false;  ///< all lie in buffer objects in a form that the driver reads
  bool many_and_dense = false;     ///< so many vertices, and hardly any unused between them
  bool plain_quads = false;  ///< GL_QUADS by glDrawArrays: how they are split depends on positions
};

/// What of the state decides.
struct PathState {
  bool renders = true;          ///< glRenderMode(GL_RENDER)
  bool unfilled = false;        ///< glPolygonMode makes polygons into lines or points
  bool replaces_lines = false;  ///< lines are made here: stippled, or wider than the driver draws
  bool normalizes = false;      ///< GL_NORMALIZE
  OptionalPaths paths = {};     ///< what LEGACY_GL_DISABLE leaves
};

struct PathChoice {
  DrawPath path;
  const char* rule;  ///< that has chosen it, in words for LEGACY_GL_DEBUG=paths
};

PathChoice choose_path(const DrawRequest& request, const PathState& state);

}  // namespace legacy_gl
