#include "oracle/lighting_classes.hpp"

#include <array>

#include "oracle/random.hpp"

namespace oracle {
namespace {

std::array<float, 3> in_front(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-8, -3)};
}

void place_vertices(Batch& batch, Random& random) {
  const float r = batch.object_radius;
  batch.vertices.resize(batch_size);
  for (int i = 0; i < batch_size; ++i) {
    Vertex& v = batch.vertices[std::size_t(i)];
    // Away from the cell's edges, where rounding could move it to its neighbour, and from its
    // middle, which a triangle with this vertex has to cover.
    const float column = float(i % batch_side) + random.uniform(0.2f, 0.45f);
    const float row = float(i / batch_side) + random.uniform(0.2f, 0.45f);
    v.position_object = {r * (column * (2.f / batch_side) - 1), r * (row * (2.f / batch_side) - 1),
                         r * random.uniform(-1, 1), 1};
    v.normal_object = random.unit_vector();
    v.color = random.color(1, random.unit());
  }
}

Material material(Random& random, float shininess) {
  Material m;
  m.ambient = random.color(0.5f);
  m.diffuse = random.color(0.9f, random.unit());
  m.specular = random.color(0.9f);
  m.emission = random.color(0.05f);
  m.shininess = shininess;
  return m;
}

Light directional(Random& random, float intensity = 1) {
  Light light;
  light.ambient = random.color(0.1f * intensity);
  light.diffuse = random.color(0.6f * intensity);
  light.specular = random.color(intensity);
  const auto d = random.unit_vector();
  light.position_specified = {d[0], d[1], d[2], 0};
  return light;
}

Light point(Random& random, float intensity = 1) {
  Light light = directional(random, intensity);
  light.position_specified = {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-9, 2),
                              1};
  return light;
}

void attenuate(Light& light, Random& random) {
  light.constant_attenuation = random.uniform(0.2f, 1);
  light.linear_attenuation = random.uniform(0, 0.3f);
  light.quadratic_attenuation = random.uniform(0, 0.1f);
}

// Aimed near the middle of the objects, so that most cones hit something.
void make_spot(Light& light, Random& random) {
  for (std::size_t c = 0; c < 3; ++c) {
    const float target = c == 2 ? -5.f : 0.f;
    light.spot_direction_specified[c] =
        target + random.uniform(-1, 1) - light.position_specified[c];
  }
  light.spot_cutoff_degrees = random.uniform(10, 90);
  light.spot_exponent = random.coin() ? float(random.below(129)) : random.uniform(0, 128);
}

// A rigid modelview, one material on both faces and one directional light.
Batch base(Random& random, float shininess) {
  Batch batch;
  State& s = batch.state;
  s.modelview = loaded(random.rotation(), in_front(random));
  s.light_model.ambient = random.color(0.3f);
  s.front = s.back = material(random, shininess);
  s.lights = {directional(random)};
  return batch;
}

Batch finish(Batch batch, Random& random) {
  place_vertices(batch, random);
  return batch;
}

Batch ambient_and_emission(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 0);
  batch.state.front.diffuse = batch.state.front.specular = {0, 0, 0, 1};
  return finish(batch, random);
}

Batch diffuse_directional(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 0);
  batch.state.front.specular = batch.state.back.specular = {0, 0, 0, 1};
  return finish(batch, random);
}

template <int shininess>
Batch specular_directional(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  return finish(base(random, shininess), random);
}

Batch specular_fractional(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  return finish(base(random, random.uniform(0.01f, 128)), random);
}

Batch point_light(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 50);
  batch.state.lights = {point(random)};
  return finish(batch, random);
}

Batch point_attenuated(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 50);
  batch.state.lights = {point(random)};
  attenuate(batch.state.lights[0], random);
  return finish(batch, random);
}

Batch spot(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 10);
  batch.state.lights = {point(random)};
  make_spot(batch.state.lights[0], random);
  return finish(batch, random);
}

Batch normalize_shear_scale(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 50);
  Mat3 shear = scale(1, 1, 1);
  shear[1][0] = double(random.uniform(-1, 1));
  shear[2][1] = double(random.uniform(-1, 1));
  const Mat3 stretch = scale(double(random.uniform(0.3f, 3)), double(random.uniform(0.3f, 3)),
                             double(random.uniform(0.3f, 3)));
  batch.state.modelview = loaded(times(random.rotation(), times(shear, stretch)), in_front(random));
  batch.state.normalize = true;
  return finish(batch, random);
}

Batch rescale(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 50);
  const double factor = double(random.uniform(0.1f, 10));
  batch.object_radius = float(1 / factor);
  batch.state.modelview =
      loaded(times(random.rotation(), scale(factor, factor, factor)), in_front(random));
  batch.state.rescale_normal = true;
  return finish(batch, random);
}

Batch local_viewer(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 50);
  batch.state.light_model.local_viewer = true;
  return finish(batch, random);
}

Batch two_sided(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 50);
  batch.state.light_model.two_side = true;
  batch.state.back = material(random, 128);
  batch.alternate_faces = true;
  return finish(batch, random);
}

Batch color_material(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 50);
  batch.state.color_material = {true, ColorMaterial::Face::front_and_back,
                                ColorMaterial::Mode(random.below(5))};
  return finish(batch, random);
}

Batch separate_specular(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 50);
  batch.state.light_model.separate_specular_color = true;
  return finish(batch, random);
}

Batch long_normals(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = finish(base(random, 10), random);
  for (Vertex& v : batch.vertices) {
    const float length = random.uniform(0.5f, 1.1f);
    for (float& c : v.normal_object) c *= length;
  }
  return batch;
}

Batch shininess_zero(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  return finish(base(random, 0), random);
}

Batch local_viewer_spot_attenuated(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 50);
  batch.state.light_model.local_viewer = true;
  batch.state.lights = {point(random)};
  attenuate(batch.state.lights[0], random);
  make_spot(batch.state.lights[0], random);
  return finish(batch, random);
}

Batch unnormalized_scale(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  Batch batch = base(random, 10);
  const Mat3 stretch = scale(double(random.uniform(0.9f, 2)), double(random.uniform(0.9f, 2)),
                             double(random.uniform(0.9f, 2)));
  batch.state.modelview = loaded(times(random.rotation(), stretch), in_front(random));
  return finish(batch, random);
}

Batch eight_lights(std::uint32_t seed, std::uint32_t number) {
  Random random(seed, number);
  // What chooses a program variant takes 16 combinations only: compiling is not what is measured.
  const std::uint32_t kind = number % 16;
  constexpr std::array<float, 8> shininess{1, 128, 10, 50, 27, 3, 96, 65};
  Batch batch = base(random, shininess[kind % 8]);
  State& s = batch.state;
  s.lights.clear();
  s.light_model.local_viewer = (kind & 1) != 0;
  s.light_model.separate_specular_color = (kind & 2) != 0;
  s.light_model.two_side = (kind & 4) != 0;
  s.normalize = (kind & 8) != 0;
  batch.alternate_faces = s.light_model.two_side;
  s.back = material(random, shininess[(kind + 3) % 8]);
  s.color_material = {kind % 3 == 0, ColorMaterial::Face::front_and_back,
                      ColorMaterial::Mode::ambient_and_diffuse};
  for (int i = 0; i < 8; ++i) {
    Light light = i % 2 == 0 ? directional(random, 0.15f) : point(random, 0.15f);
    if (i % 4 == 3) attenuate(light, random);
    if (i % 4 == 1) make_spot(light, random);
    s.lights.push_back(light);
  }
  return finish(batch, random);
}

constexpr std::size_t class_count = 20;

}  // namespace

std::span<const LightingClass> lighting_classes() {
  static const std::array<LightingClass, class_count> classes{{
      {"ambient and emission", ambient_and_emission},
      {"diffuse, directional", diffuse_directional},
      {"specular, shininess 10", specular_directional<10>},
      {"specular, shininess 50", specular_directional<50>},
      {"specular, shininess 128", specular_directional<128>},
      {"specular, fractional shininess", specular_fractional},
      {"shininess 0", shininess_zero},
      {"point", point_light},
      {"point, attenuated", point_attenuated},
      {"spot, any exponent", spot},
      {"normalize, shear and scale", normalize_shear_scale},
      {"rescale", rescale},
      {"local viewer", local_viewer},
      {"two-sided", two_sided},
      {"colour material", color_material},
      {"separate specular", separate_specular},
      {"normals of any length", long_normals},
      {"scale without normalize", unnormalized_scale},
      {"local viewer, spot, attenuated", local_viewer_spot_attenuated},
      {"eight lights, everything mixed", eight_lights},
  }};
  return classes;
}

}  // namespace oracle
