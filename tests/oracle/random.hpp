// Random values for samples, the same on every standard library.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "oracle/matrices.hpp"
#include "oracle/oracle.hpp"

namespace oracle {

class Random {
 public:
  Random(std::uint32_t seed, std::uint32_t number) : generator_(sequence(seed, number)) {}

  // [0,1) on a grid of 2^-24: the same on every standard library.
  float unit() { return float(generator_() >> 8) * 0x1p-24f; }
  float uniform(float low, float high) { return low + (high - low) * unit(); }
  // Spread evenly over the powers of ten.
  float magnitude(float low_exponent, float high_exponent) {
    return float(std::pow(10.0, double(uniform(low_exponent, high_exponent))));
  }
  bool coin() { return (generator_() >> 31) != 0; }
  std::uint32_t below(std::uint32_t n) { return std::uint32_t(generator_()) % n; }

  Color color(float high, float alpha = 1) {
    const float r = uniform(0, high), g = uniform(0, high), b = uniform(0, high);
    return {r, g, b, alpha};
  }

  std::array<float, 3> unit_vector() {
    const double z = double(uniform(-1, 1));
    const double angle = 2 * std::numbers::pi * double(unit());
    const double r = std::sqrt(1 - z * z);
    return {float(r * std::cos(angle)), float(r * std::sin(angle)), float(z)};
  }

  // A rotation by a random unit quaternion.
  Mat3 rotation() {
    std::array<double, 4> q{};
    double norm = 0;
    do {
      norm = 0;
      for (double& c : q) {
        c = double(uniform(-1, 1));
        norm += c * c;
      }
    } while (norm < 0.01 || norm > 1);
    for (double& c : q) c /= std::sqrt(norm);
    const auto [w, x, y, z] = q;
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
             {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
             {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}}};
  }

 private:
  static std::mt19937 sequence(std::uint32_t seed, std::uint32_t number) {
    std::seed_seq both{seed, number};
    return std::mt19937(both);
  }
  std::mt19937 generator_;
};

}  // namespace oracle
