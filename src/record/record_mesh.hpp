#pragma once
#include "geometry/list_mesh.hpp"

struct legacy_gl_context;

namespace legacy_gl {

/// Draws a list's mesh in the present state: from a buffer that keeps it, or through the recorder
/// where polygons are unfilled.
void draw_mesh(legacy_gl_context& context, const ListMesh& mesh);

/// The mesh's vertices and primitives join the recorder's batch.
void record_mesh(legacy_gl_context& context, const ListMesh& mesh);

/// The first of the two ways: the backend's.
void draw_kept_mesh(legacy_gl_context& context, const ListMesh& mesh);

}  // namespace legacy_gl
