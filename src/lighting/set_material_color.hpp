#pragma once
#include <algorithm>
#include <cstddef>

#include "state/context.hpp"

namespace legacy_gl {

/// glMaterialfv as programs call it most: one colour of one face, while no colour material tracks
/// it and nothing waits to be drawn that it changes. False when the call needs set_material. So
/// little is done here that the caller keeps all of it in registers.
[[gnu::always_inline]] inline bool set_material_color(Context& context, GLenum face, GLenum pname,
                                                      const float* color) {
  static_assert(GL_DIFFUSE == GL_AMBIENT + 1 && GL_SPECULAR == GL_AMBIENT + 2);
  static_assert(GL_BACK == GL_FRONT + 1);
  constexpr std::size_t kColor = sizeof(glm::vec4);
  static_assert(offsetof(Material, ambient) == 0 && offsetof(Material, diffuse) == kColor &&
                offsetof(Material, specular) == 2 * kColor &&
                offsetof(Material, emission) == 3 * kColor);
  const unsigned property = pname == GL_EMISSION ? 3 : pname - GL_AMBIENT;
  if (property > 3 || (property == 3 && pname != GL_EMISSION) || face - GL_FRONT > 1) return false;
  if (context.lighting.color_material.enabled) return false;
  const Recorder& recorder = context.recorder;
  if (!recorder.is_idle() && !recorder.all_lit()) return false;
  // A word at a time: programs write a colour that way just before, and a wider read would wait
  // until those stores have left the processor.
  float* const stored =
      reinterpret_cast<float*>(&context.lighting.materials[face - GL_FRONT]) + 4 * property;
  if (!(context.dirty & kDirtyMaterial)) {
    if (std::equal(color, color + 4, stored)) return true;
    context.dirty |= kDirtyMaterial;
  }
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i) stored[i] = color[i];
  return true;
}

}  // namespace legacy_gl
