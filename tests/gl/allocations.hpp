// Counts what this thread takes from operator new. Linking allocations.cpp replaces it for the
// whole program: this library's C++, but not Mesa's C, which takes its memory from malloc.
#pragma once

#include <cstdint>

namespace legacy_gl::test {

// Since the program began, in this thread.
std::uint64_t allocation_count();

}  // namespace legacy_gl::test
