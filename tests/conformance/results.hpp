// What the comparisons found, gathered over one run of the program. At its end the summary is
// printed and, for each dialect and feature, <output directory>/results/<dialect>.<feature>.tsv is
// written; scripts/conformance makes docs/conformance_scenes.md of them.
#pragma once

#include <string>

#include "support/image.hpp"

namespace legacy_gl::test {

struct Result {
  std::string dialect;
  std::string feature;
  std::string scene;
  PixelFormat format = PixelFormat::rgba8;
  std::string judge;  // "Mesa", or the row of the specification's departure
  float max_difference_steps = 0;
  int differing_pixels = 0;
  bool passed = false;
};

void record_result(const Result& result);

// "RGBA8" or "float".
const char* format_name(PixelFormat format);

}  // namespace legacy_gl::test
