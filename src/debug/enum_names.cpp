#include "debug/enum_names.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace legacy_gl::debug {
namespace {

struct Name {
  std::string_view group;
  unsigned value;
  std::string_view name;
};

// Sorted by group and value; the group "" has every enum of OpenGL 1.0 to 1.5 once.
constexpr Name kNames[] = {
#include "debug/enum_names.inc"
};

std::string_view find(std::string_view group, unsigned value) {
  const auto* const at = std::lower_bound(
      std::begin(kNames), std::end(kNames), value, [group](const Name& name, unsigned wanted) {
        return name.group != group ? name.group < group : name.value < wanted;
      });
  return at != std::end(kNames) && at->group == group && at->value == value ? at->name
                                                                            : std::string_view();
}

std::string hexadecimal(unsigned value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%04X", value);
  return text;
}

}  // namespace

std::string_view enum_name(std::string_view group, unsigned value) {
  const std::string_view name = find(group, value);
  return name.empty() ? find("", value) : name;
}

std::string enum_text(std::string_view group, unsigned value) {
  const std::string_view name = enum_name(group, value);
  return name.empty() ? hexadecimal(value) : std::string(name);
}

std::string bitfield_text(std::string_view group, unsigned bits) {
  if (const std::string_view all = find(group, bits); !all.empty()) return std::string(all);
  std::string text;
  for (unsigned bit = 1; bit; bit <<= 1) {
    if (!(bits & bit)) continue;
    const std::string_view name = find(group, bit);
    if (!text.empty()) text += '|';
    text += name.empty() ? hexadecimal(bit) : std::string(name);
  }
  return text.empty() ? "0" : text;
}

}  // namespace legacy_gl::debug
