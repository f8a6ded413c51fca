#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/list_mesh.hpp"

namespace legacy_gl {

/// A draw that was met so often is copied.
inline constexpr unsigned kCopiesWhenMet = 3;
/// What goes on otherwise so often, one time after the other, is not looked at any more.
inline constexpr unsigned kMostFailures = 3;

/// What is remembered of draws that may come again. Each entry has a `mesh`, or none yet, and
/// `last_used`. Entries and what their meshes take are bounded: the least recently used go first.
template <typename Entry>
class RecentEntries {
 public:
  static constexpr std::size_t kMostEntries = 32;
  static constexpr std::size_t kMostFloats = std::size_t{16} << 20;  ///< of all meshes together

  /// The entry that `matches` holds for; else `fresh`, if need be in place of another.
  template <typename Matches>
  Entry& find_or_add(Matches matches, const Entry& fresh) {
    auto at = std::find_if(entries_.begin(), entries_.end(), matches);
    if (at == entries_.end() && entries_.size() < kMostEntries) {
      at = entries_.insert(at, fresh);
    } else if (at == entries_.end()) {
      at = std::min_element(entries_.begin(), entries_.end(), used_earlier);
      *at = fresh;
    }
    at->last_used = ++clock_;
    return *at;
  }

  /// After a mesh was added to the entry that was used last: others give up theirs.
  void make_room() {
    for (;;) {
      std::size_t floats = 0;
      Entry* oldest = nullptr;
      for (Entry& entry : entries_) {
        if (!entry.mesh) continue;
        floats += entry.mesh->vertices.size();
        if (entry.last_used != clock_ && (!oldest || used_earlier(entry, *oldest))) oldest = &entry;
      }
      if (floats <= kMostFloats || !oldest) return;
      oldest->mesh.reset();
      oldest->seen = 0;
    }
  }

 private:
  static bool used_earlier(const Entry& a, const Entry& b) { return a.last_used < b.last_used; }

  std::uint64_t clock_ = 0;
  std::vector<Entry> entries_;
};

}  // namespace legacy_gl
