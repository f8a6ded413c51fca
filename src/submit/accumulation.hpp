#pragma once
#include "context/context.hpp"

namespace legacy_gl {

void clear_accumulation(const Context& context);
/// glAccum. Nothing waits.
void accumulate(Context& context, GLenum operation, float value);

}  // namespace legacy_gl
