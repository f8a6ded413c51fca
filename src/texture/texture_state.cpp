#include "texture/texture_state.hpp"

#include <algorithm>

namespace legacy_gl {

namespace {

bool is_generated(const TexgenCoordinate& coordinate) { return coordinate.enabled; }

bool depends_on_normal(GLenum mode) {
  return mode == GL_SPHERE_MAP || mode == GL_REFLECTION_MAP || mode == GL_NORMAL_MAP;
}

/// The texture that the unit draws with: of the enabled targets, the highest counts, and nothing is
/// drawn when it is not complete (GL 2.1 spec 3.8.15).
TextureObject* texture_of(const TextureUnit& unit) {
  for (unsigned target = kTextureTargetCount; target-- > 0;)
    if (unit.enabled[target])
      return unit.bound[target]->complete() ? unit.bound[target].get() : nullptr;
  return nullptr;
}

ActiveTextures find_active(const TextureState& state) {
  ActiveTextures active;
  for (unsigned i = 0; i < kMaxTextureUnits; ++i) {
    const TextureUnit& unit = state.units[i];
    TextureObject* const texture = texture_of(unit);
    if (!texture) continue;
    const auto& coordinates = unit.texgen.coordinates;
    active.textures[i] = texture;
    active.count = i + 1;
    active.mask |= static_cast<std::uint8_t>(1u << i);
    if (!std::all_of(coordinates.begin(), coordinates.end(), is_generated))
      active.from_vertex |= static_cast<std::uint8_t>(1u << i);
    for (const TexgenCoordinate& coordinate : coordinates)
      active.reads_normal |= coordinate.enabled && depends_on_normal(coordinate.mode);
  }
  return active;
}

}  // namespace

TextureState::TextureState()
    : proxies{TextureImages(kTexture1D), TextureImages(kTexture2D), TextureImages(kTexture3D),
              TextureImages(kTextureCube)} {
  for (unsigned target = 0; target < kTextureTargetCount; ++target)
    defaults[target] =
        std::make_shared<TextureObject>(0, static_cast<TextureTarget>(target), deleted_defaults);
  for (TextureUnit& unit : units) unit.bound = defaults;
}

const ActiveTextures& active_textures(const TextureState& state) {
  if (state.active_stale) {
    state.active_stale = false;
    state.active = find_active(state);
  }
  return state.active;
}

}  // namespace legacy_gl
