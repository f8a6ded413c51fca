// Plays a program and records what it shows and answers.
#pragma once

#include <string>
#include <vector>

#include "fuzz/program.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::fuzz {

// Frames of one context: what is drawn alike in several takes other ways through the library.
constexpr int frame_count = 4;

struct Answer {
  int frame;
  std::string call;     // its name
  std::string element;  // the type of the values; empty for a returned value
  std::vector<double> values;
};

struct Recording {
  std::vector<Answer> answers;
  std::vector<test::Image> pictures;  // after each frame
  std::vector<std::string> diagnostics;
};

Recording play(test::RenderContext& context, const Program& program, int frames = frame_count);

}  // namespace legacy_gl::fuzz
