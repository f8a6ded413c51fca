// What the benchmarks share: clocks and the median.
#pragma once

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

namespace legacy_gl::test {

inline double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Of the process: the driver's threads count.
inline double cpu_seconds() { return seconds(CLOCK_PROCESS_CPUTIME_ID); }

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace legacy_gl::test
