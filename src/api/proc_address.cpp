#include <legacy_gl/context.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "state/gl_types.hpp"

namespace {

struct EntryPoint {
  std::string_view name;
  legacy_gl_proc address;
};

const EntryPoint kEntryPoints[] = {
#define LEGACY_GL_NAME(result, name, parameters, arguments, ours) \
  {#name, reinterpret_cast<legacy_gl_proc>(ours)},
#include "api/gl_names.inc"
#undef LEGACY_GL_NAME
};

}  // namespace

legacy_gl_proc legacy_gl_get_proc_address(const char* name) {
  if (!name) return nullptr;
  const std::string_view wanted = name;
  const auto* const at = std::lower_bound(
      std::begin(kEntryPoints), std::end(kEntryPoints), wanted,
      [](const EntryPoint& entry, std::string_view key) { return entry.name < key; });
  return at != std::end(kEntryPoints) && at->name == wanted ? at->address : nullptr;
}
