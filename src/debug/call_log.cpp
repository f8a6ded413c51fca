#include "debug/call_log.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "debug/enum_names.hpp"
#include "state/gl_types.hpp"

namespace legacy_gl::debug {
namespace {

using Kind = Argument::Kind;

constexpr int kMostValues = 16;

std::string in_words(const char* format, auto value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string signed_text(std::int64_t value) { return std::to_string(value); }
std::string unsigned_text(std::int64_t value) {
  return std::to_string(static_cast<std::uint64_t>(value));
}
std::string floating_text(double value) { return in_words("%.9g", value); }

template <typename T>
std::string list(const Argument& argument, auto text_of) {
  std::string text = "{";
  const int count = std::min(argument.count, kMostValues);
  for (int i = 0; i < count; ++i)
    text += (i ? ", " : "") + std::string(text_of(static_cast<const T*>(argument.pointer)[i]));
  return text + (count < argument.count ? ", …}" : "}");
}

std::string values_text(const Argument& argument) {
  if (!argument.pointer) return "NULL";
  if (argument.count <= 0) return in_words("%p", argument.pointer);
  switch (argument.kind) {
    case Kind::kBytes: return list<GLbyte>(argument, signed_text);
    case Kind::kUnsignedBytes: return list<GLubyte>(argument, unsigned_text);
    case Kind::kShorts: return list<GLshort>(argument, signed_text);
    case Kind::kUnsignedShorts: return list<GLushort>(argument, unsigned_text);
    case Kind::kInts: return list<GLint>(argument, signed_text);
    case Kind::kUnsignedInts: return list<GLuint>(argument, unsigned_text);
    case Kind::kFloats: return list<GLfloat>(argument, floating_text);
    case Kind::kDoubles: return list<GLdouble>(argument, floating_text);
    case Kind::kBooleans:
      return list<GLboolean>(argument,
                             [](GLboolean flag) { return flag ? "GL_TRUE" : "GL_FALSE"; });
    case Kind::kEnums:
      return list<GLenum>(argument, [](GLenum value) { return enum_text("", value); });
    default: return in_words("%p", argument.pointer);
  }
}

std::string enum_or_number(const Argument& argument) {
  if (argument.integer < 0) return signed_text(argument.integer);
  const std::string_view name = enum_name(argument.group, static_cast<unsigned>(argument.integer));
  return name.empty() ? signed_text(argument.integer) : std::string(name);
}

/// GL_LINEAR is 9729, and a distance may be so too: both are told.
std::string parameter_text(double value) {
  constexpr double kSmallestEnum = 0x0800;  // GL_EXP; colours, angles and exponents lie below
  std::string text = floating_text(value);
  if (value < kSmallestEnum || value > 0xFFFF || value != std::floor(value)) return text;
  const std::string_view name = enum_name("", static_cast<unsigned>(value));
  return name.empty() ? text : text + " (" + std::string(name) + ")";
}

std::string argument_text(const Argument& argument) {
  switch (argument.kind) {
    case Kind::kSigned: return signed_text(argument.integer);
    case Kind::kUnsigned: return unsigned_text(argument.integer);
    case Kind::kFloating: return floating_text(argument.floating);
    case Kind::kBoolean: return argument.integer ? "GL_TRUE" : "GL_FALSE";
    case Kind::kEnum: return enum_text(argument.group, static_cast<unsigned>(argument.integer));
    case Kind::kEnumOrNumber: return enum_or_number(argument);
    case Kind::kParameter: return parameter_text(argument.floating);
    case Kind::kBitfield:
      return bitfield_text(argument.group, static_cast<unsigned>(argument.integer));
    case Kind::kText:
      return argument.pointer ? '"' + std::string(static_cast<const char*>(argument.pointer)) + '"'
                              : "NULL";
    default: return values_text(argument);
  }
}

}  // namespace

int values_of_name(unsigned pname) {
  switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION:
    case GL_AMBIENT_AND_DIFFUSE:
    case GL_POSITION:
    case GL_LIGHT_MODEL_AMBIENT:
    case GL_FOG_COLOR:
    case GL_TEXTURE_ENV_COLOR:
    case GL_TEXTURE_BORDER_COLOR:
    case GL_OBJECT_PLANE:
    case GL_EYE_PLANE: return 4;
    case GL_SPOT_DIRECTION:
    case GL_COLOR_INDEXES:
    case GL_POINT_DISTANCE_ATTENUATION: return 3;
    default: return enum_name("", pname).empty() ? 0 : 1;
  }
}

std::string call_text(const char* name, std::initializer_list<Argument> arguments) {
  std::string text = std::string(name) + "(";
  for (const Argument& argument : arguments)
    text += (&argument == arguments.begin() ? "" : ", ") + argument_text(argument);
  return text + ")";
}

void log_call(const char* name, std::initializer_list<Argument> arguments) {
  set_current_call(name);
  if (wants(kCalls)) log_text(call_text(name, arguments));
}

void log_result(const Argument& result) {
  if (wants(kCalls)) log_text("  = " + argument_text(result));
}

}  // namespace legacy_gl::debug
