#include "record/array_reader.hpp"

#include <algorithm>
#include <cstring>
#include "geometry/tiny_normals.hpp"

#include "record/normalise.hpp"

namespace legacy_gl {

namespace {

template <typename T, bool kNormalise>
float component(const std::byte* from) {
  T value;  // client memory need not be aligned
  std::memcpy(&value, from, sizeof value);
  if constexpr (kNormalise && std::is_integral_v<T>) return normalised(value);
  else return static_cast<float>(value);
}

template <typename T, bool kNormalise, unsigned kSize, unsigned kTargetSize>
void read_elements(const std::byte* from, std::size_t from_stride, float* to, std::size_t to_stride,
                   std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i, from += from_stride, to += to_stride)
    for (unsigned c = 0; c < kTargetSize; ++c)
      to[c] = c < kSize ? component<T, kNormalise>(from + c * sizeof(T)) : c == 3 ? 1.0f : 0.0f;
}

template <typename T, bool kNormalise, unsigned kSize>
ReadFunction with_target(unsigned target_size) {
  switch (target_size) {
    case 1: return &read_elements<T, kNormalise, kSize, 1>;
    case 2: return &read_elements<T, kNormalise, kSize, 2>;
    case 3: return &read_elements<T, kNormalise, kSize, 3>;
    default: return &read_elements<T, kNormalise, kSize, 4>;
  }
}

template <typename T, bool kNormalise>
ReadFunction with_size(unsigned size, unsigned target_size) {
  switch (size) {
    case 1: return with_target<T, kNormalise, 1>(target_size);
    case 2: return with_target<T, kNormalise, 2>(target_size);
    case 3: return with_target<T, kNormalise, 3>(target_size);
    default: return with_target<T, kNormalise, 4>(target_size);
  }
}

template <typename T>
ReadFunction with_normalise(bool normalise, unsigned size, unsigned target_size) {
  return normalise ? with_size<T, true>(size, target_size) : with_size<T, false>(size, target_size);
}

}  // namespace

ReadFunction find_reader(GLenum type, bool normalise, unsigned size, unsigned target_size) {
  switch (type) {
    case GL_BYTE: return with_normalise<GLbyte>(normalise, size, target_size);
    case GL_UNSIGNED_BYTE: return with_normalise<GLubyte>(normalise, size, target_size);
    case GL_SHORT: return with_normalise<GLshort>(normalise, size, target_size);
    case GL_UNSIGNED_SHORT: return with_normalise<GLushort>(normalise, size, target_size);
    case GL_INT: return with_normalise<GLint>(normalise, size, target_size);
    case GL_UNSIGNED_INT: return with_normalise<GLuint>(normalise, size, target_size);
    case GL_DOUBLE: return with_size<GLdouble, false>(size, target_size);
    default: return with_size<GLfloat, false>(size, target_size);
  }
}

void ArrayView::read(ReadFunction function, std::uint32_t first, std::uint32_t count, float* to,
                     std::size_t to_stride, unsigned target_size) const {
  const std::uint32_t present = first < readable ? std::min(count, readable - first) : 0;
  if (present) function(data + std::size_t{first} * stride, stride, to, to_stride, present);
  for (std::uint32_t i = present; i < count; ++i)
    for (unsigned c = 0; c < target_size; ++c) to[i * to_stride + c] = c == 3 ? 1.0f : 0.0f;
}

ArrayView make_view(const ClientArray& array, const std::byte* data) {
  ArrayView view;
  view.data = data;
  view.type = array.type;
  view.size = static_cast<unsigned>(array.size);
  view.stride = array.stride ? static_cast<std::size_t>(array.stride)
                             : std::size_t{view.size} * type_size(array.type);
  return view;
}

bool has_tiny_components(const ArrayView& normals, std::uint32_t first, std::uint32_t count) {
  const std::byte* const from = normals.data + std::size_t{first} * normals.stride;
  if (normals.type == GL_FLOAT) return has_tiny_floats(from, normals.stride, count);
  return normals.type == GL_DOUBLE && has_tiny_doubles(from, normals.stride, count);
}

}  // namespace legacy_gl
