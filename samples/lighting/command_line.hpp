#pragma once

#include <string>

#include "settings.h"

struct CommandLine {
  settings scene = default_settings();
  std::string output = ".";
  int amplification = 128;
};

// Prints and ends the program on --help and on wrong arguments.
CommandLine parse_command_line(int argc, char** argv);
