#pragma once
// Calls in words, for the functions of api/logged_calls.cpp and api/vertex_variants_*.cpp.
#include <cstdint>
#include <initializer_list>
#include <string>
#include <type_traits>

#include "debug/log.hpp"

namespace legacy_gl::debug {

/// One value of a call. Of a pointer the first `count` values are told; with count 0, or NULL, the
/// address.
struct Argument {
  enum class Kind : std::uint8_t {
    kSigned,
    kUnsigned,
    kFloating,
    kBoolean,
    kEnum,
    kEnumOrNumber,
    kParameter,
    kBitfield,
    kPointer,
    kText,
    kBytes,
    kUnsignedBytes,
    kShorts,
    kUnsignedShorts,
    kInts,
    kUnsignedInts,
    kFloats,
    kDoubles,
    kBooleans,
    kEnums
  };
  Kind kind;
  const char* group = "";  ///< of enums, in the registry
  std::int64_t integer = 0;
  double floating = 0;
  const void* pointer = nullptr;
  int count = 0;
};

template <typename T>
Argument number(T value) {
  if constexpr (std::is_floating_point_v<T>)
    return {.kind = Argument::Kind::kFloating, .floating = static_cast<double>(value)};
  else if constexpr (std::is_signed_v<T>)
    return {.kind = Argument::Kind::kSigned, .integer = static_cast<std::int64_t>(value)};
  else return {.kind = Argument::Kind::kUnsigned, .integer = static_cast<std::int64_t>(value)};
}
inline Argument boolean(unsigned char value) {
  return {.kind = Argument::Kind::kBoolean, .integer = value};
}
inline Argument enumerant(const char* group, std::int64_t value) {
  return {.kind = Argument::Kind::kEnum, .group = group, .integer = value};
}
/// Of glTexImage2D: GL_RGB, or 3.
inline Argument enumerant_or_number(const char* group, std::int64_t value) {
  return {.kind = Argument::Kind::kEnumOrNumber, .group = group, .integer = value};
}
/// Of glTexEnvi and its like: an enum or a number, the name before it says which.
template <typename T>
Argument parameter(T value) {
  return {.kind = Argument::Kind::kParameter, .floating = static_cast<double>(value)};
}
inline Argument bitfield(const char* group, unsigned bits) {
  return {.kind = Argument::Kind::kBitfield, .group = group, .integer = bits};
}
inline Argument array(Argument::Kind kind, const void* pointer, int count) {
  return {.kind = kind, .pointer = pointer, .count = count};
}
inline Argument text(const unsigned char* value) {
  return {.kind = Argument::Kind::kText, .pointer = value};
}
inline Argument address(const void* pointer) {
  return {.kind = Argument::Kind::kPointer, .pointer = pointer};
}

/// How many values glLightfv and its like read for a name; 0 for a name that none of them knows.
int values_of_name(unsigned pname);

std::string call_text(const char* name, std::initializer_list<Argument> arguments);

/// Notes that the call is being made, and tells it where calls are wanted.
[[gnu::cold, gnu::noinline]] void log_call(const char* name,
                                           std::initializer_list<Argument> arguments);
[[gnu::cold, gnu::noinline]] void log_result(const Argument& result);

}  // namespace legacy_gl::debug
