#pragma once
#include <map>
#include <memory>
#include <mutex>

#include "state/free_names.hpp"

namespace legacy_gl {

/// The names, and the objects of one kind, that contexts which share see alike, from any thread.
/// When memory runs out in a call, nothing has changed. Objects are never freed under the lock:
/// their destructors may take others.
template <typename Object>
class SharedNames {
 public:
  using Pointer = std::shared_ptr<Object>;

  /// nullptr for names that are unused or reserved.
  Pointer find(GLuint name) const {
    const std::lock_guard lock(mutex_);
    const auto at = objects_.find(name);
    return at == objects_.end() ? nullptr : at->second;
  }

  /// The name is in use, if only reserved.
  bool contains(GLuint name) const {
    const std::lock_guard lock(mutex_);
    return objects_.contains(name);
  }

  /// The first of `count` unused names in a row, each now one of `object`, or reserved when that is
  /// nullptr; 0 when there are none.
  GLuint generate(GLuint count, const Pointer& object) {
    const std::lock_guard lock(mutex_);
    const GLuint first = free_.find(count);
    if (first == 0) return 0;
    Objects made;
    for (GLuint i = 0; i < count; ++i) made.emplace_hint(made.end(), first + i, object);
    free_.take(first, count);
    objects_.merge(made);
    return first;
  }

  /// The object of that name, by `make(reserved)` if there is none.
  template <typename Make>
  Pointer find_or_create(GLuint name, Make make) {
    const std::lock_guard lock(mutex_);
    const auto at = objects_.find(name);
    if (at == objects_.end()) return insert(name, make(false));
    if (!at->second) at->second = make(true);
    return at->second;
  }

  /// The name, new or not, is one of this object; or reserved when it is nullptr.
  void store(GLuint name, Pointer object) {
    const std::lock_guard lock(mutex_);
    const auto at = objects_.find(name);
    if (at == objects_.end()) insert(name, std::move(object));
    else at->second.swap(object);
  }

  /// False when none of the names was in use.
  bool erase(GLuint first, GLuint count) {
    Objects erased;
    const std::lock_guard lock(mutex_);
    auto at = objects_.lower_bound(first);
    while (at != objects_.end() && at->first - first < count) {
      free_.release(at->first, 1);
      erased.insert(objects_.extract(at++));
    }
    return !erased.empty();
  }

 private:
  using Objects = std::map<GLuint, Pointer>;

  const Pointer& insert(GLuint name, Pointer object) {
    Objects made;
    const Pointer& inserted = made.emplace(name, std::move(object)).first->second;
    free_.use(name);
    objects_.merge(made);
    return inserted;
  }

  mutable std::mutex mutex_;
  Objects objects_;  ///< nullptr: reserved
  FreeNames free_;   ///< all names but the keys of objects_, and 0
};

}  // namespace legacy_gl
