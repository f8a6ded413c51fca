#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>

#include "record/pending.hpp"

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
  unsigned property = pname - GL_AMBIENT;
  if (property > 2) [[unlikely]] {
    if (pname != GL_EMISSION) return false;
    property = 3;
  }
  if (face - GL_FRONT > 1) [[unlikely]]
    return false;
  if (context.lighting.color_material.enabled) [[unlikely]]
    return false;
  const Recorder& recorder = context.recorder;
  if (!recorder.is_idle()) [[unlikely]] {
    if (!recorder.all_shaded()) return false;
  }
  float* const stored =
      reinterpret_cast<float*>(&context.lighting.materials[face - GL_FRONT]) + 4 * property;
  if (!(context.dirty & kDirtyMaterial)) [[unlikely]] {
    const auto differs = [&](int i) {
      return std::bit_cast<std::uint32_t>(color[i]) ^ std::bit_cast<std::uint32_t>(stored[i]);
    };
    if (!(differs(0) | differs(1) | differs(2) | differs(3))) return true;
    context.dirty |= kDirtyMaterial;
  }
  // A word at a time, which compilers are kept from making one of four: programs write a colour
  // that way just before, and a wider read would wait until those stores have left the processor.
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i) {
    stored[i] = color[i];
    asm("" : "+m"(stored[i]));
  }
  return true;
}

}  // namespace legacy_gl
