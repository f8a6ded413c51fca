#pragma once
#include <array>
#include <cstdint>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// GL 2.1 spec table 3.15: which components a texture has. Drivers without fixed functions have no
/// alpha, luminance and intensity: those lie in the red channel, or in red and green.
enum class BaseFormat : std::uint8_t {
  kAlpha,
  kLuminance,
  kLuminanceAlpha,
  kIntensity,
  kRed,  // these two of ARB_texture_rg: RGB whose other components are 0
  kRg,
  kRgb,
  kRgba,
  kDepth
};

/// What an internal format of the application's means, and what the driver stores for it.
struct TextureFormat {
  BaseFormat base = BaseFormat::kRgba;
  GLenum core = 0;          ///< sized internal format of OpenGL 3.3; 0: there is no such format
  GLenum es = 0;            ///< of OpenGL ES 3.0
  bool compressed = false;  ///< asks for compression, which we need not do (3.8.1)
};

/// ARB_texture_rg.
inline constexpr GLenum kRgFormat = 0x8227;

/// EXT_packed_depth_stencil: a depth of 24 bits above a stencil index of 8, in one word. Textures
/// of it are read as depths, and are attached to framebuffer objects.
inline constexpr GLenum kDepthStencil = 0x84F9, kDepth24Stencil8 = 0x88F0,
                        kUnsignedInt24_8 = 0x84FA;

/// GL 2.1 spec tables 3.15, 3.16, 3.17. `core` is 0 for what is no internal format.
TextureFormat find_texture_format(GLint internal_format);

/// How many components the driver's storage has: 1, 2, 3 or 4.
unsigned stored_components(BaseFormat base);

/// GL_ALPHA, GL_LUMINANCE, ... of table 3.15.
GLenum base_format_name(BaseFormat base);

/// Which stored channel a component has, for queries: -1 where the base format lacks it.
/// `size_name` is GL_TEXTURE_RED_SIZE, ... GL_TEXTURE_INTENSITY_SIZE, GL_TEXTURE_DEPTH_SIZE.
int stored_channel(BaseFormat base, GLenum size_name);

/// Bits of each stored channel in a storage format of OpenGL ES, which cannot be asked.
std::array<GLint, 4> es_channel_bits(GLenum es_format);

}  // namespace legacy_gl
