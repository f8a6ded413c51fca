#pragma once
#include "context/context.hpp"
#include "geometry/list_mesh.hpp"

namespace legacy_gl {

/// Draws a display list's mesh from the buffers that keep it.
void draw_mesh_from_buffers(Context& context, const ListMesh& mesh);

}  // namespace legacy_gl
