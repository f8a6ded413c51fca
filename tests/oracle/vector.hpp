// Vectors of three and four, and the cofactors of a 3x3 matrix, for any scalar. Its own code (and
// not GLM) because GLM does not take the 113-bit scalar.
#pragma once

#include <array>
#include <cstddef>

#include "oracle/scalar_math.hpp"

namespace oracle {

template <class Scalar>
struct Vector3 {
  Scalar x{}, y{}, z{};
};

template <class Scalar>
struct Vector4 {
  Scalar x{}, y{}, z{}, w{};
};

template <class Scalar>
Vector3<Scalar> operator+(Vector3<Scalar> a, Vector3<Scalar> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class Scalar>
Vector3<Scalar> operator-(Vector3<Scalar> a, Vector3<Scalar> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Scalar>
Vector3<Scalar> operator*(Scalar s, Vector3<Scalar> v) {
  return {s * v.x, s * v.y, s * v.z};
}

template <class Scalar>
Scalar dot(Vector3<Scalar> a, Vector3<Scalar> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Scalar>
Vector3<Scalar> cross(Vector3<Scalar> a, Vector3<Scalar> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Scaled by the largest component: no square overflows or vanishes.
template <class Scalar>
Scalar length(Vector3<Scalar> v) {
  const Scalar largest =
      scalar::max(scalar::abs(v.x), scalar::max(scalar::abs(v.y), scalar::abs(v.z)));
  if (!(largest > Scalar(0)) || !scalar::is_finite(largest)) return largest;
  const Vector3<Scalar> scaled{v.x / largest, v.y / largest, v.z / largest};
  return largest * scalar::sqrt(dot(scaled, scaled));
}

// The zero vector stays zero (and says so to the caller by having length 0).
template <class Scalar>
Vector3<Scalar> unit(Vector3<Scalar> v) {
  const Scalar largest =
      scalar::max(scalar::abs(v.x), scalar::max(scalar::abs(v.y), scalar::abs(v.z)));
  if (!(largest > Scalar(0))) return {};
  const Vector3<Scalar> scaled{v.x / largest, v.y / largest, v.z / largest};
  return (Scalar(1) / scalar::sqrt(dot(scaled, scaled))) * scaled;
}

template <class Scalar>
Vector3<Scalar> xyz(Vector4<Scalar> v) {
  return {v.x, v.y, v.z};
}

// Column-major, as glLoadMatrix takes it.
using Matrix4 = std::array<double, 16>;

constexpr Matrix4 identity_matrix{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

template <class Scalar>
Vector4<Scalar> transform(const Matrix4& m, Vector4<Scalar> v) {
  const auto row = [&](std::size_t r) {
    return Scalar(m[r]) * v.x + Scalar(m[r + 4]) * v.y + Scalar(m[r + 8]) * v.z +
           Scalar(m[r + 12]) * v.w;
  };
  return {row(0), row(1), row(2), row(3)};
}

template <class Scalar>
Vector3<Scalar> upper_column(const Matrix4& m, std::size_t column) {
  return {Scalar(m[4 * column]), Scalar(m[4 * column + 1]), Scalar(m[4 * column + 2])};
}

}  // namespace oracle
