// Calls that leave no state as it was initially. After each, every name is compared with Mesa's.
#pragma once
#include <ostream>
#include <span>

#include "support/gl_functions.hpp"

namespace legacy_gl::test {

struct QueryCalls {
  using Function = void (*)(const GlFunctions& gl);
  const char* name;
  Function calls;
};

inline void PrintTo(const QueryCalls& calls, std::ostream* out) { *out << calls.name; }

std::span<const QueryCalls> query_calls();

}  // namespace legacy_gl::test
