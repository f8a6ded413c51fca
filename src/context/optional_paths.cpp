#include "context/optional_paths.hpp"

#include "state/name_list.hpp"

namespace legacy_gl {

namespace {

constexpr OptionalPathInfo kTable[] = {
    {"cpu_lighting", &OptionalPaths::cpu_lighting, "small lit draws are lit on the CPU"},
    {"cpu_transform", &OptionalPaths::cpu_transform, "small draws are transformed on the CPU"},
    {"list_meshes", &OptionalPaths::list_meshes, "display lists are drawn from buffers"},
    {"arrays_direct", &OptionalPaths::arrays_direct, "arrays are drawn from buffer objects"},
    {"arrays_streamed", &OptionalPaths::arrays_streamed,
     "large client arrays are copied once, past the recorder"},
    {"light_culling", &OptionalPaths::light_culling,
     "lights that do not reach a draw are left out of it"},
};

bool turn_off(OptionalPaths& paths, std::string_view name) {
  bool known = name == "all";
  for (const OptionalPathInfo& info : kTable)
    if (name == "all" || name == info.name) {
      paths.*info.value = false;
      known = true;
    }
  return known;
}

}  // namespace

std::span<const OptionalPathInfo> optional_path_table() { return kTable; }

OptionalPaths without_paths(std::string_view names, std::string& unknown) {
  OptionalPaths paths;
  for_each_name(names, [&](std::string_view name) {
    if (!turn_off(paths, name)) append_name(unknown, name);
  });
  return paths;
}

}  // namespace legacy_gl
