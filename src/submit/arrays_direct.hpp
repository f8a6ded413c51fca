#pragma once
#include <optional>

#include "context/context.hpp"
#include "driver/buffer_arrays.hpp"
#include "submit/arrays.hpp"

namespace legacy_gl {

/// Enabled arrays that all lie in buffer objects of the application.
struct DirectArrays {
  VertexLayout layout;
  BufferAttributes attributes;
};

/// Nothing when one of the arrays that matter is not in a buffer, or not in a form that the driver
/// reads as OpenGL 1.5 does.
std::optional<DirectArrays> find_direct_arrays(Context& context, const ArrayDraw& draw);

/// Nothing waits. Draws them from where they lie, without a copy.
void draw_arrays_direct(Context& context, const ArrayDraw& draw, DirectArrays arrays);

}  // namespace legacy_gl
