// A context that all tests of a program share. It ends with the last test and not at exit, where a
// driver's own state may already be gone: softpipe crashes there, now and then.
#pragma once

#include <memory>
#include <utility>

#include "support/contexts.hpp"

namespace legacy_gl::test {

void end_with_the_tests(std::unique_ptr<RenderContext> context);

// For the initialiser of a static reference: the context is made when a test first asks for it.
template <class Context, class... Arguments>
Context& make_shared_context(Arguments&&... arguments) {
  auto context = std::make_unique<Context>(std::forward<Arguments>(arguments)...);
  Context& reference = *context;
  end_with_the_tests(std::move(context));
  return reference;
}

}  // namespace legacy_gl::test
