#pragma once
#include <optional>

#include "record/pending.hpp"

namespace legacy_gl {

/// GL_TEXTURE_1D ... GL_TEXTURE_CUBE_MAP, to which textures are bound.
std::optional<TextureTarget> texture_target(GLenum name);

/// A target that images are given to: a face of a cube map is one, and a proxy of any.
struct ImageTarget {
  TextureTarget target = kTexture2D;
  unsigned face = 0;
  bool proxy = false;
};
/// `dimensions` of the call: 1, 2 or 3; 0 for any.
std::optional<ImageTarget> image_target(GLenum name, unsigned dimensions);

inline TextureUnit& active_unit(Context& context) {
  return context.texture.units[context.active_texture];
}
inline TextureObject& bound_texture(Context& context, TextureTarget target) {
  return *active_unit(context).bound[target];
}

/// Inside Begin/End, which is an error for all of these calls.
inline bool refused_inside(Context& context) {
  if (!context.recorder.inside_begin_end()) return false;
  raise_error(context, GL_INVALID_OPERATION);
  return true;
}

}  // namespace legacy_gl
