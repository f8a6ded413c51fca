// GL 2.1 spec 4.2.1, 4.3.2: glDrawBuffer, glReadBuffer, glReadPixels.

#include "api/pixel_buffers.hpp"
#include "dlist/dispatch.hpp"
#include "driver/driver_objects.hpp"
#include "driver/read_pixels.hpp"
#include "execute/framebuffer.hpp"
#include "record/pending.hpp"
#include "texture/pixel_format.hpp"

using namespace legacy_gl;

namespace {

bool inside(Context& c) {
  if (!c.recorder.inside_begin_end()) return false;
  raise_error(c, GL_INVALID_OPERATION);
  return true;
}

void draw_buffer(Context& c, GLenum mode) {
  if (inside(c)) return;
  if (const GLenum error = draw_buffer_error(c, mode)) return raise_error(c, error);
  set_draw_buffer(c, mode);
}

void read_buffer(Context& c, GLenum mode) {
  if (inside(c)) return;
  if (const GLenum error = read_buffer_error(c, mode)) return raise_error(c, error);
  set_read_buffer(c, mode);
}

void read_pixels_into(Context& c, PixelRectangle rectangle, GLenum format, GLenum type,
                      void* pixels) {
  if (inside(c)) return;
  if (rectangle.width < 0 || rectangle.height < 0) return raise_error(c, GL_INVALID_VALUE);
  if (const GLenum error = pixel_rectangle_error(format, type)) return raise_error(c, error);
  if (format == GL_COLOR_INDEX) return raise_error(c, GL_INVALID_OPERATION);
  if (const GLenum error = missing_buffer_error(c, format)) return raise_error(c, error);
  if (const GLenum error = multisampled_object_error(c)) return raise_error(c, error);
  if (!can_read_pixels(c.driver->functions, format)) {
    diagnose(c, "glReadPixels: this driver (OpenGL ES) reads colours alone");
    return raise_error(c, GL_INVALID_OPERATION);
  }
  flush_pending(c);
  if (!pixels || !rectangle.width || !rectangle.height) return;
  read_pixels(c.driver->functions, rectangle, c.pack, format, type, c.pixels,
              static_cast<std::byte*>(pixels));
}

}  // namespace

GLenum legacy_gl::missing_buffer_error(const Context& c, GLenum format) {
  switch (format) {
    case GL_DEPTH_COMPONENT:
      return framebuffer_bits(c, FramebufferChannel::kDepth) ? GL_NO_ERROR : GL_INVALID_OPERATION;
    case GL_STENCIL_INDEX:
      return framebuffer_bits(c, FramebufferChannel::kStencil) ? GL_NO_ERROR : GL_INVALID_OPERATION;
    case kDepthStencil: {
      const GLenum error = missing_buffer_error(c, GL_DEPTH_COMPONENT);
      return error ? error : missing_buffer_error(c, GL_STENCIL_INDEX);
    }
    default: return GL_NO_ERROR;
  }
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lglDrawBuffer(GLenum buf) { dispatch<draw_buffer>(buf); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglReadBuffer(GLenum src) { dispatch<read_buffer>(src); }
LEGACY_GL_API void LEGACY_GL_APIENTRY lglReadPixels(GLint x, GLint y, GLsizei width, GLsizei height,
                                                    GLenum format, GLenum type, void* pixels) {
  execute_now<read_pixels_into>(PixelRectangle{x, y, width, height}, format, type, pixels);
}
