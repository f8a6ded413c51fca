#pragma once
#include <cstdint>
#include <glm/vec3.hpp>

#include "record/array_reader.hpp"

struct legacy_gl_context;

namespace legacy_gl {

/// GL_NORMALIZE takes a normal's direction, however short it is (GL 2.1 spec 2.11.3). A driver may
/// take denormal numbers for zero (GLSL 3.30 spec 4.1.4), and the direction is lost: normals that
/// have some are made longer before it sees them, by a power of two.
///
/// Strides are in floats. Normals are looked through four floats at a time; behind the last nothing
/// is read.
void enlarge_tiny_normals(float* normals, std::size_t stride, std::uint32_t count);

/// Whether some component is so small that its normal may need it.
bool has_tiny_components(const float* normals, std::size_t stride, std::uint32_t count);

/// The same of a client array's elements first to first + count - 1, which are readable.
bool has_tiny_components(const ArrayView& normals, std::uint32_t first, std::uint32_t count);

/// The current normal as the driver is to get it.
glm::vec3 current_normal_to_draw(const legacy_gl_context& context);

}  // namespace legacy_gl
