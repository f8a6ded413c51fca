// Between the library and the driver: a loader whose functions tell an observer of each call, which
// may also keep the call from the driver.
#pragma once

#include <legacy_gl/context.h>

#include <array>
#include <cstdint>
#include <cstring>

namespace legacy_gl::test {

struct DriverCall {
  const char* name;                         // "glBindBuffer"
  std::array<std::uint64_t, 12> arguments;  // pointers and integers as they are, floats' bits
  std::uint64_t argument(std::size_t i) const { return arguments[i]; }
  bool is(const char* other) const { return std::strcmp(name, other) == 0; }
};

// Observes the calls of this thread for as long as it lives; one at a time.
class DriverObserver {
 public:
  DriverObserver();
  virtual ~DriverObserver();
  DriverObserver(const DriverObserver&) = delete;
  DriverObserver& operator=(const DriverObserver&) = delete;
  // False: the driver is not called, and `answer` is its answer.
  virtual bool before(const DriverCall&) { return true; }
  virtual std::uint32_t answer(const DriverCall&) { return 0; }
  virtual void after(const DriverCall&) {}
};

// The functions of OSMesa's core contexts. Those that the library does not know come from the
// driver as they are.
legacy_gl_proc shimmed_proc(const char* name);

}  // namespace legacy_gl::test
