#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace legacy_gl {

/// One light source (GL 2.1 spec 2.14.1, table 2.11). Positions and directions are in eye
/// coordinates: they went through the modelview when they were specified.
struct Light {
  glm::vec4 ambient{0, 0, 0, 1};
  glm::vec4 diffuse{0, 0, 0, 1};   ///< light 0: white
  glm::vec4 specular{0, 0, 0, 1};  ///< light 0: white
  glm::dvec4 position_eye{0, 0, 1, 0};
  glm::dvec3 spot_direction_eye{0, 0, -1};
  float spot_exponent = 0;
  float spot_cutoff_degrees = 180;
  float constant_attenuation = 1, linear_attenuation = 0, quadratic_attenuation = 0;
  bool enabled = false;
  bool operator==(const Light&) const = default;
};

/// Table 2.11 gives light 0 a white diffuse and specular intensity, and the others black ones.
inline Light default_light(unsigned index) {
  Light light;
  if (index == 0) light.diffuse = light.specular = glm::vec4(1);
  return light;
}

}  // namespace legacy_gl
