#pragma once
// Names of enums, by the groups of the Khronos registry, since one number has many names.
#include <string>
#include <string_view>

namespace legacy_gl::debug {

/// The name of `value` in `group`, or of any group where it has none there; empty where it has
/// none.
std::string_view enum_name(std::string_view group, unsigned value);

/// The name, or the number in hexadecimal.
std::string enum_text(std::string_view group, unsigned value);

/// "GL_COLOR_BUFFER_BIT|GL_DEPTH_BUFFER_BIT".
std::string bitfield_text(std::string_view group, unsigned bits);

}  // namespace legacy_gl::debug
