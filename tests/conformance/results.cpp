#include "conformance/results.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <vector>

#include "support/image_matcher.hpp"

namespace legacy_gl::test {

namespace {

std::vector<Result>& results() {
  static std::vector<Result> all;
  return all;
}

class WriteResults final : public testing::Environment {
 public:
  void TearDown() override {
    if (results().empty()) return;
    const std::string directory = test_output_directory() + "/results";
    std::filesystem::create_directories(directory);
    std::map<std::string, std::ofstream> files;
    int identical = 0;
    int passed = 0;
    for (const Result& result : results()) {
      const std::string name = result.dialect + "." + result.feature + ".tsv";
      if (files.count(name) == 0) files.emplace(name, directory + "/" + name);
      files.at(name) << result.dialect << '\t' << result.feature << '\t' << result.scene << '\t'
                     << format_name(result.format) << '\t' << result.judge << '\t'
                     << result.max_difference_steps << '\t' << result.differing_pixels << '\t'
                     << (result.passed ? "pass" : "FAIL") << '\n';
      identical += result.differing_pixels == 0 ? 1 : 0;
      passed += result.passed ? 1 : 0;
    }
    std::cout << "conformance: " << results().size() << " images compared, " << passed
              << " within tolerance, " << identical << " bit-identical\n";
    for (const Result& result : results())
      if (!result.passed)
        std::cout << "  FAIL " << result.dialect << " " << result.feature << " " << result.scene
                  << " " << format_name(result.format) << ": largest difference "
                  << result.max_difference_steps << "/255, " << result.differing_pixels
                  << " pixels\n";
  }
};

[[maybe_unused]] const testing::Environment* const environment =
    testing::AddGlobalTestEnvironment(new WriteResults);

}  // namespace

const char* format_name(PixelFormat format) {
  return format == PixelFormat::rgba8 ? "RGBA8" : "float";
}

void record_result(const Result& result) { results().push_back(result); }

}  // namespace legacy_gl::test
