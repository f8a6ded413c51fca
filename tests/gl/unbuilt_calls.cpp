#include "gl/error_cases.hpp"

namespace legacy_gl::test {

const std::vector<UnbuiltCall>& unbuilt_calls() {
  static const std::vector<UnbuiltCall> calls = {
#include "gl/unbuilt_calls.inc"
  };
  return calls;
}

}  // namespace legacy_gl::test
