#include "support/image_matcher.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace legacy_gl::test {

namespace {

void describe_pixel(std::ostream& out, const Image& image, int x, int y) {
  out << "(";
  for (int channel = 0; channel < 4; ++channel)
    out << (channel == 0 ? "" : ", ") << image.steps(x, y, channel);
  out << ")";
}

std::string file_name(std::string name) {
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

}  // namespace

std::string test_output_directory() {
  const char* from_environment = std::getenv("LEGACY_GL_TEST_OUTPUT_DIR");
  std::string directory =
      from_environment != nullptr ? from_environment : LEGACY_GL_TEST_OUTPUT_DIR;
  std::filesystem::create_directories(directory);
  return directory;
}

testing::AssertionResult images_match(const Image& ours, const Image& reference,
                                      const ImageTolerance& tolerance, const std::string& name) {
  const Comparison comparison = compare(ours, reference);
  const bool close = comparison.max_difference() <= tolerance.max_difference_steps;
  const bool covered = !tolerance.same_coverage || comparison.same_coverage();
  if (close && covered) return testing::AssertionSuccess();

  const std::string base = test_output_directory() + "/" + file_name(name);
  write_png(ours, base + "-ours.png");
  write_png(reference, base + "-reference.png");
  // One step becomes visible (32), a large difference saturates.
  write_png(amplified_difference(ours, reference, 32.0F), base + "-difference.png");

  std::ostringstream message;
  message << name << ": largest difference in 1/255 (r g b a):";
  for (const float difference : comparison.max_difference_steps) message << " " << difference;
  message << ", allowed " << tolerance.max_difference_steps << "; " << comparison.differing_pixels
          << " pixels differ; covered only in ours " << comparison.covered_only_in_first
          << ", only in the reference " << comparison.covered_only_in_second << "\n  worst pixel ("
          << comparison.worst_x << ", " << comparison.worst_y << "): ours ";
  describe_pixel(message, ours, comparison.worst_x, comparison.worst_y);
  message << " reference ";
  describe_pixel(message, reference, comparison.worst_x, comparison.worst_y);
  message << "\n  " << base << "-ours.png\n  " << base << "-reference.png\n  " << base
          << "-difference.png";
  return testing::AssertionFailure() << message.str();
}

}  // namespace legacy_gl::test
