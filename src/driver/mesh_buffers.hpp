#pragma once
#include <memory>
#include <unordered_map>

#include "driver/driver.hpp"
#include "driver/vertex_arrays.hpp"
#include "geometry/list_mesh.hpp"

namespace legacy_gl {

/// A list's mesh in the driver: uploaded when this context draws it first, deleted after the list
/// is gone.
class MeshBuffers {
 public:
  struct Entry {
    std::weak_ptr<const ListMesh> mesh;
    GLuint vertex_buffer = 0, index_buffer = 0, array = 0;
  };

  explicit MeshBuffers(const Driver& driver) : driver_(driver) {}
  ~MeshBuffers();
  MeshBuffers(const MeshBuffers&) = delete;
  MeshBuffers& operator=(const MeshBuffers&) = delete;

  /// `uploaded` says that the mesh was not in the driver yet; the array may then be bound.
  Entry& find_or_upload(const ListMesh& mesh, bool& uploaded);

 private:
  void erase(const Entry& entry);
  void erase_expired();

  const Driver& driver_;
  std::unordered_map<const ListMesh*, Entry> entries_;
  std::size_t sweep_at_ = 64;  ///< entries at which the next look for expired ones is worth it
};

}  // namespace legacy_gl
