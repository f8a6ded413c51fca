#include "state/free_names.hpp"

#include <iterator>

namespace legacy_gl {

namespace {

/// Whether `count` names fit; a range may have all names but 0, so that its size always fits.
bool holds(const std::pair<const GLuint, GLuint>& range, GLuint count) {
  return range.second - range.first >= count - 1;
}

}  // namespace

GLuint FreeNames::find(GLuint count) const {
  if (ranges_.empty() || count == 0) return 0;
  if (holds(*ranges_.begin(), count)) return ranges_.begin()->first;
  // Behind all used names there is nearly always room.
  if (holds(*ranges_.rbegin(), count)) return ranges_.rbegin()->first;
  for (const auto& range : ranges_)
    if (holds(range, count)) return range.first;
  return 0;
}

void FreeNames::take(GLuint first, GLuint count) noexcept {
  auto node = ranges_.extract(first);
  if (first + (count - 1) == node.mapped()) return;
  node.key() = first + count;
  ranges_.insert(std::move(node));
}

void FreeNames::use(GLuint name) {
  auto range = ranges_.upper_bound(name);
  if (range == ranges_.begin()) return;
  --range;
  if (name > range->second) return;
  if (name == range->first) return take(name, 1);
  if (name < range->second) ranges_.emplace(name + 1, range->second);
  range->second = name - 1;
}

void FreeNames::release(GLuint first, GLuint count) {
  if (count == 0) return;
  const GLuint last = first + (count - 1);
  const auto after = ranges_.upper_bound(last);
  const bool joins_after = after != ranges_.end() && after->first == last + 1;
  const bool joins_before = after != ranges_.begin() && std::prev(after)->second + 1 == first;
  if (joins_before) {
    std::prev(after)->second = joins_after ? after->second : last;
    if (joins_after) ranges_.erase(after);
  } else if (joins_after) {
    auto node = ranges_.extract(after);
    node.key() = first;
    ranges_.insert(std::move(node));
  } else {
    ranges_.emplace(first, last);
  }
}

}  // namespace legacy_gl
