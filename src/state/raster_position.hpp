#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace legacy_gl {

inline constexpr unsigned kMaxTextureUnits = 8;

using RasterTextureCoordinates = std::array<glm::vec4, kMaxTextureUnits>;

inline constexpr RasterTextureCoordinates kInitialTextureCoordinates = [] {
  RasterTextureCoordinates coordinates{};
  coordinates.fill(glm::vec4(0, 0, 0, 1));
  return coordinates;
}();

/// The current raster position and what it took from the current values when it was set (GL 2.1
/// spec 2.13, table 6.7).
struct RasterPosition {
  glm::vec4 position{0, 0, 0, 1};  ///< window coordinates; w: of the clip coordinates
  bool valid = true;
  float distance = 0;
  glm::vec4 color{1, 1, 1, 1};
  glm::vec3 secondary_color{0, 0, 0};
  float index = 1;
  RasterTextureCoordinates texture_coordinates = kInitialTextureCoordinates;
};

}  // namespace legacy_gl
