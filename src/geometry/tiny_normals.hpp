#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

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

/// The same of floats and of doubles anywhere in memory; the stride is in bytes.
bool has_tiny_floats(const std::byte* normals, std::size_t stride, std::uint32_t count);
bool has_tiny_doubles(const std::byte* normals, std::size_t stride, std::uint32_t count);

/// One normal as the driver is to get it under GL_NORMALIZE.
glm::vec3 enlarged_if_tiny(glm::vec3 normal);

}  // namespace legacy_gl
