#pragma once
#include <cstdint>
#include <vector>

#include "geometry/primitive_run.hpp"

namespace legacy_gl {

/// What the core profile draws a primitive as.
GLenum core_mode(GLenum mode);

/// The core profile draws the mode's vertices as they come; the others need indices.
bool draws_without_indices(GLenum mode);

/// Primitives of the core mode that follow one another can be drawn in one call with their indices
/// joined.
bool joins_in_one_draw(GLenum core_mode);

/// Appends the indices that draw `run` as core_mode(run.mode): vertices from run.first on, or for
/// an indexed run what `elements` says from run.first on, with `base_vertex` added. Flat shading
/// takes a triangle's colour from its last vertex, which is the polygon's own (GL 2.1 spec 2.14.7,
/// table 2.12). The reference splits a quad from its second vertex to its fourth where its
/// primitive pipeline runs (flat shading, clipping) or where it is indexed, and from its first to
/// its third otherwise: `pipeline_split` chooses.
void append_indices(const PrimitiveRun& run, const std::vector<std::uint32_t>& elements,
                    std::uint32_t base_vertex, bool pipeline_split,
                    std::vector<std::uint32_t>& indices);

/// Appends the triangles that `run` is made of, the last vertex of each the provoking one. False
/// for points and lines.
bool append_triangles(const PrimitiveRun& run, const std::vector<std::uint32_t>& elements,
                      std::vector<std::uint32_t>& triangles);

}  // namespace legacy_gl
