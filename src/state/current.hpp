#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "state/gl_types.hpp"
#include "state/raster_position.hpp"

namespace legacy_gl {

/// Current values (GL 2.1 spec 2.7, table 6.6): what the next vertex takes.
struct CurrentValues {
  glm::vec4 color{1, 1, 1, 1};
  glm::vec3 normal{0, 0, 1};
  glm::vec4 secondary_color{0, 0, 0, 1};
  float fog_coordinate = 0;
  float index = 1;
  bool edge_flag = true;
  std::array<glm::vec4, kMaxTextureUnits> texture_coordinates = kInitialTextureCoordinates;
  RasterPosition raster;
};

}  // namespace legacy_gl
