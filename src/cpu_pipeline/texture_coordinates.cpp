#include "cpu_pipeline/texture_coordinates.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "context/context.hpp"
#include "cpu_pipeline/lit_vertex.hpp"

namespace legacy_gl {

namespace {

/// GL 2.1 spec 2.11.4: "r" of a sphere and a reflection map.
glm::dvec3 reflection(const glm::dvec4& eye, const glm::dvec3& normal) {
  const double length = glm::length(glm::dvec3(eye));
  const glm::dvec3 to_vertex = length > 0 ? glm::dvec3(eye) / length : glm::dvec3(0);
  return to_vertex - 2.0 * glm::dot(normal, to_vertex) * normal;
}

double sphere(const glm::dvec3& reflected, int component) {
  const double m = 2 * glm::length(reflected + glm::dvec3(0, 0, 1));
  return m > 0 ? reflected[component] / m + 0.5 : 0.5;
}

}  // namespace

glm::vec4 transformed_texture_coordinates(const Context& context, unsigned unit,
                                          const glm::vec4& position, const glm::vec3& normal,
                                          const glm::vec4& given) {
  const TexgenState& texgen = context.texture.units[unit].texgen;
  glm::vec4 coordinates = given;
  const glm::dvec4 eye = context.transform.modelview.top().exact * glm::dvec4(position);
  for (int i = 0; i < 4; ++i) {
    const TexgenCoordinate& coordinate = texgen.coordinates[static_cast<std::size_t>(i)];
    if (!coordinate.enabled) continue;
    const auto generated = [&]() -> double {
      switch (coordinate.mode) {
        case GL_OBJECT_LINEAR:
          return static_cast<double>(glm::dot(coordinate.object_plane, position));
        case GL_EYE_LINEAR: return glm::dot(coordinate.eye_plane, eye);
        case GL_SPHERE_MAP: return sphere(reflection(eye, eye_normal(context, normal)), i);
        case GL_REFLECTION_MAP: return reflection(eye, eye_normal(context, normal))[i];
        default: return eye_normal(context, normal)[i];
      }
    };
    coordinates[i] = static_cast<float>(generated());
  }
  return context.transform.texture[unit].top().single * coordinates;
}

}  // namespace legacy_gl
