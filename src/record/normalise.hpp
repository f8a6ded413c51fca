#pragma once
#include <limits>
#include <type_traits>

namespace legacy_gl {

/// Integers as colours and normals (GL 2.1 spec table 2.9): unsigned c / (2^b - 1), signed (2c + 1)
/// / (2^b - 1).
template <typename T>
constexpr float normalised(T value) {
  static_assert(std::is_integral_v<T>);
  constexpr double kRange =
      static_cast<double>(std::numeric_limits<std::make_unsigned_t<T>>::max());
  if constexpr (std::is_unsigned_v<T>)
    return static_cast<float>(static_cast<double>(value) / kRange);
  else return static_cast<float>((2 * static_cast<double>(value) + 1) / kRange);
}

}  // namespace legacy_gl
