/// The structs of <legacy_gl/context.h> that begin with their size: those of a program that was
/// compiled with other headers than this library.
#pragma once

#include <legacy_gl/context.h>

#include <string>

namespace legacy_gl {

/// What was given, in the layout of this library; fields that the program does not know are 0.
/// Returns what is wrong with it, or an empty text.
std::string read_options(const legacy_gl_options* given, legacy_gl_options& options);

/// Fills as many of the program's counters as both sides know. Returns what is wrong, or an empty
/// text.
std::string write_statistics(const legacy_gl_statistics& statistics, legacy_gl_statistics* given);

}  // namespace legacy_gl
