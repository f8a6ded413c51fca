#pragma once
#include <array>

namespace legacy_gl {

/// Vertex attribute locations, fixed for all programs (GLES 3.0 promises 16).
enum AttributeLocation : unsigned {
  kLocationPosition = 0,
  kLocationNormal = 1,
  kLocationTexel = kLocationNormal,  ///< pixel rectangles have no normal
  kLocationColor = 2,
  kLocationSecondaryColor = 3,
  kLocationMaterial = 4,  ///< front ambient, diffuse, specular, emission, shininess, then back
  kLocationLightingPosition = kLocationMaterial + 10,
  kLocationDepthOffset,
  /// Polygon offset of unfilled polygons goes first where both are asked for.
  kLocationFogCoord = kLocationDepthOffset
};
inline constexpr unsigned kAttributeCount = kLocationDepthOffset + 1;

/// Names of the material attributes and of the properties, by [face][property].
inline constexpr std::array<std::array<const char*, 5>, 2> kMaterialAttributeNames{
    {{"front_ambient", "front_diffuse", "front_specular", "front_emission", "front_shininess"},
     {"back_ambient", "back_diffuse", "back_specular", "back_emission", "back_shininess"}}};

}  // namespace legacy_gl
