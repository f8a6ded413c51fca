#pragma once
// Four floats at once; a compiler's extension that GCC and Clang share.
#include <bit>
#include <cstring>
#include <glm/mat4x4.hpp>

namespace legacy_gl {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = int __attribute__((vector_size(16)));

inline Float4 load(const float* p) {
  Float4 v;
  std::memcpy(&v, p, sizeof v);
  return v;
}
inline void store(float* p, const Float4& v) { std::memcpy(p, &v, sizeof v); }
inline Float4 splat(float x) { return Float4{x, x, x, x}; }

inline Float4 least(const Float4& a, const Float4& b) { return a < b ? a : b; }
inline Float4 greatest(const Float4& a, const Float4& b) { return a > b ? a : b; }

struct Columns {
  Float4 c[4];
};

inline Columns columns(const glm::mat4& m) {
  return {{load(&m[0][0]), load(&m[1][0]), load(&m[2][0]), load(&m[3][0])}};
}

/// The product as the shaders form it, operation by operation, so that positions agree to the bit.
inline Float4 product(const Columns& m, float x, float y, float z, float w) {
  return m.c[0] * x + m.c[1] * y + m.c[2] * z + m.c[3] * w;
}

/// Where vertices are to the view volume.
struct ClipFlags {
  Int4 all_above{-1, -1, -1, -1}, all_below{-1, -1, -1, -1}, any{};

  void add(const Float4& clip) {
    const Float4 w{clip[3], clip[3], clip[3], clip[3]};
    const Int4 above = clip > w, below = clip < -w;
    all_above &= above;
    all_below &= below;
    any |= above | below;
  }
  bool crosses() const { return any[0] || any[1] || any[2]; }
  bool outside() const {
    const Int4 all = all_above | all_below;
    return all[0] || all[1] || all[2];
  }
};

}  // namespace legacy_gl
