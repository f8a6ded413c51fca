#pragma once

#include <string>

#include "settings.h"

// What legacy_gl draws over: OpenGL 3.3 core, or OpenGL ES 3.0.
enum class Dialect { core, es };

struct CommandLine {
  settings scene = default_settings();
  std::string output = ".";
  Dialect dialect = Dialect::core;
  int amplification = 128;
};

// Prints and ends the program on --help and on wrong arguments.
CommandLine parse_command_line(int argc, char** argv);
