#include "texture/texture_object.hpp"

#include <algorithm>

namespace legacy_gl {

namespace {

/// GL 2.1 spec 3.8.8: each level is half as large, rounded down, and at least 1.
GLsizei half(GLsizei size) { return std::max(size / 2, 1); }

}  // namespace

bool filters_linearly(const TextureParameters& parameters) {
  return parameters.mag_filter == GL_LINEAR || parameters.min_filter == GL_LINEAR ||
         parameters.min_filter == GL_LINEAR_MIPMAP_NEAREST ||
         parameters.min_filter == GL_LINEAR_MIPMAP_LINEAR;
}

GLint TextureImages::last_level(const TextureParameters& parameters) const {
  constexpr GLint kLast = kMaxTextureLevels - 1;
  if (parameters.base_level > kLast) return -1;
  const TextureImage& base = at(0, parameters.base_level);
  GLint level = parameters.base_level;
  for (GLsizei size = std::max({base.width, base.height, base.depth}); size > 1; size /= 2) ++level;
  return std::min({level, parameters.max_level, kLast});
}

bool TextureImages::complete(const TextureParameters& parameters) const {
  if (parameters.base_level >= static_cast<GLint>(kMaxTextureLevels)) return false;
  const TextureImage& base = at(0, parameters.base_level);
  if (!base.exists()) return false;
  if (faces() == 6 && base.width != base.height) return false;
  for (unsigned face = 1; face < faces(); ++face)
    if (!(at(face, parameters.base_level) == base)) return false;
  if (!uses_mipmaps(parameters.min_filter)) return true;
  if (parameters.base_level > parameters.max_level) return false;
  const GLint last = last_level(parameters);
  TextureImage expected = base;
  for (GLint level = parameters.base_level + 1; level <= last; ++level) {
    expected.width = half(expected.width);
    expected.height = half(expected.height);
    expected.depth = half(expected.depth);
    for (unsigned face = 0; face < faces(); ++face)
      if (!(at(face, level) == expected)) return false;
  }
  return true;
}

}  // namespace legacy_gl
