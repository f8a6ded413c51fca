#include "benchmark/heap.hpp"

#include <malloc.h>

namespace legacy_gl::test {

void pin_heap() {
  constexpr int kTopPadBytes = 64 << 20;
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_TOP_PAD, kTopPadBytes);
  mallopt(M_MMAP_MAX, 0);
}

}  // namespace legacy_gl::test
