#include "stress/stress_classes.hpp"

namespace oracle {
namespace {

StressSample shininess(Random& random) {
  StressSample sample =
      ordinary(random, away(random, 3, random.coin() ? 0.f : 1.f), away(random, 1, 1));
  constexpr std::array<float, 7> values{0, 1e-30f, 1e-3f, 0.5f, 1, 127.5f, 128};
  sample.state.front.shininess = values[random.below(7)];
  return sample;
}

StressSample spot_exponent(Random& random) {
  StressSample sample = ordinary(random, {0, 0, 3, 1}, {0, 0, 0, 1});
  sample.vertex.position_object = {random.uniform(-3, 3), random.uniform(-3, 3), 0, 1};
  constexpr std::array<float, 7> values{0, 1e-30f, 1e-3f, 0.5f, 1, 127.5f, 128};
  sample.state.lights[0].spot_exponent = values[random.below(7)];
  sample.state.lights[0].spot_cutoff_degrees = 80;
  return sample;
}

// n.h is 0 (or below) and n.L is not: the specular factor is 0^s.
StressSample zero_to_the_power(Random& random) {
  StressSample sample = ordinary(random, {0, 1, 0, 0}, away(random, 1, 1));
  sample.vertex.normal_object =
      random.coin() ? std::array<float, 3>{0, 0.6f, -0.8f} : std::array<float, 3>{0, 0.8f, -0.8f};
  constexpr std::array<float, 4> values{0, 1e-30f, 1, 128};
  sample.state.front.shininess = values[random.below(4)];
  sample.state.back.shininess = values[random.below(4)];
  sample.state.light_model.two_side = random.coin();
  return sample;
}

// The spot's cosine is 0 at its half space's edge: 0^e.
StressSample zero_to_the_spot_exponent(Random& random) {
  StressSample sample = ordinary(random, {0, 2, 0, 1}, {0, 0, 0, 1});
  constexpr std::array<float, 4> values{0, 1e-30f, 1, 128};
  sample.state.lights[0].spot_exponent = values[random.below(4)];
  sample.state.lights[0].spot_cutoff_degrees = 90;
  return sample;
}

Color huge(Random& random, bool negative) {
  Color color{0, 0, 0, random.unit()};
  for (std::size_t c = 0; c < 3; ++c) {
    color[c] = random.magnitude(-30, 30) * (negative && random.coin() ? -1.f : 1.f);
  }
  return color;
}

StressSample colors_by(Random& random, bool negative) {
  StressSample sample =
      ordinary(random, away(random, 3, random.coin() ? 0.f : 1.f), away(random, 1, 1));
  Material& m = sample.state.front;
  Light& light = sample.state.lights[0];
  for (Color* color : {&m.ambient, &m.diffuse, &m.specular, &m.emission, &light.ambient,
                       &light.diffuse, &light.specular, &sample.state.light_model.ambient}) {
    *color = huge(random, negative);
  }
  return sample;
}

StressSample colors(Random& random) { return colors_by(random, false); }
StressSample signed_colors(Random& random) { return colors_by(random, true); }

// Normals longer than 1, whose powers leave float32's range, with a channel that does not reflect
// and a cone that does not reach every vertex.
StressSample long_normals(Random& random) {
  StressSample sample = ordinary(random, {0, 0, 3, 1}, {0, 0, 0, 1});
  sample.vertex.position_object = {random.uniform(-3, 3), random.uniform(-3, 3), 0, 1};
  const float length = random.magnitude(0, 1);
  for (float& c : sample.vertex.normal_object) c *= length;
  sample.state.front.shininess = random.coin() ? 128.f : random.uniform(1, 128);
  sample.state.front.specular[random.below(3)] = 0;
  sample.state.lights[0].spot_cutoff_degrees = 40;
  sample.state.lights[0].spot_exponent = float(random.below(3));
  return sample;
}

StressSample tracked_colors(Random& random) {
  StressSample sample = ordinary(random, away(random, 3, 0), away(random, 1, 1));
  sample.vertex.color = huge(random, true);
  sample.state.color_material = {true, ColorMaterial::Face::front_and_back,
                                 ColorMaterial::Mode(random.below(5))};
  return sample;
}

}  // namespace

std::span<const StressClass> material_classes() {
  static const StressClass classes[] = {
      {"shininess 0, 1e-30 to 128", shininess},
      {"spot exponent 0, 1e-30 to 128", spot_exponent},
      {"zero to the shininess", zero_to_the_power},
      {"zero to the spot exponent", zero_to_the_spot_exponent, 0.5, true},
      {"normals 1 to 10, shininess to 128", long_normals},
      {"colours 1e-30 to 1e30", colors},
      {"colours to +-1e30", signed_colors},
      {"tracked colours to +-1e30", tracked_colors},
  };
  return classes;
}

}  // namespace oracle
