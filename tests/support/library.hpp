// What tests ask of this library alone: its options and its counters.
#pragma once

#include <legacy_gl/context.h>

namespace legacy_gl::test {

/// Defaults but for the programs.
inline legacy_gl_options options_with(legacy_gl_programs programs) {
  legacy_gl_options options{};
  options.programs = programs;
  return options;
}

/// Of the current context.
inline legacy_gl_statistics statistics_now() {
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  return statistics;
}

}  // namespace legacy_gl::test
