#pragma once
#include <string>
#include <string_view>

namespace legacy_gl {

/// Hands over each name of "a,b,,c" but the empty ones.
template <typename Visit>
void for_each_name(std::string_view names, Visit visit) {
  while (!names.empty()) {
    const std::size_t comma = names.find(',');
    const std::string_view name = names.substr(0, comma);
    names.remove_prefix(comma == std::string_view::npos ? names.size() : comma + 1);
    if (!name.empty()) visit(name);
  }
}

/// The names that nobody knows, for a message.
inline void append_name(std::string& list, std::string_view name) {
  if (!list.empty()) list += ", ";
  list += name;
}

}  // namespace legacy_gl
