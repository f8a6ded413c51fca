#include "api/sized_structs.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace legacy_gl {
namespace {

// Bytes between fields are not set by an initialiser: with some, a newer program's fields could not
// be told from them.
static_assert(std::has_unique_object_representations_v<legacy_gl_options>,
              "order the fields of legacy_gl_options so that there is no padding");

std::string too_small(const char* name, std::size_t size, const char* initialiser) {
  return std::string(name) + ".size is " + std::to_string(size) + ": initialise it with " +
         initialiser;
}

}  // namespace

std::string read_options(const legacy_gl_options* given, legacy_gl_options& options) {
  options = {};
  if (!given) return {};
  const std::size_t size = given->size;
  if (size < sizeof size) return too_small("legacy_gl_options", size, "LEGACY_GL_OPTIONS_INIT");
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  if (size > sizeof options &&
      std::any_of(bytes + sizeof options, bytes + size, [](unsigned char byte) { return byte; }))
    return "an option is set that this version of the library does not know";
  std::memcpy(&options, bytes, std::min(size, sizeof options));
  options.size = sizeof options;
  return {};
}

std::string write_statistics(const legacy_gl_statistics& statistics, legacy_gl_statistics* given) {
  if (!given) return "the statistics are NULL";
  const std::size_t size = given->size;
  if (size < sizeof size)
    return too_small("legacy_gl_statistics", size, "LEGACY_GL_STATISTICS_INIT");
  std::memcpy(given, &statistics, std::min(size, sizeof statistics));
  given->size = size;
  return {};
}

}  // namespace legacy_gl
