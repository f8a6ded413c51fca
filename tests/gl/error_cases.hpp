// The table of errors: every call that the specification says to be wrong, from
// src/api/entry_points. One source for the documentation in gl.h and for these tests.
#pragma once

#include <vector>

#include "support/gl_functions.hpp"

namespace legacy_gl::test {

using Step = void (*)(const GlFunctions& gl);

struct ErrorCase {
  const char* entry_point;
  const char* when;
  const char* text;  // the call as C++
  GLenum code;
  bool in_lists;             // a display list holds the entry point
  bool inside_begin_end;     // allowed there, and wrong there as well
  const char* mesa_differs;  // why Mesa gives another code; nullptr: it gives the same
  Step setup;
  Step call;
};

struct ValidCall {
  const char* entry_point;
  const char* text;
  Step setup;
  Step call;
};

const std::vector<ErrorCase>& error_cases();
// Entry points that glBegin/glEnd excludes, in calls that are right outside.
const std::vector<ValidCall>& calls_inside_begin_end();

}  // namespace legacy_gl::test
