#include "debug/log.hpp"

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>

#include "debug/enum_names.hpp"
#include "state/dirty.hpp"

namespace legacy_gl::debug {

constinit std::atomic<bool> naming_calls = false;

namespace {

constexpr struct {
  std::string_view name;
  Category category;
} kCategories[] = {{"calls", kCalls},   {"state", kState}, {"glsl", kGlsl},
                   {"errors", kErrors}, {"paths", kPaths}, {"labels", kLabels}};

constexpr struct {
  std::uint32_t bit;
  const char* name;
} kDirtyNames[] = {{kDirtyTransform, "transform"}, {kDirtyLights, "lights"},
                   {kDirtyMaterial, "material"},   {kDirtyKey, "program key"},
                   {kDirtyRaster, "raster"},       {kDirtyFragments, "fragments"},
                   {kDirtyTexture, "texture"}};

std::atomic<std::uint32_t> categories = 0;
std::FILE* file = nullptr;
thread_local const char* call = nullptr;

void open_file() {
  file = stderr;
  const char* const path = std::getenv("LEGACY_GL_DEBUG_FILE");
  if (!path || !*path) return;
  if (std::FILE* const opened = std::fopen(path, "w")) {
    file = opened;
    // What was logged before a crash is what matters.
    std::setvbuf(file, nullptr, _IOLBF, BUFSIZ);
  } else {
    std::fprintf(stderr, "legacy_gl: LEGACY_GL_DEBUG_FILE: %s cannot be written\n", path);
  }
}

}  // namespace

std::uint32_t parse_categories(std::string_view text, std::string_view& unknown) {
  std::uint32_t found = 0;
  unknown = {};
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view word = text.substr(0, comma);
    text = comma == text.npos ? std::string_view() : text.substr(comma + 1);
    std::uint32_t category = 0;
    for (const auto& known : kCategories)
      if (word == known.name) category = known.category;
    if (!category && !word.empty() && unknown.empty()) unknown = word;
    found |= category;
  }
  return found;
}

void read_environment() {
  static std::once_flag once;
  std::call_once(once, [] {
    const char* const text = std::getenv("LEGACY_GL_DEBUG");
    if (!text) return;
    std::string_view unknown;
    categories = parse_categories(text, unknown);
    if (!unknown.empty())
      std::fprintf(stderr,
                   "legacy_gl: LEGACY_GL_DEBUG: \"%s\" is none of calls, state, glsl, errors, "
                   "paths, labels\n",
                   std::string(unknown).c_str());
    open_file();
    naming_calls = categories & (kCalls | kState | kErrors | kPaths | kLabels);
  });
}

bool wants(Category category) { return categories & category; }

void name_calls() { naming_calls = true; }

void log(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  char line[1024];
  // The analyser does not know va_start here. NOLINTNEXTLINE(clang-analyzer-valist.Uninitialized)
  std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  std::fprintf(file, "%s\n", line);
}

void log_text(std::string_view text) {
  std::fprintf(file, "%.*s\n", static_cast<int>(text.size()), text.data());
}

const char* current_call() { return call; }
void set_current_call(const char* name) { call = name; }

void log_state(std::uint32_t dirty_bits) {
  if (!wants(kState)) return;
  std::string groups;
  for (const auto& [bit, name] : kDirtyNames)
    if (dirty_bits & bit) groups += (groups.empty() ? "" : ", ") + std::string(name);
  log("  %s changes %s", call ? call : "?",
      groups.empty() ? "nothing that is drawn with" : groups.c_str());
}

void log_error(unsigned error) {
  if (!wants(kErrors)) return;
  log("error: %s in %s", enum_text("ErrorCode", error).c_str(), call ? call : "?");
}

}  // namespace legacy_gl::debug
