#pragma once
#include <array>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "context/context.hpp"

namespace legacy_gl {

/// How a state value turns into the type that is asked for (GL 2.1 spec 6.1.2).
enum class ValueKind {
  kBoolean,
  kInteger,     ///< also enums and bit masks
  kFloat,       ///< rounded to the nearest integer
  kNormalised,  ///< colours, normals, depths: [-1, 1] becomes the whole range of integers
};

/// One state's values. A double holds every float and every 32-bit integer exactly.
struct QueryValues {
  ValueKind kind = ValueKind::kInteger;
  unsigned count = 0;
  std::array<double, 16> values{};

  void put(double value) { values[count++] = value; }
  void put(glm::vec3 v) { put_all(v); }
  void put(glm::vec4 v) { put_all(v); }
  void put(const glm::mat4& m) {
    for (int column = 0; column < 4; ++column) put(m[column]);
  }
  template <typename T, std::size_t N>
  void put(const std::array<T, N>& v) {
    for (const T& value : v) put(static_cast<double>(value));
  }

 private:
  template <typename Vector>
  void put_all(const Vector& v) {
    for (int i = 0; i < Vector::length(); ++i) put(static_cast<double>(v[i]));
  }
};

/// A row of the tables below: what `glGet*v(name)` answers.
struct Query {
  GLenum name;
  ValueKind kind;
  void (*read)(Context& context, QueryValues& values);
};

using QueryGroups = std::span<const std::span<const Query>>;

/// State that this context keeps.
QueryGroups state_queries();
/// The forms of the client arrays, and buffer bindings.
QueryGroups array_queries();
/// What the driver limits, and what its framebuffer has.
QueryGroups driver_queries();
/// State of GL 1.5 that no entry point here changes yet: its initial value.
QueryGroups initial_value_queries();

/// False for a name that GL 1.5 does not have.
bool query(Context& context, GLenum name, QueryValues& values);

GLboolean as_boolean(double value);
GLint as_integer(ValueKind kind, double value);

}  // namespace legacy_gl
