#pragma once
#include <string>

#include "shadergen/program_key.hpp"

namespace legacy_gl {

/// The text of both stages. A pure function: the same key and dialect give the same bytes every
/// time.
struct ProgramSource {
  std::string vertex;
  std::string fragment;
};

ProgramSource generate(const ProgramKey& key, Dialect dialect);

}  // namespace legacy_gl
