// What glGet and its siblings tell of a context, to prove that a call changed nothing.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "support/gl_functions.hpp"

namespace legacy_gl::test {

// Value by name, e.g. "GL_LIGHT2 GL_POSITION".
using StateSnapshot = std::map<std::string, std::vector<double>>;

StateSnapshot take_snapshot(const GlFunctions& gl);

// The names whose values differ, with both values; empty when there is none.
std::string difference(const StateSnapshot& before, const StateSnapshot& after);

// The names that the context does not know, one a line.
std::string unknown_names(const StateSnapshot& snapshot);

}  // namespace legacy_gl::test
