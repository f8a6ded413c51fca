#pragma once
#include <vector>

#include "lighting/light.hpp"
#include "lighting/light_model.hpp"
#include "lighting/material.hpp"

namespace legacy_gl {

/// The lighting group (GL 2.1 spec table 6.9, 6.10): what GL_LIGHTING_BIT pushes.
struct LightingState {
  explicit LightingState(unsigned max_lights = 8) {
    lights.reserve(max_lights);
    for (unsigned i = 0; i < max_lights; ++i) lights.push_back(default_light(i));
  }

  bool enabled = false;
  std::vector<Light> lights;
  LightModel model;
  Materials materials;
  ColorMaterial color_material;
  GLenum shade_model = GL_SMOOTH;
};

}  // namespace legacy_gl
