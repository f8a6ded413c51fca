#pragma once
#include <cstdint>

namespace legacy_gl {

/// What has to be derived again before the next draw. A setter raises a bit only when a value
/// changed.
enum Dirty : std::uint32_t {
  kDirtyTransform = 1u << 0,  ///< modelview or projection
  kDirtyLights = 1u << 1,     ///< light parameters, in eye coordinates
  kDirtyMaterial = 1u << 2,   ///< material values, light model ambient
  kDirtyKey = 1u << 3,        ///< a state that chooses the program variant
  kDirtyRaster = 1u << 4,     ///< a state that the driver still has: depth, blend, cull, ...
  kDirtyFragments = 1u << 6,  ///< fog, the alpha test's reference, clip planes
  kDirtyTexture = 1u << 5,    ///< units, their textures and texture matrices
  kDirtyAll = 0xffffffffu
};

}  // namespace legacy_gl
