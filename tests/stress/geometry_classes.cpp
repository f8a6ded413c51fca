#include "stress/stress_classes.hpp"

namespace oracle {
namespace {

StressSample coordinates(Random& random) {
  const float size = random.magnitude(-30, 37.477f);
  StressSample sample = ordinary(random, away(random, size, 1), away(random, size, 1));
  sample.state.light_model.local_viewer = random.coin();
  return sample;
}

StressSample coordinates_attenuated(Random& random) {
  StressSample sample = coordinates(random);
  const float size = std::abs(sample.vertex.position_object[0]);
  Light& light = sample.state.lights[0];
  light.linear_attenuation = size > 0 ? std::fmin(1 / size, 1e37f) : 1;
  light.quadratic_attenuation =
      size > 0 ? float(std::fmin(1 / (double(size) * double(size)), 1e37)) : 1;
  return sample;
}

// The vertex at the origin, so that so small a difference of coordinates is representable.
StressSample light_near_vertex(Random& random) {
  return ordinary(random, away(random, random.magnitude(-30, -20), 1), {0, 0, 0, 1});
}

StressSample eye_near_vertex(Random& random) {
  StressSample sample = ordinary(random, away(random, 3, random.coin() ? 0.f : 1.f),
                                 away(random, random.magnitude(-30, -20), 1));
  sample.state.light_model.local_viewer = true;
  return sample;
}

StressSample normals(Random& random) {
  StressSample sample = ordinary(random, away(random, 3, 1), {0, 0, 0, 1});
  const bool longest = random.below(8) == 0;
  const float length = longest ? random.magnitude(38.2f, 38.47f) : random.magnitude(-44, 38.47f);
  for (float& c : sample.vertex.normal_object) c *= length;
  sample.state.normalize = true;
  // Half of them through a normal matrix.
  if (random.coin())
    sample.state.modelview =
        loaded(times(random.rotation(),
                     scale(double(random.uniform(0.5f, 2)), double(random.uniform(0.5f, 2)), 1)),
               {0, 0, 0});
  return sample;
}

StressSample normals_not_normalized(Random& random) {
  StressSample sample = normals(random);
  sample.state.modelview = identity_matrix;
  sample.state.normalize = false;
  return sample;
}

StressSample zero_normals(Random& random) {
  StressSample sample = normals(random);
  sample.vertex.normal_object = {0, 0, 0};
  return sample;
}

StressSample scaled(Random& random, float low_exponent, float high_exponent) {
  const double factor = double(random.magnitude(low_exponent, high_exponent));
  StressSample sample =
      ordinary(random, away(random, 3, random.coin() ? 0.f : 1.f), away(random, 1, 1));
  sample.state.modelview =
      loaded(times(random.rotation(), scale(factor, factor, factor)), {0, 0, -5});
  return sample;
}

StressSample scale_with_normalize(Random& random) {
  StressSample sample = scaled(random, -30, 30);
  sample.state.normalize = true;
  return sample;
}

StressSample scale_with_rescale(Random& random) {
  StressSample sample = scaled(random, -30, 30);
  sample.state.rescale_normal = true;
  return sample;
}

StressSample uneven_scale_with_normalize(Random& random) {
  StressSample sample = ordinary(random, away(random, 3, 0), away(random, 1, 1));
  sample.state.modelview =
      loaded(scale(double(random.magnitude(-15, 15)), double(random.magnitude(-15, 15)),
                   double(random.magnitude(-15, 15))),
             {0, 0, 0});
  sample.state.normalize = true;
  return sample;
}

// The third column is nearly a mixture of the other two.
StressSample nearly_singular_by(Random& random, float low_exponent, float high_exponent) {
  StressSample sample = ordinary(random, away(random, 3, 0), away(random, 1, 1));
  Mat3 m = random.rotation();
  const double a = double(random.uniform(-1, 1)), b = double(random.uniform(-1, 1));
  const double rest = double(random.magnitude(low_exponent, high_exponent));
  for (std::size_t row = 0; row < 3; ++row) {
    m[2][row] = a * m[0][row] + b * m[1][row] + rest * m[2][row];
  }
  sample.state.modelview = loaded(m, {0, 0, -5});
  sample.state.normalize = true;
  return sample;
}

StressSample nearly_singular(Random& random) { return nearly_singular_by(random, -3, 0); }
StressSample almost_singular(Random& random) { return nearly_singular_by(random, -6, -3); }

StressSample singular(Random& random) {
  StressSample sample = ordinary(random, away(random, 3, random.coin() ? 0.f : 1.f), {0, 0, 0, 1});
  Mat3 m = random.rotation();
  for (const std::size_t column : {random.below(3), random.below(3)}) m[column] = {0, 0, 0};
  sample.state.modelview = loaded(m, {0, 0, -5});
  sample.state.normalize = random.coin();
  sample.state.rescale_normal = random.coin();
  return sample;
}

StressSample homogeneous_vertex(Random& random) {
  const float w = random.magnitude(-20, 20) * (random.coin() ? 1.f : -1.f);
  StressSample sample =
      ordinary(random, away(random, 3, random.coin() ? 0.f : 1.f), away(random, std::abs(w), w));
  sample.state.light_model.local_viewer = random.coin();
  return sample;
}

// Under a light with a position: docs/deviations.md, row D17, has the directional ones.
StressSample vertex_at_infinity(Random& random) {
  StressSample sample =
      ordinary(random, away(random, 3, 1), away(random, random.magnitude(-20, 20), 0));
  sample.state.light_model.local_viewer = random.coin();
  return sample;
}

StressSample perspective_modelview(Random& random) {
  StressSample sample =
      ordinary(random, away(random, 3, random.coin() ? 0.f : 1.f), away(random, 1, 1));
  sample.state.modelview = loaded(random.rotation(), {0, 0, -3});
  for (const std::size_t i : {3U, 7U, 11U}) {
    sample.state.modelview[i] = double(random.uniform(-0.5f, 0.5f));
  }
  sample.state.light_model.local_viewer = random.coin();
  return sample;
}

// Object and light near each other, far from the eye, by one modelview.
template <int exponent>
StressSample far_translation(Random& random) {
  StressSample sample = ordinary(random, away(random, 3, 1), away(random, 1, 1));
  const float distance = random.magnitude(float(exponent), float(exponent));
  const auto d = random.unit_vector();
  sample.state.modelview =
      loaded(random.rotation(), {distance * d[0], distance * d[1], distance * d[2]});
  sample.state.lights[0].position_modelview = sample.state.modelview;
  sample.state.light_model.local_viewer = random.coin();
  return sample;
}

// The same with a scale that differs by axis: no object-space lighting.
template <int exponent>
StressSample far_translation_uneven(Random& random) {
  StressSample sample = far_translation<exponent>(random);
  const auto& m = sample.state.modelview;
  sample.state.modelview = loaded(times(random.rotation(), scale(double(random.uniform(0.5f, 2)),
                                                                 double(random.uniform(0.5f, 2)),
                                                                 double(random.uniform(0.5f, 2)))),
                                  {float(m[12]), float(m[13]), float(m[14])});
  sample.state.lights[0].position_modelview = sample.state.modelview;
  sample.state.normalize = true;
  return sample;
}

// Object coordinates that are themselves far away, and a modelview that brings them back.
template <int exponent>
StressSample far_object_coordinates(Random& random) {
  const float distance = random.magnitude(float(exponent), float(exponent));
  StressSample sample = ordinary(random, {0, 0, 0, 1}, {0, 0, 0, 1});
  const auto place = [&](const std::array<float, 4>& offset) {
    return std::array<float, 4>{distance + offset[0], distance + offset[1], offset[2] - distance,
                                1};
  };
  sample.vertex.position_object = place(away(random, 2, 1));
  sample.state.lights[0].position_specified = place(away(random, 5, 1));
  sample.state.modelview = loaded(random.rotation(), {0, 0, 0});
  sample.state.lights[0].position_modelview = sample.state.modelview;
  return sample;
}

StressSample denormals(Random& random) {
  StressSample sample = ordinary(random, away(random, 3, random.coin() ? 0.f : 1.f),
                                 away(random, random.magnitude(-44, -38), 1));
  const float length = random.magnitude(-44, -38);
  for (float& c : sample.vertex.normal_object) c *= length;
  sample.state.normalize = true;
  sample.state.front.emission = {random.magnitude(-44, -38), 0, 0, 1};
  return sample;
}

}  // namespace

std::span<const StressClass> geometry_classes() {
  static const StressClass classes[] = {
      {"coordinates 1e-30 to 3e37", coordinates},
      {"coordinates 1e-30 to 3e37, attenuated", coordinates_attenuated},
      {"light 1e-30 to 1e-20 from the vertex", light_near_vertex},
      {"eye 1e-30 to 1e-20 from the vertex", eye_near_vertex},
      {"normals 1e-44 to 3e38, normalized", normals},
      {"normals 1e-44 to 3e38", normals_not_normalized},
      {"zero normals", zero_normals},
      {"modelview scale 1e-30 to 1e30, normalize", scale_with_normalize},
      {"modelview scale 1e-30 to 1e30, rescale", scale_with_rescale},
      {"modelview scale 1e-15 to 1e15 by axis", uneven_scale_with_normalize},
      {"nearly singular modelview, 1e-3 to 1", nearly_singular},
      {"nearly singular modelview, 1e-6 to 1e-3", almost_singular},
      {"singular modelview", singular},
      {"vertex w of any sign, 1e-20 to 1e20", homogeneous_vertex},
      {"vertex w 0", vertex_at_infinity},
      {"perspective in the modelview", perspective_modelview},
      {"translation 1e5", far_translation<5>},
      {"translation 1e6", far_translation<6>, 0.1},
      {"translation 1e7", far_translation<7>, 0.1},
      {"translation 1e5, scale by axis", far_translation_uneven<5>},
      {"translation 1e7, scale by axis", far_translation_uneven<7>, 0.1},
      {"object and light at 1e5", far_object_coordinates<5>},
      {"object and light at 1e7", far_object_coordinates<7>, 0.1},
      {"denormal coordinates, normals and colours", denormals},
  };
  return classes;
}

}  // namespace oracle
