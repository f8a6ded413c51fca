#include "api/texture_targets.hpp"

namespace legacy_gl {

std::optional<TextureTarget> texture_target(GLenum name) {
  switch (name) {
    case GL_TEXTURE_1D: return kTexture1D;
    case GL_TEXTURE_2D: return kTexture2D;
    case GL_TEXTURE_3D: return kTexture3D;
    case GL_TEXTURE_CUBE_MAP: return kTextureCube;
    default: return {};
  }
}

std::optional<ImageTarget> image_target(GLenum name, unsigned dimensions) {
  const auto of = [&](unsigned own, ImageTarget target) -> std::optional<ImageTarget> {
    if (dimensions && dimensions != own) return {};
    return target;
  };
  switch (name) {
    case GL_TEXTURE_1D: return of(1, {kTexture1D});
    case GL_TEXTURE_2D: return of(2, {kTexture2D});
    case GL_TEXTURE_3D: return of(3, {kTexture3D});
    case GL_PROXY_TEXTURE_1D: return of(1, {kTexture1D, 0, true});
    case GL_PROXY_TEXTURE_2D: return of(2, {kTexture2D, 0, true});
    case GL_PROXY_TEXTURE_3D: return of(3, {kTexture3D, 0, true});
    case GL_PROXY_TEXTURE_CUBE_MAP: return of(2, {kTextureCube, 0, true});
    default: break;
  }
  const GLenum face = name - GL_TEXTURE_CUBE_MAP_POSITIVE_X;
  if (face >= 6) return {};
  return of(2, {kTextureCube, face});
}

}  // namespace legacy_gl
