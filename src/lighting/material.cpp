#include "lighting/material.hpp"

namespace legacy_gl {

glm::vec4 material_value(const Materials& materials, unsigned face, unsigned property) {
  const Material& material = materials[face];
  switch (property) {
    case kAmbient: return material.ambient;
    case kDiffuse: return material.diffuse;
    case kSpecular: return material.specular;
    case kEmission: return material.emission;
    default: return glm::vec4(material.shininess, 0, 0, 0);
  }
}

bool store_material_value(Materials& materials, unsigned face, unsigned property, glm::vec4 value) {
  if (material_value(materials, face, property) == value) return false;
  Material& material = materials[face];
  switch (property) {
    case kAmbient: material.ambient = value; break;
    case kDiffuse: material.diffuse = value; break;
    case kSpecular: material.specular = value; break;
    case kEmission: material.emission = value; break;
    default: material.shininess = value.x;
  }
  return true;
}

MaterialMask material_mask(GLenum face, GLenum pname) {
  unsigned properties = 0;
  switch (pname) {
    case GL_AMBIENT: properties = 1u << kAmbient; break;
    case GL_DIFFUSE: properties = 1u << kDiffuse; break;
    case GL_AMBIENT_AND_DIFFUSE: properties = 1u << kAmbient | 1u << kDiffuse; break;
    case GL_SPECULAR: properties = 1u << kSpecular; break;
    case GL_EMISSION: properties = 1u << kEmission; break;
    case GL_SHININESS: properties = 1u << kShininess; break;
    default: return 0;
  }
  switch (face) {
    case GL_FRONT: return static_cast<MaterialMask>(properties);
    case GL_BACK: return static_cast<MaterialMask>(properties << kPropertyCount);
    case GL_FRONT_AND_BACK:
      return static_cast<MaterialMask>(properties | properties << kPropertyCount);
    default: return 0;
  }
}

}  // namespace legacy_gl
