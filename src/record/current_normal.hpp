#pragma once
#include "context/context.hpp"
#include "geometry/tiny_normals.hpp"

namespace legacy_gl {

/// The current normal as the driver is to get it.
inline glm::vec3 normal_to_draw(const Context& context) {
  const glm::vec3 normal = context.current.normal;
  return context.transform.normalize_enabled ? enlarged_if_tiny(normal) : normal;
}

}  // namespace legacy_gl
