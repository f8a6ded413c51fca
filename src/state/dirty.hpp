#pragma once
#include <array>
#include <cstdint>
#include <utility>

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

/// Those who follow the state at different times. Each sees every bit that was raised since it
/// looked last, whoever has cleared it in the meantime.
class DirtyReaders {
 public:
  enum Reader : unsigned {
    kInputs,        ///< what the driver draws with
    kShading,       ///< what src/software lights with
    kShadingState,  ///< whether src/software may light
    kReaders
  };

  /// The bits that this reader has not seen; `raised` are the context's now.
  std::uint32_t take(std::uint32_t raised, Reader reader) {
    note(raised);
    return std::exchange(unseen_[reader], 0);
  }
  /// These are about to be cleared in the context.
  void note(std::uint32_t raised) {
    for (std::uint32_t& unseen : unseen_) unseen |= raised;
  }

 private:
  std::array<std::uint32_t, kReaders> unseen_{0, kDirtyAll, kDirtyAll};
};

}  // namespace legacy_gl
