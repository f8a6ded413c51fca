#pragma once
// The rows of vertex_variants_*.cpp: glVertex3s and its like convert their values and call what
// does the work. The log has functions of its own, so that the shortest way has no stack frame.
#include "debug/call_log.hpp"

using namespace legacy_gl;
using namespace legacy_gl::debug;
using Kind [[maybe_unused]] = Argument::Kind;

#define LEGACY_GL_VARIANT(name, parameters, values, work, ...)        \
  [[gnu::cold, gnu::noinline]] static void logged_##name parameters { \
    log_call("gl" #name, {__VA_ARGS__});                              \
    work;                                                             \
  }                                                                   \
  LEGACY_GL_API void LEGACY_GL_APIENTRY lgl##name parameters {        \
    if (!direct_context && names_calls()) [[unlikely]]                \
      return logged_##name values;                                    \
    work;                                                             \
  }
