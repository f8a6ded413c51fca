// What the generators share: random numbers, what the program may have, and calls appended to it.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/program.hpp"

namespace legacy_gl::fuzz {

// The standard's distributions differ between libraries; the engine does not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  int between(int low, int high) { return low + below(high - low + 1); }
  bool chance(int percent) { return below(100) < percent; }
  // With three decimals: programs are read by people.
  double real(double low, double high);
  std::vector<double> reals(std::size_t count, double low, double high);
  std::vector<double> whole(std::size_t count, int low, int high);
  template <typename T>
  T pick(std::initializer_list<T> choices) {
    return choices.begin()[below(static_cast<int>(choices.size()))];
  }

 private:
  std::mt19937_64 engine_;
};

// What a program has. decide_traits() leaves out what known deviations (docs/deviations.md) keep
// from being compared, so that whatever the generators then make must agree.
struct Traits {
  bool lit = false;
  bool spots = false;
  bool two_sided = false;
  bool color_material = false;
  bool fog = false;
  bool fog_coordinates = false;
  bool color_sum = false;
  bool textured = false;
  bool texgen = false;
  bool unfilled = false;
  bool line_stipple = false;
  bool polygon_stipple = false;
  bool wide = false;  // lines and points
  bool smooth_lines = false;
  bool blended = false;
  bool logic_op = false;
  bool clip_planes = false;
  bool perspective = false;
  bool outside = false;  // primitives that leave the view volume
  bool flat = false;
  bool pixels = false;
  bool evaluators = false;
  bool arrays = false;
  bool lists = false;
  bool stacks = false;
  bool hits = false;  // selection and feedback
  bool errors = false;
  bool queries = false;
  bool vertex_w = false;
  int color_components = 4;
};

class Builder {
 public:
  explicit Builder(std::uint64_t seed);

  template <typename... A>
  void call(std::string_view function, A&&... arguments) {
    program.push_back({std::string(function), {to_argument(std::forward<A>(arguments))...}});
  }
  void enable(std::string_view capability, bool on) { call(on ? "Enable" : "Disable", capability); }

  std::vector<double> color();
  // A coordinate that the traits allow.
  double coordinate();

  Random random;
  Traits traits;
  Program program;
  // Inside glNewList: no calls that are not compiled, no other lists.
  bool in_list = false;
  // Inside glPushAttrib: no calls that Mesa's glPopAttrib does not take back (M9, M16).
  bool in_stack = false;
  int lists_made = 0;

 private:
  static Argument to_argument(Argument argument) { return argument; }
  static Argument to_argument(std::string_view names) { return name(names); }
  static Argument to_argument(const char* names) { return name(names); }
  static Argument to_argument(int value) { return integer(value); }
  static Argument to_argument(double value) { return real(value); }
};

inline Argument floats(const std::vector<double>& values) { return input("GLfloat", values); }

Traits decide_traits(Random& random);

}  // namespace legacy_gl::fuzz
