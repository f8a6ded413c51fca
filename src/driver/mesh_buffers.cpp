#include "driver/mesh_buffers.hpp"

namespace legacy_gl {

MeshBuffers::~MeshBuffers() {
  for (const auto& [mesh, entry] : entries_) erase(entry);
}

void MeshBuffers::erase(const Entry& entry) {
  driver_.DeleteVertexArrays(1, &entry.array);
  driver_.DeleteBuffers(1, &entry.vertex_buffer);
  driver_.DeleteBuffers(1, &entry.index_buffer);
}

void MeshBuffers::erase_expired() {
  std::erase_if(entries_, [this](const auto& item) {
    if (!item.second.mesh.expired()) return false;
    erase(item.second);
    return true;
  });
  sweep_at_ = 2 * entries_.size() + 64;
}

MeshBuffers::Entry& MeshBuffers::find_or_upload(const ListMesh& mesh, bool& uploaded) {
  const auto at = entries_.find(&mesh);
  if (at != entries_.end() && !at->second.mesh.expired()) return at->second;
  uploaded = true;
  if (at != entries_.end()) {  // a new mesh where a deleted one was
    erase(at->second);
    entries_.erase(at);
  }
  if (entries_.size() >= sweep_at_) erase_expired();

  Entry entry;
  entry.mesh = mesh.weak_from_this();
  entry.vertex_buffer = build_buffer(driver_, GL_ARRAY_BUFFER, mesh.vertices.data(),
                                     mesh.vertices.size() * sizeof(float));
  entry.index_buffer = build_buffer(driver_, GL_COPY_WRITE_BUFFER, mesh.indices.data(),
                                    mesh.indices.size() * sizeof(std::uint32_t));
  entry.array = build_vertex_array(driver_, mesh.layout, entry.vertex_buffer, entry.index_buffer);
  return entries_.emplace(&mesh, std::move(entry)).first->second;
}

}  // namespace legacy_gl
