// What differs between two recordings of a program.
#pragma once

#include <optional>
#include <string>

#include "fuzz/play.hpp"

namespace legacy_gl::fuzz {

struct Difference {
  std::string kind;   // "picture", "diagnostic", or the name of the call that answered otherwise
  std::string words;  // for people
  int frame = 0;      // the first that differs
};

// The first difference that rounding does not explain.
std::optional<Difference> compare(const Program& program, const Recording& ours,
                                  const Recording& mesa);

}  // namespace legacy_gl::fuzz
