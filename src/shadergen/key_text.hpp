#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "shadergen/program_key.hpp"

namespace legacy_gl {

/// The key as hexadecimal digits, one line without spaces. Keys that differ make texts that differ.
/// Only the generator that wrote it reads it (generator_version.hpp).
std::string to_text(const ProgramKey& key);

/// Nothing when `text` is not a whole key with every field in its range. Such a key is safe to
/// generate from; whether a state leads to it is not known.
std::optional<ProgramKey> key_of(std::string_view text);

}  // namespace legacy_gl
