#include "fuzz/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace legacy_gl::fuzz {

namespace {

struct PictureTolerance {
  int steps;   // what every pixel may be off, in 1/255
  int pixels;  // how many may be off by more
};

// One step for a colour that falls between two; a second where it is blended, combined or summed,
// which adds what two roundings differ by.
PictureTolerance picture_tolerance(const Program& program) {
  PictureTolerance tolerance{2, 0};
  // Nearest texels, alpha tests and bits of a logical operation turn a last digit into another
  // colour.
  const bool textures = mentions(program, "GL_TEXTURE_2D", "Enable") ||
                        mentions(program, "GL_TEXTURE_1D", "Enable") ||
                        mentions(program, "GL_TEXTURE_3D", "Enable") ||
                        mentions(program, "GL_TEXTURE_CUBE_MAP", "Enable");
  if (textures) tolerance = {4, 8};
  // A product scaled by 4 twice.
  if (mentions(program, "GL_RGB_SCALE") || mentions(program, "GL_ALPHA_SCALE")) tolerance = {16, 8};
  if (mentions(program, "GL_ALPHA_TEST", "Enable")) tolerance.pixels = 8;
  if (mentions(program, "GL_COLOR_LOGIC_OP", "Enable")) tolerance = {4, 40};
  return tolerance;
}

// Float32 arithmetic in another order, twelve digits of it for windows coordinates of feedback.
bool answers_agree(const Answer& ours, const Answer& mesa) {
  if (ours.values.size() != mesa.values.size()) return false;
  const bool exact = ours.element.empty();
  const bool real = ours.element == "GLfloat" || ours.element == "GLdouble";
  for (std::size_t i = 0; i < ours.values.size(); ++i) {
    const double a = ours.values[i];
    const double b = mesa.values[i];
    if (a == b || (std::isnan(a) && std::isnan(b))) continue;
    // M20: Mesa has no GL_LINE_RESET_TOKEN.
    const bool lines = ours.call == "feedback" && std::min(a, b) == GL_LINE_TOKEN &&
                       std::max(a, b) == GL_LINE_RESET_TOKEN;
    if (lines) continue;
    double tolerance = exact ? 0.0 : real ? 2e-4 * std::max(1.0, std::abs(b)) : 0.0;
    if (ours.call == "ReadPixels") tolerance = real ? 0.02 : 3;
    // The nearest and farthest depth of a hit, in units of 2^-32: as exact as a float.
    if (ours.call == "selection") tolerance = 1e-5 * 4294967295.0;
    if (!(std::abs(a - b) <= tolerance)) return false;
  }
  return true;
}

std::string words_of(const Answer& answer) {
  std::ostringstream words;
  words.precision(8);
  for (const double value : answer.values) {
    words << ' ' << value;
    if (words.tellp() > 2000) break;
  }
  return words.str();
}

std::optional<Difference> compare_pictures(PictureTolerance tolerance, const test::Image& ours,
                                           const test::Image& mesa, std::size_t frame) {
  int pixels = 0;
  int worst = 0;
  int worst_x = 0;
  int worst_y = 0;
  for (int y = 0; y < mesa.height; ++y) {
    for (int x = 0; x < mesa.width; ++x) {
      float off = 0;
      for (int channel = 0; channel < 4; ++channel)
        off = std::max(off, std::abs(ours.steps(x, y, channel) - mesa.steps(x, y, channel)));
      if (off <= static_cast<float>(tolerance.steps)) continue;
      ++pixels;
      if (static_cast<int>(off) <= worst) continue;
      worst = static_cast<int>(off);
      worst_x = x;
      worst_y = y;
    }
  }
  if (pixels <= tolerance.pixels) return std::nullopt;
  std::ostringstream words;
  words << "frame " << frame << ": " << pixels << " pixels, at (" << worst_x << ", " << worst_y
        << ") by " << worst << ": ours";
  for (int channel = 0; channel < 4; ++channel)
    words << ' ' << ours.steps(worst_x, worst_y, channel);
  words << ", Mesa's";
  for (int channel = 0; channel < 4; ++channel)
    words << ' ' << mesa.steps(worst_x, worst_y, channel);
  return Difference{"picture", words.str(), static_cast<int>(frame)};
}

}  // namespace

std::optional<Difference> compare(const Program& program, const Recording& ours,
                                  const Recording& mesa) {
  const std::size_t count = std::min(ours.answers.size(), mesa.answers.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Answer& a = ours.answers[i];
    const Answer& b = mesa.answers[i];
    if (a.call == b.call && answers_agree(a, b)) continue;
    return Difference{a.call,
                      "frame " + std::to_string(a.frame) + ": ours " + a.call + words_of(a) +
                          ", Mesa's " + b.call + words_of(b),
                      a.frame};
  }
  if (ours.answers.size() != mesa.answers.size())
    return Difference{"GetError", "errors at the end", frame_count - 1};
  const PictureTolerance tolerance = picture_tolerance(program);
  for (std::size_t i = 0; i < mesa.pictures.size(); ++i)
    if (auto difference = compare_pictures(tolerance, ours.pictures[i], mesa.pictures[i], i))
      return difference;
  if (!ours.diagnostics.empty())
    return Difference{"diagnostic", ours.diagnostics.front(), frame_count - 1};
  return std::nullopt;
}

}  // namespace legacy_gl::fuzz
