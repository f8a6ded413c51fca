#pragma once
#include <bit>
#include <cstdint>

#include "state/context.hpp"

namespace legacy_gl {

/// glMaterialfv as programs call it most: one colour of one face, while no colour material tracks
/// it and nothing is recorded. False when the call needs set_material.
inline bool set_material_color(Context& context, GLenum face, GLenum pname, const float* color) {
  static_assert(GL_DIFFUSE == GL_AMBIENT + 1 && GL_SPECULAR == GL_AMBIENT + 2);
  static constexpr glm::vec4 Material::*kColors[] = {&Material::ambient, &Material::diffuse,
                                                     &Material::specular, &Material::emission};
  const unsigned property = pname == GL_EMISSION ? 3 : pname - GL_AMBIENT;
  if (property > 3 || (property == 3 && pname != GL_EMISSION)) return false;
  if (face != GL_FRONT && face != GL_BACK) return false;
  if (context.lighting.color_material.enabled) return false;
  if (!context.recorder.is_idle() && !context.recorder.all_lit()) {
    if (!context.recorder.takes_materials(material_bit(face == GL_BACK, property))) return false;
    context.recorder.material_changed();
  }
  // A word at a time: programs write a colour that way just before, and a wider read would wait
  // until those stores have left the processor.
  glm::vec4& stored = context.lighting.materials[face == GL_BACK].*kColors[property];
  std::uint32_t difference = 0;
  for (int i = 0; i < 4; ++i) {
    difference |= std::bit_cast<std::uint32_t>(stored[i]) ^ std::bit_cast<std::uint32_t>(color[i]);
    stored[i] = color[i];
  }
  if (difference) context.dirty |= kDirtyMaterial;
  return true;
}

}  // namespace legacy_gl
