#include <limits>

#include "stress/stress_classes.hpp"

namespace oracle {
namespace {

StressSample directional_of_any_length(Random& random) {
  return ordinary(random, away(random, random.magnitude(-38, 37.69f), 0), away(random, 1, 1));
}

StressSample light_w(Random& random) {
  const float w = random.magnitude(-30, 30) * (random.coin() ? 1.f : -1.f);
  StressSample sample = ordinary(random, away(random, 3, w), away(random, 1, 1));
  sample.state.light_model.local_viewer = random.coin();
  return sample;
}

// What w divides lies at ordinary distances.
StressSample light_w_near(Random& random) {
  const float w = random.magnitude(-30, 30) * (random.coin() ? 1.f : -1.f);
  return ordinary(random, away(random, 3 * std::abs(w), w), away(random, 1, 1));
}

StressSample attenuation(Random& random) {
  StressSample sample = ordinary(random, away(random, 3, 1), away(random, 1, 1));
  Light& light = sample.state.lights[0];
  const auto coefficient = [&] {
    return random.below(3) == 0 ? 0.f : random.magnitude(-42, 38.5f);
  };
  light.constant_attenuation = coefficient();
  light.linear_attenuation = coefficient();
  light.quadratic_attenuation = coefficient();
  return sample;
}

StressSample attenuation_zero(Random& random) {
  StressSample sample = ordinary(random, away(random, 3, 1), away(random, 1, 1));
  sample.state.lights[0].constant_attenuation = 0;
  return sample;
}

// The light shines from where it is towards the vertex, `degrees` off its axis.
void aim(Random& random, StressSample& sample, double degrees) {
  const auto& l = sample.state.lights[0].position_specified;
  const auto& v = sample.vertex.position_object;
  const Vector3<double> axis = unit(Vector3<double>{
      double(v[0]) - double(l[0]), double(v[1]) - double(l[1]), double(v[2]) - double(l[2])});
  const auto r = random.unit_vector();
  const Vector3<double> side =
      unit(cross(axis, Vector3<double>{double(r[0]), double(r[1]), double(r[2])}));
  const double angle = degrees * std::numbers::pi / 180;
  const Vector3<double> d = std::cos(angle) * axis + std::sin(angle) * side;
  sample.state.lights[0].spot_direction_specified = {float(d.x), float(d.y), float(d.z)};
}

StressSample spot(Random& random) {
  StressSample sample = ordinary(random, away(random, 3, 1), away(random, 1, 1));
  aim(random, sample, double(random.uniform(0, 95)));
  sample.state.lights[0].spot_cutoff_degrees = random.uniform(0, 90);
  return sample;
}

StressSample spot_direction_of_any_length(Random& random) {
  StressSample sample = spot(random);
  const float length = random.magnitude(-44, 38.47f);
  for (float& c : sample.state.lights[0].spot_direction_specified) c *= length;
  sample.state.lights[0].spot_cutoff_degrees = 60;
  sample.state.lights[0].spot_exponent = 1;
  return sample;
}

StressSample spot_direction_zero(Random& random) {
  StressSample sample = spot(random);
  sample.state.lights[0].spot_direction_specified = {0, 0, 0};
  return sample;
}

StressSample cutoffs(Random& random) {
  StressSample sample = spot(random);
  constexpr std::array<float, 6> cutoffs_degrees{0, 1e-3f, 0.5f, 89.99f, 90, 180};
  sample.state.lights[0].spot_cutoff_degrees = cutoffs_degrees[random.below(6)];
  aim(random, sample, double(random.uniform(0, 120)));
  return sample;
}

// Within a millionth of the cone's cosine on either side.
StressSample beside_the_cone(Random& random) {
  StressSample sample = spot(random);
  const float cutoff = random.uniform(5, 90);
  sample.state.lights[0].spot_cutoff_degrees = cutoff;
  aim(random, sample, double(cutoff) + double(random.uniform(-1e-3f, 1e-3f)));
  return sample;
}

// Positions and cones of which the cosines are equal in exact arithmetic: lit.
StressSample exactly_on_the_cone(Random& random) {
  StressSample sample = ordinary(random, {0, 0, 0, 1}, {0, 0, 0, 1});
  Light& light = sample.state.lights[0];
  const float size = random.magnitude(-3, 3);
  switch (random.below(3)) {
    case 0:
      light.position_specified = {0, size, size, 1};
      light.spot_cutoff_degrees = 45;
      break;
    case 1:  // on the axis of a cone without width
      light.position_specified = {0, 0, size, 1};
      light.spot_cutoff_degrees = 0;
      break;
    default:  // beside a half space
      light.position_specified = {0, size, 0, 1};
      light.spot_cutoff_degrees = 90;
      break;
  }
  return sample;
}

StressSample light_opposite_to_the_eye(Random& random) {
  StressSample sample = ordinary(random, {0, 0, -1, 0}, away(random, 1, 1));
  if (random.coin()) {
    sample.state.lights[0].position_specified = {0, 0, -5, 1};
    sample.vertex.position_object = {0, 0, -3, 1};
    sample.state.light_model.local_viewer = random.coin();
  }
  return sample;
}

StressSample light_nearly_opposite_to_the_eye(Random& random) {
  const float off = random.magnitude(-3, -1);
  const auto d = random.unit_vector();
  StressSample sample = ordinary(random, {off * d[0], off * d[1], -1, 0}, away(random, 1, 1));
  return sample;
}

}  // namespace

std::span<const StressClass> light_classes() {
  static const StressClass classes[] = {
      {"directional position 1e-38 to 5e37", directional_of_any_length},
      {"light w of any sign, 1e-30 to 1e30", light_w},
      {"light w of any sign, light nearby", light_w_near},
      {"attenuation 0, 1e-42 to 3e38", attenuation},
      {"attenuation all zero", attenuation_zero},
      {"spot, any angle and cutoff", spot},
      {"spot direction 1e-44 to 3e38", spot_direction_of_any_length},
      {"spot direction zero", spot_direction_zero},
      {"cutoff 0, 0.001, 0.5, 89.99, 90, 180", cutoffs},
      {"beside the cone", beside_the_cone},
      {"exactly on the cone", exactly_on_the_cone, 0.5, true},
      {"light opposite to the eye", light_opposite_to_the_eye},
      {"light nearly opposite to the eye", light_nearly_opposite_to_the_eye},
  };
  return classes;
}

}  // namespace oracle
