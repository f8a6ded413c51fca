// The values of the light, material and general blocks.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>

#include "translate/draw_inputs_parts.hpp"

namespace legacy_gl {

namespace {

/// A unit of distance in which the coefficients of attenuation are within float32's range: a power
/// of two, and 1 where they are so anyhow.
double attenuation_unit(double k1, double k2) {
  const auto ordinary = [](double k) { return k == 0 || (k > 1e-30 && k < 1e30); };
  if (ordinary(k1) && ordinary(k2)) return 1;
  const double size = k2 > 0 ? 1 / std::sqrt(k2) : 1 / k1;
  return std::exp2(std::clamp(std::round(std::log2(size)), -120.0, 120.0));
}

/// In multiples of 1/2048, where such steps are not lost on so long a vector.
glm::dvec3 coarse(const glm::dvec3& v) {
  return glm::all(glm::lessThan(glm::abs(v), glm::dvec3(4))) ? glm::floor(v * 2048.0) / 2048.0
                                                             : glm::dvec3(finite(v, 0));
}

constexpr double kBelowOne = 1 - 0x1p-24;  // the largest float below 1

}  // namespace

void DrawInputs::find_eye_directions(const Context& context) {
  const std::vector<Light>& all = context.lighting.lights;
  eye_directions_.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!is_directional(all[i])) continue;
    const glm::dvec3 to_light = unit(glm::dvec3(all[i].position_eye));
    eye_directions_[i] = {to_light, unit(to_light + glm::dvec3(0, 0, 1))};
  }
}

DrawInputs::LightAxes DrawInputs::light_axes(const Context& context) const {
  const bool in_object_space = key.space == LightingSpace::kObject;
  LightAxes axes;
  if (in_object_space) {
    axes.scale = linear_.scale;
    axes.rotation = linear_.inverse * linear_.scale;
  }
  // Vectors that meet the normal as it is given.
  double factor = context.transform.rescale_normal_enabled ? linear_.rescale_factor : 1.0;
  if (context.transform.normalize_enabled) factor = linear_.scale;
  axes.covariant = directions_only_ ? linear_.inverse * factor : axes.rotation;
  if (key.space != LightingSpace::kEyeHomogeneous)
    axes.origin = glm::dvec3(modelview(context).exact[3]);
  return axes;
}

/// A directional light: the vector to it, and its half vector where the viewer is infinite.
void DrawInputs::fill_direction(unsigned index, const LightAxes& axes, LightUniforms& uniforms,
                                LightLow& low_part) const {
  const glm::dvec3 direction = axes.covariant * eye_directions_[index].to_light;
  const bool split = key.quality == Quality::kPrecise;
  uniforms.position = finite(split ? coarse(direction) : direction, 0);
  low_part.position = rest_of(glm::dvec4(direction, 0), uniforms.position);
  // A normal made unit length in object space meets a half vector that is so too.
  glm::dvec3 half_vector = axes.covariant * eye_directions_[index].half_vector;
  if (key.normal == NormalMode::kNormalize ||
      (key.quality == Quality::kDefault && !splits_half_vectors(key)))
    half_vector = unit(half_vector);
  uniforms.half_vector = finite(splits_half_vectors(key) ? coarse(half_vector) : half_vector, 0);
  uniforms.attenuation = finite(half_vector - glm::dvec3(uniforms.half_vector), 0);
}

/// A point light: where it is, and its attenuation.
void DrawInputs::fill_point(const Light& light, const LightAxes& axes, LightUniforms& uniforms,
                            LightLow& low_part) {
  const glm::dvec3 position(light.position_eye);
  const glm::dvec3 point =
      axes.rotation * (position / light.position_eye.w - axes.origin) / axes.scale;
  uniforms.position = finite(point, 1);
  low_part.position = low(point, 1);
  const double k0 = static_cast<double>(light.constant_attenuation);
  const double k1 = static_cast<double>(light.linear_attenuation) * axes.scale;
  const double k2 = static_cast<double>(light.quadratic_attenuation) * axes.scale * axes.scale;
  const double unit_of_distance = attenuation_unit(k1, k2);
  uniforms.half_vector.w = static_cast<float>(1 / unit_of_distance);
  uniforms.attenuation =
      finite(glm::dvec3(k0, k1 * unit_of_distance, k2 * unit_of_distance * unit_of_distance),
             static_cast<double>(light.spot_exponent));
  // A light whose constant attenuation is folded meets the widest kind with attenuation 1.
  if (k1 == 0 && k2 == 0) uniforms.attenuation = {1, 0, 0, light.spot_exponent};
  fill_spot(light, axes, uniforms, low_part);
}

void DrawInputs::fill_spot(const Light& light, const LightAxes& axes, LightUniforms& uniforms,
                           LightLow& low_part) {
  if (is_spot(light)) {
    const double half_cutoff =
        static_cast<double>(light.spot_cutoff_degrees) * (std::numbers::pi / 360);
    // Vertices on the cone are lit: the bound leaves room for the rounding of the chord, and
    // for that of two unit vectors that are opposite.
    double limit = std::max(2 * std::sin(half_cutoff) * std::sin(half_cutoff) * (1 + 3e-7), 1e-13);
    // Where the cosine is 0 its power is too, and has no logarithm.
    if (light.spot_exponent > 0) limit = std::min(limit, kBelowOne);
    const glm::dvec3 axis = axes.rotation * unit(light.spot_direction_eye);
    uniforms.spot_direction = finite(axis, limit);
    low_part.spot_direction = low(axis, limit);
  } else {
    uniforms.spot_direction = {0, 0, 0, 4};
    uniforms.attenuation.w = 0;
  }
}

void DrawInputs::fill_lights(const Context& context) {
  stale[kLightsBlock] = true;
  stale[kPreciseBlock] = true;
  lights.clear();
  lights_low.clear();
  const LightAxes axes = light_axes(context);
  for (const ActiveLight& active : active_) {
    if (!(active.kind & (kLightAmbient | kLightDiffuse | kLightSpecular))) continue;
    const Light& light = context.lighting.lights[active.index];
    LightUniforms uniforms;
    LightLow low_part;
    if (is_directional(light)) fill_direction(active.index, axes, uniforms, low_part);
    else fill_point(light, axes, uniforms, low_part);
    lights.push_back(uniforms);
    if (key.quality == Quality::kPrecise) lights_low.push_back(low_part);
  }
}

void DrawInputs::fill_faces(const Context& context) {
  for (unsigned face = 0; face < face_count(key); ++face) {
    stale[kFrontBlock + face] = true;
    FaceUniforms& uniforms = faces[face];
    uniforms.products.clear();
    glm::dvec3 ambient_light = rgb(context.lighting.model.ambient);
    for (const ActiveLight& active : active_) {
      const Light& light = context.lighting.lights[active.index];
      if (active.black) {
        uniforms.products.emplace_back();
        uniforms.products.back().diffuse.w = static_cast<float>(sum_scale_);
        continue;
      }
      if (folds_into_scene(active.kind)) ambient_light += rgb(light.ambient) * active.strength;
      if (!(active.kind & (kLightAmbient | kLightDiffuse | kLightSpecular))) continue;
      const auto product = [&](unsigned property, const glm::vec4& color, double factor) {
        return rgb(color) * uniform_material(context, key, face, property) * active.strength *
               (factor / sum_scale_);
      };
      const double shine_of_length =
          normal_length_ == 1
              ? 1
              : std::pow(normal_length_,
                         static_cast<double>(context.lighting.materials[face].shininess));
      const glm::dvec3 diffuse = product(kDiffuse, light.diffuse, normal_length_);
      glm::vec4 ambient(0);
      if (active.kind & kLightAmbient) ambient = finite(product(kAmbient, light.ambient, 1), 0);
      else if (key.quality == Quality::kPrecise) ambient = low(diffuse, 0);
      uniforms.products.push_back({ambient, finite(diffuse, sum_scale_),
                                   finite(product(kSpecular, light.specular, shine_of_length), 0)});
    }
    const Material& material = context.lighting.materials[face];
    glm::dvec3 scene(0);
    if (key.material[face][kAmbient] == MaterialSource::kUniform)
      scene += ambient_light * rgb(material.ambient);
    if (key.material[face][kEmission] == MaterialSource::kUniform) scene += rgb(material.emission);
    uniforms.head.scene =
        finite(scene / sum_scale_, std::clamp(static_cast<double>(material.diffuse.a), 0.0, 1.0));
    uniforms.head.ambient_light = finite(ambient_light, static_cast<double>(material.shininess));
  }
}

/// From the values of the other blocks, which are filled.
void DrawInputs::fill_general(const Context& context) {
  general = {};
  if (key.space != LightingSpace::kObject) general.lighting_matrix = transform.modelview;
  if (key.space == LightingSpace::kEyeAxes) general.lighting_matrix[3] = {0, 0, 0, 1};
  const bool by_matrix =
      key.normal == NormalMode::kMatrix ||
      (key.normal == NormalMode::kNormalize && key.space != LightingSpace::kObject);
  const float scale = key.normal == NormalMode::kScaled ? transform.viewer.w : 1.0f;
  for (unsigned i = 0; i < 3; ++i) {
    general.normal_matrix[i][static_cast<int>(i)] = scale;
    if (by_matrix) general.normal_matrix[i] = transform.normal_matrix[i];
  }
  for (const ActiveLight& active : active_) {
    if (!(active.kind & (kLightAmbient | kLightDiffuse | kLightSpecular))) continue;
    ++general.light_ends.z;
    if (!(active.kind & kLightPoint)) ++general.light_ends.x;
    if (!(active.kind & kLightSpot)) ++general.light_ends.y;
  }
  general.modes = {key.normal == NormalMode::kNormalize, context.lighting.model.local_viewer, 0, 0};
}

}  // namespace legacy_gl
