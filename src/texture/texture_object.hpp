#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <glm/vec4.hpp>
#include <vector>

#include "state/deleted_names.hpp"
#include "texture/texture_format.hpp"

namespace legacy_gl {

/// The targets that textures are bound to, by rank: an enabled target of higher rank wins (GL 2.1
/// spec 3.8.15).
enum TextureTarget : std::uint8_t { kTexture1D, kTexture2D, kTexture3D, kTextureCube };
inline constexpr unsigned kTextureTargetCount = 4;

/// GL 2.1 spec table 6.17: what glTexParameter sets.
struct TextureParameters {
  glm::vec4 border_color{0};
  GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR;
  GLenum mag_filter = GL_LINEAR;
  std::array<GLenum, 3> wrap{GL_REPEAT, GL_REPEAT, GL_REPEAT};  ///< s, t, r
  float min_lod = -1000, max_lod = 1000;
  GLint base_level = 0, max_level = 1000;
  float lod_bias = 0;
  float priority = 1;
  bool generate_mipmap = false;
  GLenum depth_mode = GL_LUMINANCE;
  GLenum compare_mode = GL_NONE, compare_function = GL_LEQUAL;
  bool operator==(const TextureParameters&) const = default;
};

constexpr bool uses_mipmaps(GLenum min_filter) {
  return min_filter != GL_NEAREST && min_filter != GL_LINEAR;
}

/// One of the filters mixes neighbouring texels.
bool filters_linearly(const TextureParameters& parameters);

/// One level of one face, as it was specified; the driver has the texels.
struct TextureImage {
  GLsizei width = 0, height = 0, depth = 0;  ///< without borders
  GLint internal_format = 1;                 ///< as the application gave it
  TextureFormat format;
  bool exists() const { return width > 0 && height > 0 && depth > 0; }
  bool operator==(const TextureImage& other) const {
    return width == other.width && height == other.height && depth == other.depth &&
           internal_format == other.internal_format;
  }
};

inline constexpr unsigned kMaxTextureLevels = 16;  ///< up to 32768 texels

/// A texture's levels, of six faces where it is a cube map.
class TextureImages {
 public:
  explicit TextureImages(TextureTarget target) : levels_(target == kTextureCube ? 6 : 1) {}

  TextureImage& at(unsigned face, GLint level) {
    return levels_[face][static_cast<unsigned>(level)];
  }
  const TextureImage& at(unsigned face, GLint level) const {
    return levels_[face][static_cast<unsigned>(level)];
  }
  unsigned faces() const { return static_cast<unsigned>(levels_.size()); }

  /// GL 2.1 spec 3.8.10: texturing with what is not complete is texturing switched off.
  bool complete(const TextureParameters& parameters) const;
  /// The level after which there is none, p of 3.8.8, as far as GL_TEXTURE_MAX_LEVEL allows.
  GLint last_level(const TextureParameters& parameters) const;

 private:
  std::vector<std::array<TextureImage, kMaxTextureLevels>> levels_;
};

/// A texture object (GL 2.1 spec 3.8.12). A one-dimensional texture is a two-dimensional one of
/// height 1 to the driver.
class TextureObject {
 public:
  TextureObject(GLuint own_name, TextureTarget own_target, std::shared_ptr<DeletedNames> deleted)
      : name(own_name), target(own_target), images(own_target), driver_name(std::move(deleted)) {}

  const GLuint name;
  const TextureTarget target;
  TextureParameters parameters;
  TextureImages images;

  const std::uint64_t serial = next_serial();  ///< of no other texture in the process

  DriverName driver_name;
  /// The driver does not have `parameters` yet. Contexts that draw with the texture, each in its
  /// thread, find that out for themselves.
  std::atomic<bool> parameters_stale = true;

  bool complete() const { return images.complete(parameters); }
  BaseFormat base() const { return images.at(0, base_level()).format.base; }
  GLint base_level() const {
    constexpr GLint kLast = kMaxTextureLevels - 1;
    return parameters.base_level < kLast ? parameters.base_level : kLast;
  }

 private:
  static std::uint64_t next_serial() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
  }
};

}  // namespace legacy_gl
