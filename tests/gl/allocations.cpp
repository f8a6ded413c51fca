#include "allocations.hpp"

#include <cstdlib>
#include <new>
#include <utility>

namespace {

thread_local std::uint64_t count = 0;
thread_local std::uint64_t until_failure = 0;  // allocations from here on; 0: none fails
thread_local bool goes_on_failing = false, exempt = false;
thread_local std::uint64_t failures = 0;

bool fails() noexcept {
  ++count;
  if (exempt || until_failure == 0) return false;
  if (--until_failure != 0) return false;
  if (goes_on_failing) until_failure = 1;
  ++failures;
  return true;
}

void* allocate(std::size_t size) noexcept {
  return fails() ? nullptr : std::malloc(size ? size : 1);
}

void* allocate(std::size_t size, std::align_val_t alignment) noexcept {
  if (fails()) return nullptr;
  const auto to = static_cast<std::size_t>(alignment);
  return std::aligned_alloc(to, (size + to - 1) / to * to);
}

void* or_throw(void* memory) {
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

// All forms: one that stayed the library's own would meet the wrong operator delete.
void* operator new(std::size_t size) { return or_throw(allocate(size)); }
void* operator new[](std::size_t size) { return or_throw(allocate(size)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return or_throw(allocate(size, alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return or_throw(allocate(size, alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace legacy_gl::test {

std::uint64_t allocation_count() { return count; }

void fail_allocation(std::uint64_t nth, bool and_all_after_it) {
  until_failure = nth;
  goes_on_failing = and_all_after_it;
  failures = 0;
}

std::uint64_t failed_allocations() { return failures; }

bool exempt_allocations(bool on) { return std::exchange(exempt, on); }

}  // namespace legacy_gl::test
