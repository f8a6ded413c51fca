#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace legacy_gl::glu {

// libGLU's limit; a picture of more would differ from the one that programs are known to draw.
inline constexpr int max_segment_count = 239;

struct Direction {
  float sine = 0.0F;
  float cosine = 0.0F;
};

// The angle is rounded to float before the sine is taken and scaled, as in libGLU: equal vertices
// need equal rounding.
inline Direction direction(double angle_radians, double length) {
  const double angle = static_cast<double>(static_cast<float>(angle_radians));
  return {static_cast<float>(length * std::sin(angle)),
          static_cast<float>(length * std::cos(angle))};
}

// The vectors of one length from the segment boundaries 0 to segment_count of a sweep that begins
// at start_radians.
class Directions {
 public:
  // offset, in segments: 0 for the boundaries, -0.5 for the middles of the segments before them.
  Directions(int segment_count, double start_radians, double sweep_radians, double offset,
             double length = 1.0) {
    for (int i = 0; i <= segment_count; ++i) {
      directions_[static_cast<std::size_t>(i)] =
          direction(start_radians + sweep_radians * (i + offset) / segment_count, length);
    }
  }

  // A full turn ends in the very numbers it began with, so that no crack opens at the seam.
  static Directions full_turn(int segment_count, double offset, double length = 1.0) {
    Directions turn(segment_count, 0.0, 2.0 * M_PI, offset, length);
    turn[segment_count] = turn[0];
    return turn;
  }

  Direction& operator[](int i) { return directions_[static_cast<std::size_t>(i)]; }
  const Direction& operator[](int i) const { return directions_[static_cast<std::size_t>(i)]; }

 private:
  std::array<Direction, max_segment_count + 1> directions_;
};

}  // namespace legacy_gl::glu
