// GoogleTest's view of a comparison: EXPECT_TRUE(images_match(ours, mesa, tolerance, "name")).
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "support/image.hpp"

namespace legacy_gl::test {

struct ImageTolerance {
  float max_difference_steps = 0.0F;  // in 1/255
  bool same_coverage = true;
};

// On failure writes <name>-ours.png, <name>-reference.png and <name>-difference.png (amplified)
// into the test output directory, and the message gives their paths and the worst pixel.
testing::AssertionResult images_match(const Image& ours, const Image& reference,
                                      const ImageTolerance& tolerance, const std::string& name);

// LEGACY_GL_TEST_OUTPUT_DIR of the environment, else the one given at build time. Created on
// demand.
std::string test_output_directory();

}  // namespace legacy_gl::test
