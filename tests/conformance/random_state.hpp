// Random lighting states: the same index gives the same state everywhere.
#pragma once

#include "support/gl_functions.hpp"

namespace legacy_gl::test {

constexpr int random_state_count = 2000;
constexpr int random_state_size = 64;  // pixels a side

// Sets the whole state it depends on, so that any number of them can be drawn in any order in one
// context. Values are of ordinary size and keep out of the rows of departures.cpp.
void draw_random_state(const GlFunctions& gl, int index);

}  // namespace legacy_gl::test
