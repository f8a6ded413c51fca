#pragma once
#include "state/gl_types.hpp"

namespace legacy_gl {

/// What the framebuffer that is drawn into is made of.
struct FramebufferFacts {
  bool has_sample_buffers = false;
  bool operator==(const FramebufferFacts&) const = default;
};

}  // namespace legacy_gl
