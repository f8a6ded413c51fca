#pragma once
#include "context/context.hpp"

namespace legacy_gl {

enum class FramebufferChannel { kRed, kGreen, kBlue, kAlpha, kDepth, kStencil };

/// Bits of the channel in the framebuffer that the driver draws into now.
GLint framebuffer_bits(const Context& context, FramebufferChannel channel);

/// The program bound a framebuffer object, or made its context without a window.
bool draws_to_framebuffer_object(const Context& context);

/// Pixels of a framebuffer object with several samples cannot be read (EXT_framebuffer_multisample
/// 4.3.2): the error, or GL_NO_ERROR.
GLenum multisampled_object_error(const Context& context);

bool is_double_buffered(const Context& context);
bool is_stereo(const Context& context);

/// The application asked for an accumulation buffer.
inline bool has_accumulation_buffer(const Context& context) {
  return context.options.accumulation_buffer != 0;
}

/// What glDrawBuffer and glReadBuffer start as (GL 2.1 spec 4.2.1).
GLenum initial_color_buffer(const Context& context);

/// GL 2.1 spec 4.2.1, 4.3.2: the error of glDrawBuffer and glReadBuffer, or GL_NO_ERROR.
GLenum draw_buffer_error(const Context& context, GLenum mode);
GLenum read_buffer_error(const Context& context, GLenum mode);

/// Stores the buffer and hands it to the driver. A framebuffer object's first colour attachment
/// stands for every buffer of a window.
void set_draw_buffer(Context& context, GLenum mode);
void set_read_buffer(Context& context, GLenum mode);

}  // namespace legacy_gl
