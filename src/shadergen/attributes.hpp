#pragma once
#include <array>
#include <bit>

namespace legacy_gl {

/// Vertex attribute locations, fixed for all programs (GLES 3.0 promises 16).
enum AttributeLocation : unsigned {
  kLocationPosition = 0,
  kLocationNormal = 1,
  kLocationTexel = kLocationNormal,  ///< pixel rectangles have no normal
  kLocationColor = 2,
  kLocationSecondaryColor = 3,
  kLocationLightingPosition = 4,
  kLocationPixelPlace = kLocationLightingPosition,  ///< of pixel rectangles
  kLocationDepthOffset = 5,
  /// Offsets of polygons and of wide lines go first where both are asked for.
  kLocationLineOffset = kLocationDepthOffset,
  kLocationFogCoord = kLocationDepthOffset,
  /// From here on: the material properties that come with the vertices, one after the other.
  kLocationMaterial = 6,
  /// From here down: the texture coordinates, unit by unit.
  kLocationTexcoord = 15
};
inline constexpr unsigned kAttributeCount = 16;

/// The location of material property `index` (face * 5 + property) where those of `present` come
/// with the vertices.
constexpr unsigned material_location(unsigned present, unsigned index) {
  return kLocationMaterial + static_cast<unsigned>(std::popcount(present & ((1u << index) - 1)));
}
/// Whether there is a location left for the unit's coordinates.
constexpr bool has_texcoord_location(unsigned materials_present, unsigned unit) {
  return kLocationTexcoord - unit >=
         kLocationMaterial + static_cast<unsigned>(std::popcount(materials_present));
}
constexpr unsigned texcoord_location(unsigned unit) { return kLocationTexcoord - unit; }

/// Names of the material attributes and of the properties, by [face][property].
inline constexpr std::array<std::array<const char*, 5>, 2> kMaterialAttributeNames{
    {{"front_ambient", "front_diffuse", "front_specular", "front_emission", "front_shininess"},
     {"back_ambient", "back_diffuse", "back_specular", "back_emission", "back_shininess"}}};

}  // namespace legacy_gl
