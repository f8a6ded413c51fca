#include "support/shared_context.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace legacy_gl::test {

namespace {

class SharedContexts final : public testing::Environment {
 public:
  void TearDown() override { contexts.clear(); }
  std::vector<std::unique_ptr<RenderContext>> contexts;
};

// GoogleTest owns it.
SharedContexts* const shared_contexts = [] {
  auto* environment = new SharedContexts;
  testing::AddGlobalTestEnvironment(environment);
  return environment;
}();

}  // namespace

void end_with_the_tests(std::unique_ptr<RenderContext> context) {
  shared_contexts->contexts.push_back(std::move(context));
}

}  // namespace legacy_gl::test
