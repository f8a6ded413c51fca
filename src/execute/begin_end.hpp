#pragma once
#include "context/context.hpp"

namespace legacy_gl::execute {

/// GL 2.1 spec 2.6.1.
void begin(Context& context, GLenum mode);
void end(Context& context);

}  // namespace legacy_gl::execute
