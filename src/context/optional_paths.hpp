#pragma once
// Ways to draw that can be taken away, to find out which of them is at fault, or what it is worth.
#include <span>
#include <string>
#include <string_view>

namespace legacy_gl {

struct OptionalPaths {
  bool cpu_lighting = true;
  bool cpu_transform = true;
  bool list_meshes = true;
  bool arrays_direct = true;
  bool arrays_streamed = true;
  bool light_culling = true;
};

struct OptionalPathInfo {
  const char* name;  ///< in LEGACY_GL_DISABLE
  bool OptionalPaths::*value;
  const char* meaning;
};
std::span<const OptionalPathInfo> optional_path_table();

/// Turns off what `names` names, separated by commas; "all" names every path. Names that there are
/// not are put into `unknown`.
OptionalPaths without_paths(std::string_view names, std::string& unknown);

}  // namespace legacy_gl
