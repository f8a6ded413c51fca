#pragma once
#include <array>
#include <memory>

#include "state/current.hpp"
#include "state/shared_names.hpp"
#include "texture/texture_environment.hpp"
#include "texture/texture_object.hpp"

namespace legacy_gl {

using TexturePointer = std::shared_ptr<TextureObject>;

/// A texture that is deleted lives on where another context has it bound (GL 2.1 spec D.3).
struct SharedTextures {
  SharedNames<TextureObject> names;
  std::shared_ptr<DeletedNames> deleted = std::make_shared<DeletedNames>();
};

/// GL 2.1 spec tables 6.16, 6.20 to 6.22: what one texture unit has.
struct TextureUnit {
  std::array<bool, kTextureTargetCount> enabled{};
  std::array<TexturePointer, kTextureTargetCount> bound;
  TextureEnvironment environment;
  TexgenState texgen;
  bool operator==(const TextureUnit&) const = default;
};

/// The units that draw, as far as layouts and keys ask: derived from the units, their textures and
/// matrices.
struct ActiveTextures {
  unsigned count = 0;            ///< units up to the highest that draws
  std::uint8_t mask = 0;         ///< units that draw
  std::uint8_t from_vertex = 0;  ///< of those: units that read the texture coordinates
  bool reads_normal = false;     ///< a generated coordinate depends on the normal
  std::array<TextureObject*, kMaxTextureUnits> textures{};
};

struct TextureState {
  TextureState();

  std::shared_ptr<SharedTextures> shared = std::make_shared<SharedTextures>();
  std::shared_ptr<DeletedNames> deleted_defaults = std::make_shared<DeletedNames>();
  /// What name 0 means for each target (GL 2.1 spec 3.8.12).
  std::array<TexturePointer, kTextureTargetCount> defaults;
  std::array<TextureUnit, kMaxTextureUnits> units;
  /// GL 2.1 spec 3.8.11: what a proxy was asked last, a level a place.
  std::array<TextureImages, kTextureTargetCount> proxies;

  /// Set when `active` has to be found again.
  mutable bool active_stale = false;
  mutable ActiveTextures active;
};

/// `state.active`, up to date.
const ActiveTextures& active_textures(const TextureState& state);

}  // namespace legacy_gl
