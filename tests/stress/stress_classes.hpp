// Extreme and degenerate input, class by class: each sample is one vertex under one state.
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "oracle/oracle.hpp"
#include "oracle/random.hpp"

namespace oracle {

struct StressSample {
  State state;
  Vertex vertex;
};

struct StressClass {
  std::string name;
  StressSample (*make)(Random& random);
  // The error that is allowed where the specification defines the answer, in 1/255.
  double bound_steps = 0.5;
  // The samples lie exactly on a jump of the equation, where the specification takes a side.
  bool on_a_jump = false;
};

inline void PrintTo(const StressClass& stress_class, std::ostream* out) {
  *out << stress_class.name;
}

std::span<const StressClass> stress_classes();

// Its parts, by what is extreme.
std::span<const StressClass> geometry_classes();
std::span<const StressClass> light_classes();
std::span<const StressClass> material_classes();

// An ordinary sample to make extreme: one white light of the given position, a material with every
// term, the vertex at `position` with a random normal.
StressSample ordinary(Random& random, std::array<float, 4> light_position,
                      std::array<float, 4> vertex_position);

// `length` in a random direction.
std::array<float, 4> away(Random& random, float length, float w);

}  // namespace oracle
