#pragma once
// LEGACY_GL_DEBUG=calls,state,paths,glsl,errors,labels: what the library says of itself. The log
// goes to stderr, or to the file LEGACY_GL_DEBUG_FILE. Read when the first context is made.
#include <atomic>
#include <cstdint>
#include <string_view>

namespace legacy_gl::debug {

enum Category : std::uint32_t {
  kCalls = 1,   ///< each call with its values
  kState = 2,   ///< what a call changed, in groups that are translated together
  kGlsl = 4,    ///< each generated program
  kErrors = 8,  ///< each GL error, with the call that raised it
  kPaths = 16,  ///< how each draw reaches the driver, and why so
  kLabels = 32  ///< KHR_debug: names of the driver's objects, groups of its calls
};

/// The categories of such a text; `unknown` is the first word that names none, or empty.
std::uint32_t parse_categories(std::string_view text, std::string_view& unknown);

/// Reads the environment, once for all contexts.
void read_environment();

/// Calls are named to the log, since a category needs their names. The one test that a call makes;
/// hidden, so that it is one instruction.
[[gnu::visibility("hidden")]] extern constinit std::atomic<bool> naming_calls;
inline bool names_calls() { return naming_calls.load(std::memory_order_relaxed); }

bool wants(Category category);
/// Calls are named from here on, for a context whose debug groups need their names.
void name_calls();

/// One line; `format` as printf's.
[[gnu::cold, gnu::format(printf, 1, 2)]] void log(const char* format, ...);
/// A text of several lines.
[[gnu::cold]] void log_text(std::string_view text);

/// The entry point that this thread is in, "glBegin"; nullptr before the first.
const char* current_call();
void set_current_call(const char* name);

/// Dirty bits were raised (state/dirty.hpp).
[[gnu::cold]] void log_state(std::uint32_t dirty_bits);
[[gnu::cold]] void log_error(unsigned error);

}  // namespace legacy_gl::debug
