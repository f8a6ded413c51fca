#include "matrix/matrix_stack.hpp"

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace legacy_gl {

namespace {

/// Rotation about a unit axis (GL 2.1 spec 2.11.2), in the operations and the order that float32
/// drivers use.
template <typename T>
glm::mat<4, 4, T> rotation(T sine, T cosine, T x, T y, T z) {
  const T rest = T(1) - cosine;
  const T xs = x * sine, ys = y * sine, zs = z * sine;
  glm::mat<4, 4, T> m(T(1));
  m[0][0] = rest * (x * x) + cosine;
  m[1][0] = rest * (x * y) - zs;
  m[2][0] = rest * (z * x) + ys;
  m[0][1] = rest * (x * y) + zs;
  m[1][1] = rest * (y * y) + cosine;
  m[2][1] = rest * (y * z) - xs;
  m[0][2] = rest * (z * x) - ys;
  m[1][2] = rest * (y * z) + xs;
  m[2][2] = rest * (z * z) + cosine;
  return m;
}

/// About one of the three axes: exact zeros and ones, so that no rounding creeps in where none is
/// due.
template <typename T>
glm::mat<4, 4, T> axis_rotation(T sine, T cosine, int axis, T sign) {
  glm::mat<4, 4, T> m(T(1));
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  m[u][u] = m[v][v] = cosine;
  m[u][v] = sign * sine;
  m[v][u] = -sign * sine;
  return m;
}

int only_axis(float x, float y, float z) {
  if (x != 0 && y == 0 && z == 0) return 0;
  if (x == 0 && y != 0 && z == 0) return 1;
  if (x == 0 && y == 0 && z != 0) return 2;
  return -1;
}

/// Sine and cosine of degrees, exact at the multiples of 90.
void exact_sine_cosine(double degrees, double& sine, double& cosine) {
  const double turn = std::remainder(degrees, 360.0);
  const double quadrant = std::nearbyint(turn / 90.0);
  const double radians = (turn - 90.0 * quadrant) * (std::numbers::pi / 180.0);
  const double s = std::sin(radians), c = std::cos(radians);
  switch (static_cast<int>(quadrant) & 3) {
    case 0: sine = s, cosine = c; break;
    case 1: sine = c, cosine = -s; break;
    case 2: sine = -s, cosine = -c; break;
    default: sine = -c, cosine = s; break;
  }
}

}  // namespace

void set_identity(Matrix& matrix) { matrix = Matrix{}; }

void load(Matrix& matrix, const glm::mat4& values) {
  matrix.single = values;
  matrix.exact = glm::dmat4(values);
}

void multiply(Matrix& matrix, const glm::mat4& right) {
  matrix.single = matrix.single * right;
  matrix.exact = matrix.exact * glm::dmat4(right);
}

void rotate(Matrix& matrix, float degrees, float x, float y, float z) {
  const double radians = static_cast<double>(degrees) * std::numbers::pi / 180.0;
  const float single_sine = std::sin(static_cast<float>(radians));
  const float single_cosine = std::cos(static_cast<float>(radians));
  double sine = 0, cosine = 1;
  exact_sine_cosine(static_cast<double>(degrees), sine, cosine);

  if (const int axis = only_axis(x, y, z); axis >= 0) {
    const float sign = x + y + z < 0 ? -1.0f : 1.0f;
    matrix.single = matrix.single * axis_rotation(single_sine, single_cosine, axis, sign);
    matrix.exact = matrix.exact * axis_rotation(sine, cosine, axis, static_cast<double>(sign));
    return;
  }
  const float length = std::sqrt(x * x + y * y + z * z);
  const glm::dvec3 direction(x, y, z);
  const double exact_length = glm::length(direction);
  if (exact_length > 0) {
    const glm::dvec3 axis = direction / exact_length;
    matrix.exact = matrix.exact * rotation(sine, cosine, axis.x, axis.y, axis.z);
  }
  // An axis this short leaves a float32 driver's matrix as it is.
  if (length > 1.0e-4f)
    matrix.single =
        matrix.single * rotation(single_sine, single_cosine, x / length, y / length, z / length);
}

void translate(Matrix& matrix, float x, float y, float z) {
  matrix.single = glm::translate(matrix.single, glm::vec3(x, y, z));
  matrix.exact = glm::translate(matrix.exact, glm::dvec3(x, y, z));
}

void scale(Matrix& matrix, float x, float y, float z) {
  matrix.single = glm::scale(matrix.single, glm::vec3(x, y, z));
  matrix.exact = glm::scale(matrix.exact, glm::dvec3(x, y, z));
}

namespace {

template <typename T>
glm::mat<4, 4, T> frustum_matrix(T left, T right, T bottom, T top, T near_distance,
                                 T far_distance) {
  glm::mat<4, 4, T> m(T(0));
  m[0][0] = (T(2) * near_distance) / (right - left);
  m[1][1] = (T(2) * near_distance) / (top - bottom);
  m[2][0] = (right + left) / (right - left);
  m[2][1] = (top + bottom) / (top - bottom);
  m[2][2] = -(far_distance + near_distance) / (far_distance - near_distance);
  m[2][3] = T(-1);
  m[3][2] = -(T(2) * far_distance * near_distance) / (far_distance - near_distance);
  return m;
}

template <typename T>
glm::mat<4, 4, T> ortho_matrix(T left, T right, T bottom, T top, T near_distance, T far_distance) {
  glm::mat<4, 4, T> m(T(1));
  m[0][0] = T(2) / (right - left);
  m[1][1] = T(2) / (top - bottom);
  m[2][2] = T(-2) / (far_distance - near_distance);
  m[3][0] = -(right + left) / (right - left);
  m[3][1] = -(top + bottom) / (top - bottom);
  m[3][2] = -(far_distance + near_distance) / (far_distance - near_distance);
  return m;
}

}  // namespace

void frustum(Matrix& matrix, double left, double right, double bottom, double top,
             double near_distance, double far_distance) {
  matrix.single =
      matrix.single * frustum_matrix(static_cast<float>(left), static_cast<float>(right),
                                     static_cast<float>(bottom), static_cast<float>(top),
                                     static_cast<float>(near_distance),
                                     static_cast<float>(far_distance));
  matrix.exact =
      matrix.exact * frustum_matrix(left, right, bottom, top, near_distance, far_distance);
}

void ortho(Matrix& matrix, double left, double right, double bottom, double top,
           double near_distance, double far_distance) {
  matrix.single = matrix.single * ortho_matrix(static_cast<float>(left), static_cast<float>(right),
                                               static_cast<float>(bottom), static_cast<float>(top),
                                               static_cast<float>(near_distance),
                                               static_cast<float>(far_distance));
  matrix.exact = matrix.exact * ortho_matrix(left, right, bottom, top, near_distance, far_distance);
}

void MatrixStack::compute_pending() const {
  Matrix& top = matrices_[depth_ - 1];
  if (copies_below_) top = matrices_[depth_ - 2];
  for (std::size_t i = 0; i < pending_count_; ++i) {
    const MatrixOperation& o = pending_[i];
    switch (o.kind) {
      case MatrixOperation::Kind::kRotate: rotate(top, o.degrees, o.x, o.y, o.z); break;
      case MatrixOperation::Kind::kTranslate: translate(top, o.x, o.y, o.z); break;
      case MatrixOperation::Kind::kScale: scale(top, o.x, o.y, o.z); break;
    }
  }
  copies_below_ = false;
  pending_count_ = 0;
}

}  // namespace legacy_gl
