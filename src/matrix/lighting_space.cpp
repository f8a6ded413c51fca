#include "matrix/lighting_space.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace legacy_gl {

namespace {

/// Rotations that a program computed in float32 keep angles within 1e-6; what they lack is one
/// symmetric matrix of that size, which enters lighting to first order. Farther off, its square
/// would show.
constexpr double kAngleTolerance = 1e-5;
constexpr double kInvisible = 1e-9;

double largest_entry(const glm::dmat3& m) {
  double largest = 0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(m[column][row]));
  return largest;
}

/// 2^-floor(log2(x)), of a positive number.
double inverse_power_of_two(double x) {
  constexpr unsigned kMantissaBits = 52;
  constexpr std::uint64_t kLargest = 2046;
  const std::uint64_t exponent = std::bit_cast<std::uint64_t>(x) >> kMantissaBits;
  return std::bit_cast<double>(std::max<std::uint64_t>(kLargest - exponent, 1) << kMantissaBits);
}

}  // namespace

LinearPart analyse(const glm::dmat3& matrix) {
  LinearPart part;
  part.matrix = matrix;
  const double largest = largest_entry(matrix);
  if (!(largest > 0) || !std::isfinite(largest)) {
    part.keeps_angles = false;
    part.cofactor = part.inverse = part.inverse_transpose = glm::dmat3(0.0);
    part.rescale_factor = 0;
    return part;
  }
  // An exact power of two brings the entries near 1, so that no product of three leaves the range.
  const double power = inverse_power_of_two(largest);
  const glm::dmat3 m = matrix * power;
  const glm::dvec3 x = m[0], y = m[1], z = m[2];
  const double squared = glm::dot(x, x);
  const double tolerance = kAngleTolerance * squared;
  part.keeps_angles =
      std::abs(glm::dot(y, y) - squared) <= tolerance &&
      std::abs(glm::dot(z, z) - squared) <= tolerance && std::abs(glm::dot(x, y)) <= tolerance &&
      std::abs(glm::dot(y, z)) <= tolerance && std::abs(glm::dot(z, x)) <= tolerance;
  part.scale = std::sqrt((squared + glm::dot(y, y) + glm::dot(z, z)) / 3) / power;
  part.cofactor = glm::dmat3(glm::cross(y, z), glm::cross(z, x), glm::cross(x, y));
  const double determinant = glm::dot(x, part.cofactor[0]);
  part.determinant_sign = determinant < 0 ? -1 : 1;
  if (determinant != 0) {
    part.inverse_transpose = part.cofactor * (power / determinant);
    part.inverse = glm::transpose(part.inverse_transpose);
    // The third row of the inverse is the third column of its transpose.
    part.rescale_factor = 1 / glm::length(part.inverse_transpose[2]);
  } else {
    part.inverse = part.inverse_transpose = glm::dmat3(0.0);
    part.rescale_factor = 0;
    part.keeps_angles = false;
  }
  if (part.keeps_angles) {
    part.angle_error =
        (part.inverse * part.scale) * (part.inverse_transpose * part.scale) - glm::dmat3(1.0);
    part.exact = largest_entry(part.angle_error) < kInvisible;
  }
  if (const double cofactor_size = largest_entry(part.cofactor); cofactor_size > 0)
    part.cofactor *= inverse_power_of_two(cofactor_size) / 8;
  return part;
}

bool is_affine(const glm::dmat4& m) {
  return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1;
}

}  // namespace legacy_gl
