#include "stress/stress_classes.hpp"

#include <vector>

namespace oracle {

std::array<float, 4> away(Random& random, float length, float w) {
  const auto d = random.unit_vector();
  return {length * d[0], length * d[1], length * d[2], w};
}

StressSample ordinary(Random& random, std::array<float, 4> light_position,
                      std::array<float, 4> vertex_position) {
  StressSample sample;
  State& s = sample.state;
  s.light_model.ambient = random.color(0.2f);
  s.front.ambient = random.color(0.5f);
  s.front.diffuse = random.color(0.5f, random.unit());
  s.front.specular = random.color(0.5f);
  s.front.emission = random.color(0.1f);
  s.front.shininess = 20;
  s.back = s.front;
  Light light;
  light.ambient = random.color(0.1f);
  light.position_specified = light_position;
  s.lights = {light};
  sample.vertex.position_object = vertex_position;
  sample.vertex.normal_object = random.unit_vector();
  return sample;
}

std::span<const StressClass> stress_classes() {
  static const std::vector<StressClass> classes = [] {
    std::vector<StressClass> all;
    for (const auto part : {geometry_classes(), light_classes(), material_classes()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return classes;
}

}  // namespace oracle
