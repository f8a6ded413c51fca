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

bool MeshBuffers::free_deleted() {
  bool any = false;
  deleted_->collect([&](int, const ListMesh* const* mesh) {
    const auto at = entries_.find(*mesh);
    // A new mesh may lie where a deleted one was.
    if (at == entries_.end() || !at->second.mesh.expired()) return;
    erase(at->second);
    entries_.erase(at);
    any = true;
  });
  return any;
}

MeshBuffers::Entry& MeshBuffers::find_or_upload(const ListMesh& mesh, bool& uploaded) {
  const auto at = entries_.find(&mesh);
  const bool known = at != entries_.end() && !at->second.mesh.expired();
  if (known && at->second.stored) return at->second;
  uploaded = true;
  if (at != entries_.end()) {  // a new mesh where a deleted one was, or no memory was there
    erase(at->second);
    entries_.erase(at);
  }
  free_deleted();

  Entry& entry = entries_[&mesh];
  entry.mesh = mesh.weak_from_this();
  if (!known) mesh.deletion_notices.give_to(deleted_, &mesh);
  forget_errors(driver_);
  entry.vertex_buffer = build_buffer(driver_, GL_ARRAY_BUFFER, mesh.vertices.data(),
                                     mesh.vertices.size() * sizeof(float));
  entry.index_buffer = build_buffer(driver_, GL_COPY_WRITE_BUFFER, mesh.indices.data(),
                                    mesh.indices.size() * sizeof(std::uint32_t));
  entry.array = build_vertex_array(driver_, mesh.layout, entry.vertex_buffer, entry.index_buffer);
  entry.stored = driver_.GetError() == GL_NO_ERROR;
  return entry;
}

}  // namespace legacy_gl
