// Meshes of display lists, drawn from the buffers that keep them.
#include "backend/backend.hpp"
#include "immediate/draw_mesh.hpp"
#include "shadergen/attributes.hpp"

namespace legacy_gl {

void draw_kept_mesh(Context& context, const ListMesh& mesh) {
  context.backend->draw_mesh(context, mesh);
}

void Backend::draw_mesh(Context& context, const ListMesh& mesh) {
  const VertexLayout wanted = Recorder::relevant_layout(context);
  prepare(context, wanted);
  bool uploaded = false;
  const MeshBuffers::Entry& buffers = meshes_.find_or_upload(mesh, uploaded);
  if (uploaded) {
    bound_array_ = buffers.array;  // building it has bound it
    context.statistics.vertex_bytes_uploaded += mesh.vertices.size() * sizeof(float);
    context.statistics.index_bytes_uploaded += mesh.indices.size() * sizeof(std::uint32_t);
    context.statistics.list_vertices_welded += mesh.welded;
  }
  bind_vertex_array(buffers.array);
  // What the list does not say is the current value when it is called.
  const auto missing = static_cast<std::uint8_t>(wanted.fields & ~mesh.layout.fields);
  const CurrentValues& current = context.current;
  if (missing & kFieldNormal) {
    const glm::vec4 normal(current.normal, 1);
    driver.VertexAttrib4fv(kLocationNormal, &normal[0]);
  }
  if (missing & kFieldColor) driver.VertexAttrib4fv(kLocationColor, &current.color[0]);
  if (missing & kFieldSecondaryColor)
    driver.VertexAttrib4fv(kLocationSecondaryColor, &current.secondary_color[0]);
  if (missing & kFieldFogCoord) {
    const glm::vec4 coordinate(current.fog_coordinate, 0, 0, 1);
    driver.VertexAttrib4fv(kLocationFogCoord, &coordinate[0]);
  }

  for (const ListMesh::Draw& draw : mesh.draws) {
    if (!use_program(context, draw.mode == GL_POINTS, mesh.vertex_count())) continue;
    const auto count = static_cast<GLsizei>(draw.count);
    ++context.statistics.draws;
    if (draw.indexed) {
      driver.DrawElements(draw.mode, count, GL_UNSIGNED_INT,
                          reinterpret_cast<const void*>(draw.first * sizeof(std::uint32_t)));
    } else if (count > 1 && driver.MultiDrawArrays) {
      driver.MultiDrawArrays(draw.mode, &mesh.firsts[draw.first], &mesh.counts[draw.first], count);
    } else {
      for (std::uint32_t i = draw.first; i < draw.first + draw.count; ++i)
        driver.DrawArrays(draw.mode, mesh.firsts[i], mesh.counts[i]);
      context.statistics.draws += draw.count - 1;
    }
  }
  context.statistics.vertices += mesh.vertex_count();
  ++context.statistics.batches;
}

}  // namespace legacy_gl
