#include "geometry/tiny_normals.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace legacy_gl {

namespace {

/// Bits of 2^-100. What is denormal beside a component as large as this is nothing to see.
constexpr std::uint32_t kTiny = (127u - 100u) << 23;
constexpr std::uint32_t kMagnitude = 0x7fffffff;

/// Four words at once; a compiler's extension that GCC and Clang share.
using Word4 = std::uint32_t __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

std::uint32_t magnitude_bits(float value) {
  return std::bit_cast<std::uint32_t>(value) & kMagnitude;
}

/// By integers: the processor, too, may have been told to take denormal numbers for zero.
double exact(float value) {
  const std::uint32_t bits = magnitude_bits(value);
  const int exponent = static_cast<int>(bits >> 23);
  const std::uint32_t mantissa = (bits & 0x7fffffu) | (exponent ? 0x800000u : 0u);
  const double magnitude = std::ldexp(static_cast<double>(mantissa), std::max(exponent, 1) - 150);
  return std::signbit(value) ? -magnitude : magnitude;
}

void enlarge(float* normal) {
  const std::uint32_t largest =
      std::max({magnitude_bits(normal[0]), magnitude_bits(normal[1]), magnitude_bits(normal[2])});
  if (largest == 0 || largest >= kTiny) return;
  const int up = -std::ilogb(exact(std::bit_cast<float>(largest)));
  for (int c = 0; c < 3; ++c) normal[c] = static_cast<float>(std::ldexp(exact(normal[c]), up));
}

bool is_tiny(float value) { return magnitude_bits(value) != 0 && magnitude_bits(value) < kTiny; }

/// The lanes that are tiny and not zero. Zero wraps to the largest integer; what is tiny, to the
/// lowest ones.
Int4 tiny_lanes(const std::byte* from) {
  constexpr std::uint32_t kShift = 0x7fffffff;
  constexpr auto kLimit = static_cast<std::int32_t>(kTiny + kShift);
  Word4 bits;
  std::memcpy(&bits, from, sizeof bits);
  bits = (bits & kMagnitude) + kShift;
  return reinterpret_cast<const Int4&>(bits) < kLimit;
}

}  // namespace

// Memory of the application need not be aligned.
bool has_tiny_floats(const std::byte* from, std::size_t stride, std::uint32_t count) {
  if (count == 0) return false;
  Int4 found{};
  // Four normals a turn. A float behind each is looked at too, so the last is apart.
  for (; count > 4; count -= 4, from += 4 * stride)
    found |= tiny_lanes(from) | tiny_lanes(from + stride) | tiny_lanes(from + 2 * stride) |
             tiny_lanes(from + 3 * stride);
  for (; count > 1; --count, from += stride) found |= tiny_lanes(from);
  float last[3];
  std::memcpy(last, from, sizeof last);
  return found[0] || found[1] || found[2] || found[3] || std::any_of(last, last + 3, is_tiny);
}

bool has_tiny_doubles(const std::byte* normals, std::size_t stride, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i, normals += stride) {
    double normal[3];
    std::memcpy(normal, normals, sizeof normal);
    for (const double component : normal)
      if (is_tiny(static_cast<float>(component))) return true;
  }
  return false;
}

bool has_tiny_components(const float* normals, std::size_t stride, std::uint32_t count) {
  return has_tiny_floats(reinterpret_cast<const std::byte*>(normals), stride * sizeof(float),
                         count);
}

void enlarge_tiny_normals(float* normals, std::size_t stride, std::uint32_t count) {
  if (!has_tiny_components(normals, stride, count)) return;
  for (std::uint32_t i = 0; i < count; ++i) enlarge(normals + i * stride);
}

glm::vec3 enlarged_if_tiny(glm::vec3 normal) {
  enlarge(&normal[0]);
  return normal;
}

}  // namespace legacy_gl
