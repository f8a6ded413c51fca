#pragma once
#include <atomic>
#include <list>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// What is to be freed when its last owner is gone, but not by that owner: it may be dropped in any
/// thread, and only a context that has its driver context current can free driver objects.
template <typename Name>
class DeletedQueue {
 public:
  /// Allocates nothing: owners keep the one element that it takes.
  void add(std::list<Name>& name) noexcept {
    const std::lock_guard lock(mutex_);
    names_.splice(names_.end(), name);
    waiting_ = true;
  }

  /// Hands those that wait to `free(count, names)`.
  template <typename Free>
  void collect(Free free) {
    if (!waiting_.load(std::memory_order_relaxed)) return;
    std::list<Name> names;
    {
      const std::lock_guard lock(mutex_);
      names.swap(names_);
      waiting_ = false;
    }
    for (const Name& name : names) free(1, &name);
  }

 private:
  std::mutex mutex_;
  std::list<Name> names_;
  std::atomic<bool> waiting_ = false;
};

/// Names of driver objects.
using DeletedNames = DeletedQueue<GLuint>;

/// Member of an object that others keep something beside: tells each of them when it is gone.
template <typename Name>
class DeletionNotices {
 public:
  DeletionNotices() = default;
  ~DeletionNotices() {
    for (Notice& notice : notices_) notice.queue->add(notice.name);
  }
  DeletionNotices(const DeletionNotices&) = delete;
  DeletionNotices& operator=(const DeletionNotices&) = delete;

  /// From any thread.
  void give_to(std::shared_ptr<DeletedQueue<Name>> queue, Name name) {
    const std::lock_guard lock(mutex_);
    notices_.push_back({std::move(queue), {name}});
  }

 private:
  struct Notice {
    std::shared_ptr<DeletedQueue<Name>> queue;
    std::list<Name> name;
  };
  std::mutex mutex_;
  std::vector<Notice> notices_;
};

/// The driver's object behind one of ours: made when it is asked for first, by whichever thread.
class DriverName {
 public:
  explicit DriverName(std::shared_ptr<DeletedNames> deleted) : deleted_(std::move(deleted)) {}
  ~DriverName() {
    if (!owned_.empty()) deleted_->add(owned_);
  }
  DriverName(const DriverName&) = delete;
  DriverName& operator=(const DriverName&) = delete;

  /// 0 before it is made.
  GLuint get() const { return name_.load(std::memory_order_acquire); }

  template <typename Make>
  GLuint get_or_make(Make make) {
    if (const GLuint name = get()) return name;
    const std::lock_guard lock(mutex_);
    if (const GLuint name = get()) return name;
    std::list<GLuint> owned(1);
    owned.front() = make();
    owned_.swap(owned);
    name_.store(owned_.front(), std::memory_order_release);
    return owned_.front();
  }

 private:
  std::shared_ptr<DeletedNames> deleted_;
  std::mutex mutex_;
  std::list<GLuint> owned_;
  std::atomic<GLuint> name_ = 0;
};

}  // namespace legacy_gl
