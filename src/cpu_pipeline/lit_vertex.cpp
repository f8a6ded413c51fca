#include "cpu_pipeline/lit_vertex.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "context/context.hpp"
#include "matrix/lighting_space.hpp"

namespace legacy_gl {

namespace {

/// Row D8: what has no direction adds nothing.
glm::dvec3 unit(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : glm::dvec3(0);
}

glm::dvec3 from_homogeneous(const glm::dvec4& v) {
  return v.w != 0 ? glm::dvec3(v) / v.w : glm::dvec3(v);
}

double power(double base, double exponent) { return exponent == 0 ? 1 : std::pow(base, exponent); }

/// "att" times "spot".
double strength(const Light& light, const glm::dvec3& from_light, double distance) {
  double factor = 1;
  if (light.position_eye.w != 0)
    factor = 1 / (static_cast<double>(light.constant_attenuation) +
                  static_cast<double>(light.linear_attenuation) * distance +
                  static_cast<double>(light.quadratic_attenuation) * distance * distance);
  if (!std::isfinite(factor)) factor = 0;
  if (light.spot_cutoff_degrees == 180) return factor;
  const double cosine = std::max(glm::dot(from_light, unit(light.spot_direction_eye)), 0.0);
  const double limit =
      std::cos(static_cast<double>(light.spot_cutoff_degrees) * std::numbers::pi / 180);
  return cosine < limit ? 0 : factor * power(cosine, static_cast<double>(light.spot_exponent));
}

glm::dvec3 rgb(const glm::vec4& color) { return {color.r, color.g, color.b}; }

}  // namespace

glm::dvec3 eye_normal(const Context& context, const glm::vec3& normal) {
  const LinearPart linear = analyse(glm::dmat3(context.transform.modelview.top().exact));
  glm::dvec3 n = linear.inverse_transpose * glm::dvec3(normal);
  if (context.transform.normalize_enabled) n = unit(n);
  else if (context.transform.rescale_normal_enabled) n *= linear.rescale_factor;
  return n;
}

LitColor light_vertex(const Context& context, const Materials& materials, const glm::vec4& position,
                      const glm::vec3& normal, unsigned face) {
  const LightingState& lighting = context.lighting;
  const Material& material = materials[face];
  const glm::dvec4 eye = context.transform.modelview.top().exact * glm::dvec4(position);
  const glm::dvec3 vertex = from_homogeneous(eye);
  const glm::dvec3 n = eye_normal(context, normal) * (face == kBack ? -1.0 : 1.0);
  const glm::dvec3 to_viewer = lighting.model.local_viewer ? unit(-vertex) : glm::dvec3(0, 0, 1);

  glm::dvec3 primary = rgb(material.emission) + rgb(lighting.model.ambient) * rgb(material.ambient);
  glm::dvec3 specular(0);
  for (const Light& light : lighting.lights) {
    if (!light.enabled) continue;
    const bool directional = light.position_eye.w == 0;
    const glm::dvec3 toward = directional ? glm::dvec3(light.position_eye)
                                          : from_homogeneous(light.position_eye) - vertex;
    const glm::dvec3 to_light = unit(toward);
    const double factor = strength(light, -to_light, glm::length(toward));
    const double diffuse = std::max(glm::dot(n, to_light), 0.0);
    primary += factor * (rgb(material.ambient) * rgb(light.ambient) +
                         diffuse * rgb(material.diffuse) * rgb(light.diffuse));
    if (diffuse > 0) {
      const double highlight = std::max(glm::dot(n, unit(to_light + to_viewer)), 0.0);
      specular += factor * power(highlight, static_cast<double>(material.shininess)) *
                  rgb(material.specular) * rgb(light.specular);
    }
  }
  const bool separate = lighting.model.color_control == GL_SEPARATE_SPECULAR_COLOR;
  if (!separate) primary += specular;
  const auto clamped = [](const glm::dvec3& v) { return glm::vec3(glm::clamp(v, 0.0, 1.0)); };
  return {glm::vec4(clamped(primary), std::clamp(material.diffuse.a, 0.0f, 1.0f)),
          separate ? clamped(specular) : glm::vec3(0)};
}

}  // namespace legacy_gl
