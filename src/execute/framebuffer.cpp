#include "execute/framebuffer.hpp"

#include <array>

#include "driver/driver_objects.hpp"
#include "record/pending.hpp"

namespace legacy_gl {

namespace {

GLint driver_integer(const Context& context, GLenum name) {
  GLint value = 0;
  context.driver->functions.GetIntegerv(name, &value);
  return value;
}

struct ChannelNames {
  GLenum bits;                ///< of OpenGL ES
  GLenum size;                ///< of the core profile, per attachment
  GLenum default_attachment;  ///< of the window's framebuffer; 0: a colour buffer
  GLenum object_attachment;
};

ChannelNames names_of(FramebufferChannel channel) {
  switch (channel) {
    case FramebufferChannel::kRed:
      return {GL_RED_BITS, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE, 0, GL_COLOR_ATTACHMENT0};
    case FramebufferChannel::kGreen:
      return {GL_GREEN_BITS, GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE, 0, GL_COLOR_ATTACHMENT0};
    case FramebufferChannel::kBlue:
      return {GL_BLUE_BITS, GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE, 0, GL_COLOR_ATTACHMENT0};
    case FramebufferChannel::kAlpha:
      return {GL_ALPHA_BITS, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE, 0, GL_COLOR_ATTACHMENT0};
    case FramebufferChannel::kDepth:
      return {GL_DEPTH_BITS, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, GL_DEPTH, GL_DEPTH_ATTACHMENT};
    case FramebufferChannel::kStencil: break;
  }
  return {GL_STENCIL_BITS, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, GL_STENCIL,
          GL_STENCIL_ATTACHMENT};
}

/// The front buffer of a window is out of reach for OpenGL ES.
bool has_front(const Context& context) {
  return !context.driver->functions.is_es() || draws_to_framebuffer_object(context);
}

/// A colour attachment of a framebuffer object.
bool is_attachment(GLenum mode) { return mode - GL_COLOR_ATTACHMENT0 < 16; }

/// What the driver calls the buffer.
GLenum driver_buffer(const Context& context, GLenum mode) {
  if (mode == GL_NONE || is_attachment(mode)) return mode;
  if (draws_to_framebuffer_object(context)) return GL_COLOR_ATTACHMENT0;
  if (context.driver->functions.is_es()) return GL_BACK;
  return mode == GL_BACK && !is_double_buffered(context) ? GLenum{GL_FRONT} : mode;
}

}  // namespace

bool draws_to_framebuffer_object(const Context& context) {
  return driver_integer(context, GL_DRAW_FRAMEBUFFER_BINDING) != 0;
}

GLenum multisampled_object_error(const Context& context) {
  const GLint read = driver_integer(context, GL_READ_FRAMEBUFFER_BINDING);
  // The driver tells the samples of what is drawn into.
  if (!read || read != driver_integer(context, GL_DRAW_FRAMEBUFFER_BINDING)) return GL_NO_ERROR;
  return driver_integer(context, GL_SAMPLE_BUFFERS) ? GL_INVALID_OPERATION : GL_NO_ERROR;
}

GLint framebuffer_bits(const Context& context, FramebufferChannel channel) {
  const Driver& driver = context.driver->functions;
  const ChannelNames names = names_of(channel);
  if (driver.is_es()) return driver_integer(context, names.bits);
  GLenum attachment = names.object_attachment;
  if (!draws_to_framebuffer_object(context)) {
    const GLenum color = is_double_buffered(context) ? GLenum{GL_BACK_LEFT} : GLenum{GL_FRONT_LEFT};
    attachment = names.default_attachment ? names.default_attachment : color;
  }
  // The size of an attachment that is not there is an error to ask for.
  const auto ask = [&](GLenum name) {
    GLint value = 0;
    driver.GetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, name, &value);
    return value;
  };
  return ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE ? 0 : ask(names.size);
}

bool is_double_buffered(const Context& context) {
  // A program that draws into a framebuffer object swaps by other means than ours, as EGL's windows
  // always do.
  if (context.driver->functions.is_es() || draws_to_framebuffer_object(context)) return true;
  return driver_integer(context, GL_DOUBLEBUFFER) != 0;
}

bool is_stereo(const Context& context) {
  return !context.driver->functions.is_es() && driver_integer(context, GL_STEREO) != 0;
}

GLenum initial_color_buffer(const Context& context) {
  return is_double_buffered(context) ? GL_BACK : GL_FRONT;
}

GLenum draw_buffer_error(const Context& context, GLenum mode) {
  if (is_attachment(mode))
    return draws_to_framebuffer_object(context) ? GL_NO_ERROR : GL_INVALID_OPERATION;
  switch (mode) {
    case GL_NONE:
    case GL_LEFT:
    case GL_FRONT_AND_BACK: return GL_NO_ERROR;
    case GL_FRONT:
    case GL_FRONT_LEFT: return has_front(context) ? GL_NO_ERROR : GL_INVALID_OPERATION;
    // Without a back buffer the front one stands for it: programs written for windows run without
    // one.
    case GL_BACK: return GL_NO_ERROR;
    case GL_BACK_LEFT: return is_double_buffered(context) ? GL_NO_ERROR : GL_INVALID_OPERATION;
    case GL_RIGHT:
    case GL_FRONT_RIGHT:
    case GL_BACK_RIGHT: return is_stereo(context) ? GL_NO_ERROR : GL_INVALID_OPERATION;
    case GL_AUX0:
    case GL_AUX1:
    case GL_AUX2:
    case GL_AUX3: return GL_INVALID_OPERATION;
    default: return GL_INVALID_ENUM;
  }
}

GLenum read_buffer_error(const Context& context, GLenum mode) {
  if (mode == GL_FRONT_AND_BACK) return GL_INVALID_ENUM;
  // Framebuffer objects without colours read none (EXT_framebuffer_object 4.3.2).
  if (mode == GL_NONE)
    return driver_integer(context, GL_READ_FRAMEBUFFER_BINDING) ? GL_NO_ERROR : GL_INVALID_ENUM;
  return draw_buffer_error(context, mode);
}

void set_draw_buffer(Context& context, GLenum mode) {
  const GLenum chosen = driver_buffer(context, mode);
  flush_pending(context);
  context.raster.color_buffer.draw_buffer = mode;
  const Driver& driver = context.driver->functions;
  if (driver.DrawBuffer) driver.DrawBuffer(chosen);
  else if (driver.DrawBuffers) driver.DrawBuffers(1, &chosen);
}

void set_read_buffer(Context& context, GLenum mode) {
  context.read_buffer = mode;
  context.driver->functions.ReadBuffer(driver_buffer(context, mode));
}

}  // namespace legacy_gl
