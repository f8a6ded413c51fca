// Modelviews as products of 3x3 matrices, rounded once to what GL is given.
#pragma once

#include "oracle/vector.hpp"

namespace oracle {

using Mat3 = std::array<std::array<double, 3>, 3>;  // columns

// Through memory: GCC 12 at -O2 vectorises the two conversions of a pair of entries into none.
inline double rounded_to_float(double value) {
  const volatile float rounded = float(value);
  return double(rounded);
}

// The matrix that is given to glLoadMatrixf: rounded to float, then exact.
inline Matrix4 loaded(const Mat3& upper, const std::array<float, 3>& translation) {
  Matrix4 m = identity_matrix;
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      m[4 * column + row] = rounded_to_float(upper[column][row]);
    }
    m[12 + column] = double(translation[column]);
  }
  return m;
}

inline Mat3 times(const Mat3& a, const Mat3& b) {
  Mat3 product{};
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t k = 0; k < 3; ++k) product[column][row] += a[k][row] * b[column][k];
    }
  }
  return product;
}

inline Mat3 scale(double x, double y, double z) { return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}; }

}  // namespace oracle
