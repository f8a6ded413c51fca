#pragma once
#include "context/context.hpp"

namespace legacy_gl {

/// What the framebuffer lacks can be neither read nor drawn (GL 2.1 spec 3.6.4, 4.3.2). Colours are
/// there always; colour indices have no buffer, but maps turn them to colours when they are drawn.
GLenum missing_buffer_error(const Context& context, GLenum format);

}  // namespace legacy_gl
