// What our GLU and libGLU hand the GL, call by call. The program defines every GL entry point that
// the compared functions use, once as glX (libGLU finds these before libOpenGL's) and once as lglX,
// and records the calls; there is no GL context.
//
// Arguments are compared exactly (0 equals -0): vertices that differ in the last bit move single
// pixels, and then a port's picture is not the old one.
#pragma once

// Both headers in one translation unit: the old names are libGLU's, the lgl names ours.
#define LEGACY_GL_NO_NAMES
#include <GL/glu.h>
#include <legacy_gl/glu.h>

#include <functional>
#include <iosfwd>
#include <string_view>
#include <vector>

namespace glu_test {

struct Call {
  std::string_view name;
  std::vector<double> arguments;

  bool operator==(const Call&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Call& call);

using Calls = std::vector<Call>;

Calls calls_of(const std::function<void()>& draw);

void expect_same(const Calls& ours, const Calls& theirs);

}  // namespace glu_test
