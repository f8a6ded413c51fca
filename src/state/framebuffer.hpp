#pragma once
#include "state/context.hpp"

namespace legacy_gl {

enum class FramebufferChannel { kRed, kGreen, kBlue, kAlpha, kDepth, kStencil };

/// Bits of the channel in the framebuffer that the driver draws into now.
GLint framebuffer_bits(const Context& context, FramebufferChannel channel);

/// The program bound a framebuffer object, or made its context without a window.
bool draws_to_framebuffer_object(const Context& context);

bool is_double_buffered(const Context& context);
bool is_stereo(const Context& context);

}  // namespace legacy_gl
