// Random OpenGL programs, played on Mesa's fixed function and on legacy_gl. See README.md.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "fuzz/generators.hpp"
#include "fuzz/judge.hpp"
#include "fuzz/known.hpp"
#include "fuzz/minimise.hpp"

namespace legacy_gl::fuzz {

namespace {

struct Options {
  std::uint64_t first = 1;
  std::uint64_t count = 0;
  std::string findings = ".";
  double minimise_seconds = 60;
  std::string mode;
  std::vector<std::string> play;
  std::string crash;
  std::string print;
};

Program read_program(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return parse_c(text.str());
}

// A number is a seed, anything else a file.
Program program_of(const std::string& what) {
  if (what.find_first_not_of("0123456789") == std::string::npos) return generate(std::stoull(what));
  return read_program(what);
}

// Both dialects; the other settings alternate with the seed.
std::vector<Mode> modes_of_seed(std::uint64_t seed) {
  const auto& modes = all_modes();
  const std::size_t first = seed % (modes.size() / 2) * 2;
  return {modes[first], modes[first + 1]};
}

void write_finding(const Options& options, const std::string& seed, const Mode& mode,
                   const Program& program, const Difference& difference) {
  std::filesystem::create_directories(options.findings);
  const std::string path =
      options.findings + "/" + seed + "-" + mode.name() + "-" + difference.kind + ".c";
  std::ofstream(path) << print_c(program, "seed " + seed + ", " + mode.name() + ", " +
                                              difference.kind + "\n" + difference.words);
  std::cout << "finding: seed " << seed << ' ' << mode.name() << ' ' << difference.kind << ", "
            << program.size() << " calls: " << difference.words.substr(0, 160) << " -> " << path
            << std::endl;
}

// While it is minimised a program must keep its kind of difference, and not turn into a known one.
void report(const Options& options, const std::string& seed, const Program& program,
            const Mode& mode, const Difference& first) {
  const auto fails = [&](const Program& candidate) {
    const auto found = Judge(candidate, first.frame + 1).difference(mode);
    return found && found->kind == first.kind && known_fault(candidate, mode, *found) == nullptr;
  };
  const Program smallest = minimise(program, fails, options.minimise_seconds);
  const auto difference = Judge(smallest).difference(mode);
  if (difference) write_finding(options, seed, mode, smallest, *difference);
}

int run_seeds(const Options& options) {
  std::size_t known = 0;
  for (std::uint64_t seed = options.first; seed < options.first + options.count; ++seed) {
    const Program program = generate(seed);
    Judge judge(program);
    std::string reported;
    for (const Mode& mode : modes_of_seed(seed)) {
      // The caller learns from it what crashed.
      std::cout << "at " << seed << ' ' << mode.name() << std::endl;
      if (deviation(program, mode) != nullptr) continue;
      const auto difference = judge.difference(mode);
      if (!difference) continue;
      if (difference->kind == reported) {
        std::cout << "also: seed " << seed << ' ' << mode.name() << ' ' << reported << std::endl;
      } else if (const char* fault = known_fault(program, mode, *difference)) {
        std::cout << "known: seed " << seed << ' ' << mode.name() << ' ' << fault << std::endl;
        ++known;
      } else {
        reported = difference->kind;
        report(options, std::to_string(seed), program, mode, *difference);
      }
    }
  }
  std::cout << "done: " << options.count << " seeds, " << known << " known" << std::endl;
  return 0;
}

int play_programs(const Options& options) {
  int differing = 0;
  for (const std::string& what : options.play) {
    const Program program = program_of(what);
    Judge judge(program);
    for (const Mode& mode : all_modes()) {
      if (!options.mode.empty() && mode.name() != options.mode) continue;
      if (deviation(program, mode) != nullptr) continue;
      const auto difference = judge.difference(mode);
      if (!difference) continue;
      ++differing;
      const char* fault = known_fault(program, mode, *difference);
      std::cout << what << ' ' << mode.name() << ' ' << difference->kind << ": "
                << difference->words << (fault ? std::string(" known: ") + fault : "") << std::endl;
    }
  }
  return differing == 0 ? 0 : 1;
}

// Each attempt in a process of its own.
int minimise_crash(const Options& options) {
  const Mode mode = mode_named(options.mode);
  const Program program = program_of(options.crash);
  const auto kind = [&](const Program& candidate) {
    const auto found = difference_in_child(candidate, mode);
    return found ? found->kind : std::string();
  };
  const std::string first = kind(program);
  if (first != "crash" && first != "hang") {
    std::cout << "no crash: seed " << options.crash << ' ' << mode.name() << std::endl;
    return 1;
  }
  const Program smallest = minimise(
      program, [&](const Program& candidate) { return kind(candidate) == first; },
      options.minimise_seconds);
  write_finding(options, options.crash, mode, smallest, *difference_in_child(smallest, mode));
  return 0;
}

int run(const Options& options) {
  if (!options.print.empty()) {
    std::cout << print_c(program_of(options.print), "seed " + options.print);
    return 0;
  }
  if (!options.crash.empty()) return minimise_crash(options);
  if (!options.play.empty()) return play_programs(options);
  return run_seeds(options);
}

}  // namespace

}  // namespace legacy_gl::fuzz

int main(int argc, char** argv) {
  // Pictures are small: threads of the rasteriser would only wait for each other.
  setenv("LP_NUM_THREADS", "0", 0);
  legacy_gl::fuzz::Options options;
  CLI::App app("Random OpenGL programs, played on Mesa's fixed function and on legacy_gl");
  app.add_option("--first", options.first, "the first seed");
  app.add_option("--count", options.count, "how many seeds");
  app.add_option("--findings", options.findings,
                 "the folder that programs which differ are written to");
  app.add_option("--minimise-seconds", options.minimise_seconds, "how long one is minimised");
  app.add_option("--mode", options.mode, "one mode alone, e.g. core-general-generic");
  app.add_option("--play", options.play, "plays programs (files or seeds) in all modes");
  app.add_option("--crash", options.crash, "minimises a program that crashes in --mode");
  app.add_option("--print", options.print, "the program of a seed");
  CLI11_PARSE(app, argc, argv);
  try {
    const int status = legacy_gl::fuzz::run(options);
    legacy_gl::fuzz::close_contexts();
    return status;
  } catch (const std::exception& error) {
    std::cerr << "fuzz: " << error.what() << '\n';
    return 2;
  }
}
