// The few functions the oracle needs, for each scalar it runs in: double, long double and (where
// the compiler has it) a 113-bit type. Declared by hand because <quadmath.h> is GCC's alone, while
// the library behind it links with clang too.
#pragma once

#include <cmath>

#ifdef ORACLE_HAS_FLOAT128
__extension__ typedef __float128 OracleFloat128;
extern "C" {
OracleFloat128 sqrtq(OracleFloat128) noexcept;
OracleFloat128 powq(OracleFloat128, OracleFloat128) noexcept;
OracleFloat128 sinq(OracleFloat128) noexcept;
OracleFloat128 cosq(OracleFloat128) noexcept;
}
#endif

namespace oracle::scalar {

inline double sqrt(double x) { return std::sqrt(x); }
inline double pow(double x, double y) { return std::pow(x, y); }
inline double sin(double x) { return std::sin(x); }
inline double cos(double x) { return std::cos(x); }

inline long double sqrt(long double x) { return std::sqrt(x); }
inline long double pow(long double x, long double y) { return std::pow(x, y); }
inline long double sin(long double x) { return std::sin(x); }
inline long double cos(long double x) { return std::cos(x); }

#ifdef ORACLE_HAS_FLOAT128
inline OracleFloat128 sqrt(OracleFloat128 x) { return sqrtq(x); }
inline OracleFloat128 pow(OracleFloat128 x, OracleFloat128 y) { return powq(x, y); }
inline OracleFloat128 sin(OracleFloat128 x) { return sinq(x); }
inline OracleFloat128 cos(OracleFloat128 x) { return cosq(x); }
#endif

template <class Scalar>
Scalar abs(Scalar x) {
  return x < Scalar(0) ? -x : x;
}

template <class Scalar>
Scalar max(Scalar a, Scalar b) {
  return a < b ? b : a;
}

// False for NaN and infinities, in any scalar (x - x is 0 only for finite x).
template <class Scalar>
bool is_finite(Scalar x) {
  return x - x == Scalar(0);
}

// Split at 45 degrees so that the cosine of 90 degrees is exactly 0.
template <class Scalar>
Scalar cos_degrees(Scalar degrees) {
  // pi in two parts, so that the 113-bit scalar gets all of them.
  const Scalar radians_per_degree =
      Scalar(3.141592653589793115997963468544185161590576171875L) / Scalar(180) +
      Scalar(1.2246467991473531772260659322749979970830539e-16L) / Scalar(180);
  return degrees > Scalar(45) ? sin((Scalar(90) - degrees) * radians_per_degree)
                              : cos(degrees * radians_per_degree);
}

}  // namespace oracle::scalar
