#include "record/record_mesh.hpp"

#include <algorithm>
#include <cstring>

#include "record/pending.hpp"
#include "record/renderer.hpp"

namespace legacy_gl {

void record_mesh(Context& context, const ListMesh& mesh) {
  Recorder& recorder = context.recorder;
  const std::uint32_t count = mesh.vertex_count();
  float* const vertices =
      recorder.append_vertices(context, count, false, mesh.layout.wide_texcoords);
  const std::uint32_t base = recorder.vertex_count() - count;
  recorder.put_current(context, recorder.layout(), vertices, count);
  const VertexOffsets to = recorder.offsets(), from = offsets_of(mesh.layout);
  const auto both = static_cast<std::uint16_t>(recorder.layout().fields & mesh.layout.fields);
  const bool has_normals =
      mesh.layout.fields & kFieldNormal && recorder.layout().fields & (kFieldNormal | kFieldShaded);
  const unsigned units = recorder.layout().texcoords & mesh.layout.texcoords;
  for (std::uint32_t i = 0; i < count; ++i) {
    float* const target = vertices + std::size_t{i} * to.stride;
    const float* const source = mesh.vertices.data() + std::size_t{i} * from.stride;
    const auto copy = [&](unsigned at, unsigned source_at, unsigned size) {
      std::memcpy(target + at, source + source_at, size * sizeof(float));
    };
    copy(0, 0, 3);
    if (to.position_size == 4) target[3] = 1;
    if (has_normals) copy(to.normal, from.normal, 3);
    if (both & kFieldColor) copy(to.color, from.color, 4);
    if (both & kFieldSecondaryColor) copy(to.secondary_color, from.secondary_color, 3);
    if (both & kFieldFogCoord) copy(to.fog_coord, from.fog_coord, 1);
    for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit) {
      if (!(units & 1u << unit)) continue;
      if (texcoord_size(recorder.layout(), unit) == 4) {
        target[to.texcoords[unit] + 2] = 0;
        target[to.texcoords[unit] + 3] = 1;
      }
      copy(to.texcoords[unit], from.texcoords[unit], texcoord_size(mesh.layout, unit));
    }
  }
  for (const PrimitiveRun& run : mesh.runs) {
    std::uint32_t* const elements = recorder.append_elements(context, run.mode, run.count);
    for (std::uint32_t i = 0; i < run.count; ++i)
      elements[i] = base + (run.indexed ? mesh.elements[run.first + i] : run.first + i);
  }
  recorder.flush_if_large(context);
}

void draw_mesh(Context& context, const ListMesh& mesh) {
  if (context.recorder.inside_begin_end()) return raise_error(context, GL_INVALID_OPERATION);
  if (context.renderer) context.renderer->draw_mesh(context, mesh);
  else record_mesh(context, mesh);
}

}  // namespace legacy_gl
