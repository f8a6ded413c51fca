#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// One face's material (GL 2.1 spec 2.14.1, table 2.11).
struct Material {
  glm::vec4 ambient{0.2f, 0.2f, 0.2f, 1};
  glm::vec4 diffuse{0.8f, 0.8f, 0.8f, 1};
  glm::vec4 specular{0, 0, 0, 1};
  glm::vec4 emission{0, 0, 0, 1};
  float shininess = 0;
  glm::vec3 color_indexes{0, 1, 1};
  bool operator==(const Material&) const = default;
};

enum Face : unsigned { kFront = 0, kBack = 1 };

/// One bit for each material property of each face, front first: what glMaterial set, what colour
/// material tracks, what a batch carries per vertex.
enum MaterialProperty : unsigned {
  kAmbient,
  kDiffuse,
  kSpecular,
  kEmission,
  kShininess,
  kPropertyCount
};

using MaterialMask = std::uint16_t;

constexpr MaterialMask material_bit(unsigned face, unsigned property) {
  return static_cast<MaterialMask>(1u << (face * kPropertyCount + property));
}

inline constexpr MaterialMask kFrontMaterialMask = (1u << kPropertyCount) - 1u;
inline constexpr MaterialMask kBackMaterialMask = kFrontMaterialMask << kPropertyCount;

using Materials = std::array<Material, 2>;

/// The property as four floats; shininess in the first.
glm::vec4 material_value(const Materials& materials, unsigned face, unsigned property);
/// Stores the property; true when the value changed.
bool store_material_value(Materials& materials, unsigned face, unsigned property, glm::vec4 value);

/// The properties that glMaterial(face, pname) sets; 0 for a face or pname it does not take.
MaterialMask material_mask(GLenum face, GLenum pname);

}  // namespace legacy_gl
