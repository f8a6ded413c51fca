// Whether a program may be played: what a minimiser leaves must not read beyond arrays.
#pragma once

#include "fuzz/program.hpp"

namespace legacy_gl::fuzz {

// All client arrays have this many vertices.
constexpr int array_vertices = 12;

// Begin and End, NewList and EndList are balanced, and each draw from arrays finds what it reads.
bool playable(const Program& program);

}  // namespace legacy_gl::fuzz
