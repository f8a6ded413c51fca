#include "api/extensions.hpp"

#include <string_view>
#include <unordered_set>

#include "driver/driver.hpp"

namespace legacy_gl {

namespace {

struct Extension {
  std::string_view name;
  bool is_the_drivers;  ///< named only on a driver that names it
};

constexpr Extension kExtensions[] = {
#define LEGACY_GL_EXTENSION(name, is_the_drivers) {#name, is_the_drivers},
#include "api/extensions.inc"
#undef LEGACY_GL_EXTENSION
};

std::unordered_set<std::string> names_of(const Driver& driver) {
  std::unordered_set<std::string> names;
  GLint count = 0;
  driver.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
    if (const GLubyte* const name = driver.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)))
      names.emplace(reinterpret_cast<const char*>(name));
  return names;
}

}  // namespace

bool driver_has_extension(const Driver& driver, const std::string& name) {
  return names_of(driver).contains(name);
}

std::string extension_names(const Driver& driver) {
  const std::unordered_set<std::string> of_driver = names_of(driver);
  std::string names;
  for (const auto& [name, is_the_drivers] : kExtensions) {
    if (is_the_drivers && !of_driver.contains(std::string(name))) continue;
    if (!names.empty()) names += ' ';
    names += name;
  }
  return names;
}

}  // namespace legacy_gl
