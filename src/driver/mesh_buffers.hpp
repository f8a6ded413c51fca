#pragma once
#include <memory>
#include <unordered_map>

#include "driver/driver.hpp"
#include "driver/vertex_arrays.hpp"
#include "geometry/list_mesh.hpp"

namespace legacy_gl {

/// A list's mesh in the driver: uploaded when this context draws it first, deleted with the next
/// upload or flush after the list is gone.
class MeshBuffers {
 public:
  struct Entry {
    std::weak_ptr<const ListMesh> mesh;
    GLuint vertex_buffer = 0, index_buffer = 0, array = 0;
    bool stored = false;  ///< else the driver had no memory, and is asked again at the next draw
  };

  explicit MeshBuffers(const Driver& driver) : driver_(driver) {}
  ~MeshBuffers();
  MeshBuffers(const MeshBuffers&) = delete;
  MeshBuffers& operator=(const MeshBuffers&) = delete;

  /// `uploaded` says that the mesh was not in the driver yet; the array may then be bound.
  Entry& find_or_upload(const ListMesh& mesh, bool& uploaded);
  /// Deletes the driver's objects of meshes that are gone. False when there are none.
  bool free_deleted();

 private:
  void erase(const Entry& entry);

  const Driver& driver_;
  std::unordered_map<const ListMesh*, Entry> entries_;
  std::shared_ptr<DeletedQueue<const ListMesh*>> deleted_ =
      std::make_shared<DeletedQueue<const ListMesh*>>();
};

}  // namespace legacy_gl
