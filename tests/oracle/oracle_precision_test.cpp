// How far the double oracle can be trusted: the same code in a wider scalar, on random states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "oracle/oracle.hpp"

namespace oracle {
namespace {

#ifdef ORACLE_HAS_FLOAT128
using Wide = OracleFloat128;
#else
using Wide = long double;
#endif

class RandomStates {
 public:
  float uniform(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(generator_);
  }
  // Spread evenly over the powers of ten.
  float magnitude(float low_exponent, float high_exponent) {
    return std::pow(10.f, uniform(low_exponent, high_exponent));
  }
  bool coin() { return generator_() % 2 == 0; }
  Color color(float high) { return {uniform(0, high), uniform(0, high), uniform(0, high), 1}; }
  std::array<float, 3> direction(float scale) {
    return {scale * uniform(-1, 1), scale * uniform(-1, 1), scale * uniform(-1, 1)};
  }

  State state() {
    State s;
    s.light_model = {color(1), coin(), coin(), coin()};
    s.front.shininess = uniform(0, 128);
    s.back.shininess = coin() ? 0.f : 128.f;
    s.front.specular = s.back.specular = color(1);
    s.normalize = coin();
    s.rescale_normal = coin();
    const float scale = magnitude(-10, 10);
    for (std::size_t column = 0; column < 3; ++column) {
      for (std::size_t row = 0; row < 3; ++row) {
        s.modelview[4 * column + row] = double(scale * uniform(-1, 1));
      }
    }
    const std::size_t count = 1 + generator_() % 8;
    for (std::size_t i = 0; i < count; ++i) {
      Light light;
      light.ambient = color(0.2f);
      light.specular = color(1);
      const auto p = direction(magnitude(-10, 10));
      light.position_specified = {p[0], p[1], p[2], coin() ? 0 : uniform(0.1f, 4)};
      light.spot_direction_specified = direction(magnitude(-10, 10));
      light.spot_exponent = uniform(0, 128);
      light.spot_cutoff_degrees = coin() ? 180 : uniform(0, 90);
      light.linear_attenuation = uniform(0, 1);
      light.quadratic_attenuation = uniform(0, 1);
      s.lights.push_back(light);
    }
    return s;
  }

  Vertex vertex() {
    Vertex v;
    const auto p = direction(magnitude(-10, 10));
    v.position_object = {p[0], p[1], p[2], 1};
    v.normal_object = direction(1);
    v.color = color(1);
    return v;
  }

 private:
  std::mt19937 generator_{20240229};
};

TEST(Precision, DoubleAgreesWithTheWideScalar) {
  RandomStates random;
  double largest = 0;
  int judged = 0;
  for (int i = 0; i < 20000; ++i) {
    const State state = random.state();
    const Vertex vertex = random.vertex();
    const auto narrow = evaluate(state, vertex);
    const auto wide = evaluate_as<Wide>(state, vertex);
    ASSERT_EQ(narrow.defined, wide.defined) << i;
    if (!narrow.defined || narrow.distance_to_jump < 1e-10) continue;
    ++judged;
    for (std::size_t c = 0; c < 3; ++c) {
      for (const auto face : {&BasicResult<double>::front, &BasicResult<double>::back}) {
        const auto wide_face = face == &BasicResult<double>::front ? wide.front : wide.back;
        const auto& narrow_face = narrow.*face;
        largest = std::max(largest, std::abs(narrow_face.primary_clamped[c] -
                                             double(wide_face.primary_clamped[c])));
        largest = std::max(largest, std::abs(narrow_face.secondary_clamped[c] -
                                             double(wide_face.secondary_clamped[c])));
      }
    }
  }
  // 1e-13 was found (16-digit scalar, the largest power 128, modelviews of any condition); four
  // decades below the 1e-8 at which float results are judged is what this asserts.
  EXPECT_LT(largest, 1e-12);
  EXPECT_GT(judged, 19000);
  RecordProperty("largest_difference", std::to_string(largest));
  std::printf("largest difference of double to the wide scalar: %.3g\n", largest);
}

}  // namespace
}  // namespace oracle
