#pragma once
// How the drop-in exports a function, and how it passes one to the driver.
#include "platform/driver_libraries.hpp"

#define LEGACY_GL_EXPORT extern "C" __attribute__((visibility("default")))

/// Calls the driver's function of the same name, found by `find` at the first call.
#define LEGACY_GL_CALL_DRIVER(find, result, name, arguments)                            \
  static const auto driver_function = reinterpret_cast<decltype(&(name))>(find(#name)); \
  if (!driver_function) {                                                               \
    legacy_gl::platform::report_missing(#name);                                         \
    using Result = result;                                                              \
    return Result();                                                                    \
  }                                                                                     \
  return driver_function arguments
