#include "context/context.hpp"

#include <cstdio>

#include "debug/log.hpp"

legacy_gl_context::legacy_gl_context(const legacy_gl_options& chosen,
                                     legacy_gl::Recorder& own_recorder,
                                     legacy_gl::ListState& own_lists)
    : options(chosen),
      recorder(own_recorder),
      lighting(chosen.max_lights ? chosen.max_lights : 8),
      lists(own_lists) {
  options.share = nullptr;
  options.cache_directory = options.driver_traits = nullptr;  // the caller's texts
}

legacy_gl_context::~legacy_gl_context() = default;

namespace legacy_gl {

constinit thread_local Context* current_context = nullptr;

void raise_error(Context& context, GLenum error) {
  if (context.error == GL_NO_ERROR) context.error = error;
  debug::log_error(error);
}

void diagnose(Context& context, const std::string& message) {
  if (!context.diagnostics_given.insert(message).second) return;
  if (context.options.diagnostic)
    context.options.diagnostic(message.c_str(), context.options.diagnostic_user);
  else std::fprintf(stderr, "legacy_gl: %s\n", message.c_str());
}

void report_no_context() {
  static thread_local bool said = false;
  if (said) return;
  said = true;
  std::fprintf(stderr, "legacy_gl: a GL function was called without a current context\n");
}

}  // namespace legacy_gl
