// Included in front of the files of src/api: for the linker, their functions are called
// plain_lglBegin. The public lglBegin is in logged_calls.cpp, which logs a call where that is asked
// for and makes it.
#pragma once
#include "state/gl_types.hpp"

// NOLINTBEGIN(readability-redundant-declaration): gl.h declares them without the linker's names.
extern "C" {
#define LEGACY_GL_LOGGED_CALL(result, name, parameters, ...) \
  result LEGACY_GL_APIENTRY lgl##name parameters __asm__("plain_lgl" #name);
#include "api/logged_calls.inc"
#undef LEGACY_GL_LOGGED_CALL
}
// NOLINTEND(readability-redundant-declaration)
