#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/list_mesh.hpp"

namespace legacy_gl {

/// Small objects that a program gives by Begin/End again and again: their vertices are compared
/// with those that were kept, and a closed one is drawn as if it came from a list.
class RepeatedObjects {
 public:
  struct Found {
    std::shared_ptr<const ListMesh> mesh;  ///< nullptr when none is kept
    bool has_quads = false;                ///< of which the mesh has halves
  };
  /// The mesh that the last object of a lit batch equals.
  Found find(const Recorder& recorder);

 private:
  struct Entry {
    std::uint64_t hash = 0;
    unsigned seen = 0;              ///< times that it was met, less those that another was met here
    unsigned failures = 0;          ///< times that it had changed
    std::vector<float> vertices{};  ///< as the batch has them before they are lit
    std::vector<PrimitiveRun> runs{};  ///< from its first vertex on
    Found found{};
  };

  static constexpr unsigned kHashBits = 8;
  std::array<Entry, 1u << kHashBits> entries_;  ///< one for each hash, in its first bits
};

}  // namespace legacy_gl
