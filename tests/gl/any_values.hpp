// Arguments for families of entry points that differ in the type of a pointer only.
#pragma once

#include <array>

#include "support/gl_functions.hpp"

namespace legacy_gl::test {

// Sixteen times one value, as an array of whatever type the call wants.
class AnyValues {
 public:
  explicit AnyValues(double value) {
    floats_.fill(static_cast<GLfloat>(value));
    doubles_.fill(value);
    ints_.fill(static_cast<GLint>(value));
  }
  operator const GLfloat*() const { return floats_.data(); }
  operator const GLdouble*() const { return doubles_.data(); }
  operator const GLint*() const { return ints_.data(); }

 private:
  std::array<GLfloat, 16> floats_;
  std::array<GLdouble, 16> doubles_;
  std::array<GLint, 16> ints_;
};

// Room for what a call returns.
class AnyResults {
 public:
  operator GLfloat*() { return floats_.data(); }
  operator GLdouble*() { return doubles_.data(); }
  operator GLint*() { return ints_.data(); }
  operator GLuint*() { return unsigned_ints_.data(); }
  operator GLboolean*() { return booleans_.data(); }
  operator void**() { return pointers_.data(); }

 private:
  std::array<GLfloat, 16> floats_{};
  std::array<GLdouble, 16> doubles_{};
  std::array<GLint, 16> ints_{};
  std::array<GLuint, 16> unsigned_ints_{};
  std::array<GLboolean, 16> booleans_{};
  std::array<void*, 16> pointers_{};
};

inline AnyValues any(double value) { return AnyValues(value); }
inline AnyResults out() { return {}; }

inline constexpr std::array<GLubyte, 256> kBytes{};
inline const void* const memory = kBytes.data();
inline std::array<GLubyte, 64 * 64 * 16> writable_bytes;
inline void* const writable = writable_bytes.data();

}  // namespace legacy_gl::test
