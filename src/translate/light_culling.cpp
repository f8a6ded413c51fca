#include "translate/light_culling.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "translate/draw_inputs_parts.hpp"

namespace legacy_gl {

namespace {

constexpr unsigned kFewLights = 8;
constexpr double kInvisible = 1.0 / (1024 * 255);
/// Room for the rounding of float32 in radii and cosines.
constexpr double kMargin = 1e-4;

double largest(const glm::vec4& color) { return largest_component(rgb(color)); }

/// The sphere around a draw, in eye coordinates, and the most that its surface makes of light.
struct LitSurface {
  glm::dvec3 center;
  double radius;
  double ambient = 0, diffuse = 0, specular = 0;
};

double length_of_normals(const Context& context, const LinearPart& linear,
                         const DrawBounds& bounds) {
  if (context.transform.normalize_enabled) return 1;
  const auto given = static_cast<double>(bounds.longest_normal);
  const double rescale = context.transform.rescale_normal_enabled ? linear.rescale_factor : 1;
  if (linear.keeps_angles) return given * rescale / linear.scale;
  double squares = 0;
  for (int column = 0; column < 3; ++column)
    squares += glm::dot(linear.inverse_transpose[column], linear.inverse_transpose[column]);
  return given * rescale * std::sqrt(squares);
}

/// The largest component of a property, of either face.
double material_size(const Context& context, const VertexLayout& layout, const DrawBounds& bounds,
                     unsigned property) {
  const ColorMaterial& tracking = context.lighting.color_material;
  const MaterialMask tracked =
      tracking.enabled ? material_mask(tracking.face, tracking.mode) : MaterialMask{0};
  double size = 0;
  for (unsigned face = 0; face < 2; ++face) {
    const MaterialMask bit = material_bit(face, property);
    if (tracked & bit) size = std::max(size, static_cast<double>(bounds.largest_color));
    else if (layout.materials & bit) return std::numeric_limits<double>::infinity();
    else size = std::max(size, largest(material_value(context.lighting.materials, face, property)));
  }
  return size;
}

LitSurface surface_of(const Context& context, const glm::dmat4& modelview, const LinearPart& linear,
                      const VertexLayout& layout, const DrawBounds& bounds) {
  const glm::dvec3 lowest(bounds.lowest), highest(bounds.highest);
  const glm::dvec3 middle = (lowest + highest) / 2.0, half = (highest - lowest) / 2.0;
  LitSurface surface;
  surface.center = glm::dvec3(modelview * glm::dvec4(middle, 1));
  const glm::dvec3 reach = glm::abs(glm::dvec3(modelview[0])) * half.x +
                           glm::abs(glm::dvec3(modelview[1])) * half.y +
                           glm::abs(glm::dvec3(modelview[2])) * half.z;
  surface.radius = glm::length(reach) * (1 + kMargin);
  const double normal = length_of_normals(context, linear, bounds);
  const MaterialMask shininess =
      static_cast<MaterialMask>(material_bit(kFront, kShininess) | material_bit(kBack, kShininess));
  double power = std::max(context.lighting.materials[kFront].shininess,
                          context.lighting.materials[kBack].shininess);
  if (layout.materials & shininess) power = 128;
  surface.ambient = material_size(context, layout, bounds, kAmbient);
  surface.diffuse = material_size(context, layout, bounds, kDiffuse) * normal;
  surface.specular = material_size(context, layout, bounds, kSpecular) *
                     std::pow(std::max(normal, 1.0) * (1 + 1e-6), power);
  return surface;
}

/// The cosine of the smallest angle between the cone's axis and the direction to a point of the
/// sphere; 1 when the axis meets the sphere.
double nearest_cosine(const Light& light, const glm::dvec3& to_center, double distance,
                      double radius) {
  if (!(distance > radius)) return 1;
  const glm::dvec3 axis(light.spot_direction_eye);
  const double cosine =
      std::clamp(glm::dot(to_center, axis) / (distance * glm::length(axis)), -1.0, 1.0);
  const double sine_of_radius = radius / distance;
  const double cosine_of_radius = std::sqrt(1 - sine_of_radius * sine_of_radius);
  if (!(cosine < cosine_of_radius)) return 1;  // also where the axis is none
  return cosine * cosine_of_radius + std::sqrt(1 - cosine * cosine) * sine_of_radius;
}

bool reaches(const Light& light, const LitSurface& surface) {
  const bool spot = is_spot(light);
  const bool attenuated = light.linear_attenuation != 0 || light.quadratic_attenuation != 0;
  if (is_directional(light) || !(spot || attenuated)) return true;
  const glm::dvec3 position =
      glm::dvec3(light.position_eye) / static_cast<double>(light.position_eye.w);
  const glm::dvec3 to_center = surface.center - position;
  const double distance = glm::length(to_center);
  const double nearest = std::max(distance * (1 - kMargin) - surface.radius, 0.0);
  const double attenuation =
      1 / (static_cast<double>(light.constant_attenuation) +
           static_cast<double>(light.linear_attenuation) * nearest +
           static_cast<double>(light.quadratic_attenuation) * nearest * nearest);
  const double unshaded = largest(light.ambient) * surface.ambient +
                          largest(light.diffuse) * surface.diffuse +
                          largest(light.specular) * surface.specular;
  // Not ">=": what is not a number reaches.
  if (attenuation * unshaded < kInvisible) return false;
  if (!spot) return true;
  const double cosine = nearest_cosine(light, to_center, distance, surface.radius);
  const double cutoff = static_cast<double>(light.spot_cutoff_degrees) * (std::numbers::pi / 180);
  if (cosine + kMargin < std::cos(cutoff)) return false;
  if (light.spot_exponent == 0) return true;
  const double factor =
      std::pow(std::clamp(cosine + kMargin, 0.0, 1.0), static_cast<double>(light.spot_exponent));
  return !(attenuation * unshaded * factor < kInvisible);
}

float longest(const float* normal, float so_far) {
  const glm::vec3 n(normal[0], normal[1], normal[2]);
  return std::max(so_far, glm::length(n) * (1 + 1e-6f));
}

float largest(const float* color, float so_far) {
  return std::max({so_far, std::abs(color[0]), std::abs(color[1]), std::abs(color[2])});
}

}  // namespace

bool culls_lights(const Context& context) {
  const std::vector<Light>& lights = context.lighting.lights;
  if (!context.paths.light_culling || lights.size() <= kFewLights || !context.lighting.enabled ||
      context.options.quality == LEGACY_GL_QUALITY_PRECISE)
    return false;
  unsigned enabled = 0;
  for (const Light& light : lights) enabled += light.enabled;
  return enabled > kFewLights;
}

bool find_bounds(const Context& context, const VertexLayout& layout, const float* vertices,
                 std::uint32_t count, DrawBounds& bounds) {
  const VertexOffsets offsets = offsets_of(layout);
  if (offsets.position_size != 3 || count == 0) return false;
  bounds.longest_normal = longest(&context.current.normal[0], 0);
  bounds.largest_color = largest(&context.current.color[0], 0);
  const float* vertex = vertices;
  bounds.lowest = bounds.highest = {vertex[0], vertex[1], vertex[2]};
  for (std::uint32_t i = 0; i < count; ++i, vertex += offsets.stride) {
    const glm::vec3 position(vertex[0], vertex[1], vertex[2]);
    bounds.lowest = glm::min(bounds.lowest, position);
    bounds.highest = glm::max(bounds.highest, position);
    if (layout.fields & kFieldNormal)
      bounds.longest_normal = longest(vertex + offsets.normal, bounds.longest_normal);
    if (layout.fields & kFieldColor)
      bounds.largest_color = largest(vertex + offsets.color, bounds.largest_color);
  }
  return true;
}

DrawBounds bounds_of(const Context& context, const ListMesh& mesh) {
  DrawBounds bounds{mesh.lowest, mesh.highest, mesh.longest_normal, mesh.largest_color};
  if (!(mesh.layout.fields & kFieldNormal))
    bounds.longest_normal = longest(&context.current.normal[0], 0);
  if (!(mesh.layout.fields & kFieldColor))
    bounds.largest_color = largest(&context.current.color[0], 0);
  return bounds;
}

LightMask reached_lights(const Context& context, const glm::dmat4& modelview,
                         const LinearPart& linear, const VertexLayout& layout,
                         const DrawBounds& bounds) {
  const LitSurface surface = surface_of(context, modelview, linear, layout, bounds);
  LightMask reached;
  const std::vector<Light>& lights = context.lighting.lights;
  for (std::size_t i = 0; i < lights.size(); ++i)
    if (lights[i].enabled) reached[i] = reaches(lights[i], surface);
  return reached;
}

}  // namespace legacy_gl
