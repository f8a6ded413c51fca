#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "state/client_arrays.hpp"

namespace legacy_gl {

/// Converts `count` elements to floats. Strides are in bytes and in floats.
using ReadFunction = void (*)(const std::byte* from, std::size_t from_stride, float* to,
                              std::size_t to_stride, std::uint32_t count);

/// The function that reads elements of `size` components of `type` as `target_size` floats;
/// components that the element does not have are 0, 0, 0, 1. `normalise`: integers as of GL 2.1
/// spec table 2.9.
ReadFunction find_reader(GLenum type, bool normalise, unsigned size, unsigned target_size);

/// One enabled array in memory that can be read now.
struct ArrayView {
  const std::byte* data = nullptr;  ///< element 0; nullptr: the array is not enabled
  std::size_t stride = 0;           ///< in bytes, never 0
  GLenum type = GL_FLOAT;
  unsigned size = 4;
  std::uint32_t readable = UINT32_MAX;  ///< elements that exist: a buffer object's size is known

  /// Elements first to first + count - 1 by `function` of find_reader; those that do not exist are
  /// 0, 0, 0, 1.
  void read(ReadFunction function, std::uint32_t first, std::uint32_t count, float* to,
            std::size_t to_stride, unsigned target_size) const;
};

using ArrayViews = std::array<ArrayView, kArrayCount>;

/// Colours and normals are normalised, the others not (GL 2.1 spec table 2.4).
constexpr bool is_normalised(unsigned array) {
  return array == kNormalArray || array == kColorArray || array == kSecondaryColorArray;
}

/// The view of an array whose element 0 is at `data`.
ArrayView make_view(const ClientArray& array, const std::byte* data);

/// Whether some component of the normals first to first + count - 1, which are readable, is so
/// small that the driver may take it for zero (geometry/tiny_normals.hpp).
bool has_tiny_components(const ArrayView& normals, std::uint32_t first, std::uint32_t count);

}  // namespace legacy_gl
