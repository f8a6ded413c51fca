// Calls by name: what a Program's calls do.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/program.hpp"
#include "support/gl_functions.hpp"

namespace legacy_gl::fuzz {

struct Output {
  std::string element;
  std::vector<std::byte> bytes;
};

// What a call gave back.
struct Result {
  bool returned = false;
  double value = 0;
  std::vector<Output> outputs;
};

// Makes the call. What it writes goes to arrays of the result, which the driver may keep
// (glSelectBuffer): the result must live as long as they are in use. Throws std::runtime_error when
// there is no such call or the arguments do not fit it.
void invoke(const GlFunctions& gl, const Call& call, Result& result);

// Of a #define in <legacy_gl/gl.h>. Throws std::runtime_error.
std::uint32_t gl_name_value(std::string_view name);

}  // namespace legacy_gl::fuzz
