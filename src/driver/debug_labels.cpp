#include "driver/debug_labels.hpp"

#include <algorithm>

#include "debug/log.hpp"

namespace legacy_gl {
namespace {

/// Every driver takes so many characters (KHR_debug, GL_MAX_LABEL_LENGTH and
/// GL_MAX_DEBUG_MESSAGE_LENGTH), the closing 0 included where it counts.
constexpr std::size_t kLongestLabel = 255;

bool is_debug_context(const Driver& driver) {
  GLint flags = 0;
  driver.GetIntegerv(GL_CONTEXT_FLAGS, &flags);
  return flags & GL_CONTEXT_FLAG_DEBUG_BIT;
}

GLsizei label_length(const std::string& text) {
  return static_cast<GLsizei>(std::min(text.size(), kLongestLabel));
}

}  // namespace

void load_debug_labels(Driver& driver, Loader loader, bool wanted) {
  const bool core = driver.major * 10 + driver.minor >= (driver.is_es() ? 32 : 43);
  if (!core && !has_extension(driver, "GL_KHR_debug")) return;
  if (!wanted && !debug::wants(debug::kLabels) && !is_debug_context(driver)) return;
  // On OpenGL ES the extension's functions have its ending.
  const std::string ending = driver.is_es() && !core ? "KHR" : "";
  const auto load = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(
        loader((name + ending).c_str()));
    return function != nullptr;
  };
  if (!load(driver.ObjectLabel, "glObjectLabel") ||
      !load(driver.PushDebugGroup, "glPushDebugGroup") ||
      !load(driver.PopDebugGroup, "glPopDebugGroup")) {
    driver.ObjectLabel = nullptr;
    driver.PushDebugGroup = nullptr;
    driver.PopDebugGroup = nullptr;
    return;
  }
  debug::name_calls();  // groups have the call's name
}

void label(const Driver& driver, GLenum kind, GLuint name, const std::string& text) {
  if (driver.ObjectLabel) driver.ObjectLabel(kind, name, label_length(text), text.c_str());
}

void push_debug_group(const Driver& driver, const char* what) {
  if (!driver.PushDebugGroup) return;
  const char* const call = debug::current_call();
  const std::string text = std::string(call ? call : "legacy_gl") + ": " + what;
  driver.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, label_length(text), text.c_str());
}

void pop_debug_group(const Driver& driver) {
  if (driver.PopDebugGroup) driver.PopDebugGroup();
}

}  // namespace legacy_gl
