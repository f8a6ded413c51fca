// Meshes of display lists, drawn from the buffers that keep them.
#include "submit/mesh.hpp"

#include "geometry/clip_test.hpp"
#include "record/pending.hpp"
#include "submit/constant_attributes.hpp"
#include "submit/prepare.hpp"

namespace legacy_gl {

namespace {

/// The box around the mesh is beyond a clip plane.
bool is_outside(const ListMesh& mesh, const glm::mat4& modelview_projection) {
  std::array<float, 24> corners;
  for (unsigned corner = 0; corner < 8; ++corner)
    for (unsigned axis = 0; axis < 3; ++axis)
      corners[3 * corner + axis] =
          (corner >> axis & 1 ? mesh.highest : mesh.lowest)[static_cast<int>(axis)];
  return all_beyond_one_plane(modelview_projection, corners.data(), 8, 3, false);
}

}  // namespace

void draw_mesh_from_buffers(Context& context, const ListMesh& mesh) {
  DriverObjects& objects = *context.driver;
  const Driver& driver = context.driver->functions;
  Submission& submission = *context.submission;
  VertexLayout wanted = Recorder::relevant_layout(context);
  const unsigned kept = wanted.texcoords & mesh.layout.texcoords;
  wanted.wide_texcoords = static_cast<std::uint8_t>((wanted.wide_texcoords & ~kept) |
                                                    (mesh.layout.wide_texcoords & kept));
  DrawFacts facts;
  facts.unit_normals = mesh.unit_normals;
  const bool bounded = culls_lights(context);
  const DrawBounds bounds = bounded ? bounds_of(context, mesh) : DrawBounds{};
  if (bounded) facts.bounds = &bounds;
  update_inputs(context, wanted, facts);
  if (is_outside(mesh, submission.inputs.transform.modelview_projection)) {
    ++context.statistics.primitives_clipped;
    return;
  }
  apply_inputs(context);
  bool uploaded = false;
  MeshBuffers::Entry& buffers = objects.meshes.find_or_upload(mesh, uploaded);
  if (uploaded) {
    context.driver->bound_array = buffers.array;  // building it has bound it
    context.statistics.vertex_bytes_uploaded += mesh.vertices.size() * sizeof(float);
    context.statistics.index_bytes_uploaded += mesh.indices.size() * sizeof(std::uint32_t);
    context.statistics.list_vertices_welded += mesh.welded;
  }
  // What the list does not say is the current value when it is called.
  set_constant_attributes(context, static_cast<std::uint16_t>(wanted.fields & ~mesh.layout.fields),
                          wanted.texcoords & ~kept);
  context.statistics.vertices += mesh.vertex_count();
  ++context.statistics.batches;
  context.driver->bind_vertex_array(buffers.array);
  for (const ListMesh::Draw& draw : mesh.draws) {
    if (!use_program(context, draw.mode, mesh.vertex_count())) continue;
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
}

}  // namespace legacy_gl
