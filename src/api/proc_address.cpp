#include <legacy_gl/context.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string_view>

#include "state/gl_types.hpp"

namespace {

struct EntryPoint {
  std::string_view name;  // without the gl prefix
  legacy_gl_proc address;
};

const EntryPoint kEntryPoints[] = {
#define LEGACY_GL_ENTRY_POINT(name) {#name, reinterpret_cast<legacy_gl_proc>(lgl##name)},
#include "api/entry_point_table.inc"
#undef LEGACY_GL_ENTRY_POINT
};

}  // namespace

legacy_gl_proc legacy_gl_get_proc_address(const char* name) {
  if (!name || std::strncmp(name, "gl", 2) != 0) return nullptr;
  const std::string_view wanted = name + 2;
  const auto* const at = std::lower_bound(
      std::begin(kEntryPoints), std::end(kEntryPoints), wanted,
      [](const EntryPoint& entry, std::string_view key) { return entry.name < key; });
  return at != std::end(kEntryPoints) && at->name == wanted ? at->address : nullptr;
}
