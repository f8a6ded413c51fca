// Counts what this thread takes from operator new. Linking allocations.cpp replaces it for the
// whole program: this library's C++, but not Mesa's C, which takes its memory from malloc.
#pragma once

#include <cstdint>

namespace legacy_gl::test {

// Since the program began, in this thread.
std::uint64_t allocation_count();

// The nth allocation of this thread from here on fails, 1 being the next; 0: none does.
void fail_allocation(std::uint64_t nth, bool and_all_after_it = false);
// Since the last call of fail_allocation.
std::uint64_t failed_allocations();
// Allocations that are not to fail, as the driver's; answers what it was before.
bool exempt_allocations(bool on);

}  // namespace legacy_gl::test
