// What is not compared, and why: rows of docs/deviations.md that programs cannot be made without,
// and faults that are known and not mended yet.
#pragma once

#include "fuzz/comparison.hpp"
#include "fuzz/contexts.hpp"

namespace legacy_gl::fuzz {

// The row that keeps the program from being compared in this mode, or nullptr.
const char* deviation(const Program& program, const Mode& mode);

// The fault that explains the difference, or nullptr.
const char* known_fault(const Program& program, const Mode& mode, const Difference& difference);

}  // namespace legacy_gl::fuzz
