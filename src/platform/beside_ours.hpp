#pragma once
#include <legacy_gl/context.h>

namespace legacy_gl::platform {

/// Around a call of the driver's own: what was recorded is drawn before it, and nothing is believed
/// to be bound after it (docs/coexistence.md).
class BesideOurs {
 public:
  BesideOurs() { legacy_gl_flush(); }
  ~BesideOurs() { legacy_gl_reset_driver_state(); }
  BesideOurs(const BesideOurs&) = delete;
  BesideOurs& operator=(const BesideOurs&) = delete;
};

}  // namespace legacy_gl::platform
