#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "context/context.hpp"
#include "geometry/list_mesh.hpp"
#include "software/recent_entries.hpp"

namespace legacy_gl {

/// What a program gives anew in every frame and always alike, by Begin/End: a large closed surface
/// among it is kept as a mesh, of which only what is seen is drawn.
///
/// The recorder hands its vertices over in parts, and a part is compared with what was kept before
/// it is known whether the rest will come. Until then nothing of it is drawn.
class RepeatedBatches {
 public:
  enum class Answer {
    kDraw,       ///< the part is to be drawn as it is
    kHeld,       ///< the part is as it was: it may be forgotten
    kComplete,   ///< and so was the whole: mesh() is to be drawn
    kDifferent,  ///< the part is not: what was held of mesh() is to be drawn, then the part
  };

  /// `last`: no more of this state follows.
  Answer take(const Context& context, bool last);

  /// The parts that follow belong to the one before.
  bool goes_on() const { return phase_ != Phase::kNone; }

  const std::shared_ptr<ListMesh>& mesh() const { return entry_->mesh; }
  /// What was held: so many vertices and runs of the mesh.
  std::uint32_t held_vertices() const { return vertices_; }
  std::size_t held_runs() const { return runs_; }

 private:
  enum class Phase : std::uint8_t { kNone, kIgnoring, kComparing, kCopying };

  struct Entry {
    std::uint64_t hash = 0;
    std::uint64_t last_used = 0;
    unsigned seen = 0;      ///< times that its first part was met
    unsigned failures = 0;  ///< times in a row that it did not go on as before
    std::shared_ptr<ListMesh> mesh;
  };

  Phase begin(const Context& context);
  Answer compare(const Context& context, bool last);
  void copy(const Context& context, bool last);

  Phase phase_ = Phase::kNone;
  Entry* entry_ = nullptr;
  std::shared_ptr<ListMesh> copied_;
  std::uint32_t vertices_ = 0;  ///< of the mesh, compared so far
  std::size_t runs_ = 0;
  RecentEntries<Entry> entries_;
};

}  // namespace legacy_gl
