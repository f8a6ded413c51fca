#include "dlist/list_state.hpp"

namespace legacy_gl {

std::shared_ptr<const DisplayList> ListNames::find(GLuint name) const {
  const std::lock_guard lock(mutex_);
  const auto at = lists_.find(name);
  return at == lists_.end() ? nullptr : at->second;
}

bool ListNames::contains(GLuint name) const {
  const std::lock_guard lock(mutex_);
  return lists_.contains(name);
}

void ListNames::store(GLuint name, std::shared_ptr<const DisplayList> list) {
  const std::lock_guard lock(mutex_);
  lists_[name] = std::move(list);
}

void ListNames::erase(GLuint first, GLuint count) {
  const std::lock_guard lock(mutex_);
  const auto begin = lists_.lower_bound(first);
  auto end = begin;
  while (end != lists_.end() && end->first - first < count) ++end;
  lists_.erase(begin, end);
}

GLuint ListNames::generate(GLuint count) {
  const std::lock_guard lock(mutex_);
  GLuint first = 1;
  for (const auto& [name, list] : lists_) {
    if (name - first >= count) break;
    first = name + 1;
  }
  if (first == 0 || first + (count - 1) < first) return 0;
  const auto empty = std::make_shared<const DisplayList>();
  for (GLuint i = 0; i < count; ++i) lists_[first + i] = empty;
  return first;
}

}  // namespace legacy_gl
