#pragma once
#include <cstdint>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// Vertices `first` to `first + count - 1` of the batch, drawn as one or more primitives of `mode`.
/// An indexed run counts elements() instead, each of which names a vertex of the batch.
struct PrimitiveRun {
  GLenum mode = GL_POINTS;
  std::uint32_t first = 0;
  std::uint32_t count = 0;
  bool indexed = false;
  /// Crosses the border of the view: drivers clip all that they draw together with it.
  bool crosses_clip_volume = false;
};

/// Vertices at the end of a run that complete no primitive are dropped (GL 2.1 spec 2.6.1).
std::uint32_t whole_primitives(GLenum mode, std::uint32_t count);

/// What lies between changes of matrix or material is small up to this: then it may join others.
inline constexpr std::uint32_t kSmallDrawVertices = 128;

}  // namespace legacy_gl
