// The smallest program that still does something.
#pragma once

#include <functional>

#include "fuzz/program.hpp"

namespace legacy_gl::fuzz {

// Leaves out calls, then simplifies numbers, while `fails` says true; stops after that many
// seconds.
Program minimise(Program program, const std::function<bool(const Program&)>& fails, double seconds);

}  // namespace legacy_gl::fuzz
