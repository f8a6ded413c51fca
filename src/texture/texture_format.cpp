#include "texture/texture_format.hpp"

#include "texture/compressed_format.hpp"

namespace legacy_gl {

namespace {

// Storage that OpenGL 1.5 does not know.
constexpr GLenum kR8 = 0x8229, kR16 = 0x822A, kRg8 = 0x822B, kRg16 = 0x822C, kRgb565 = 0x8D62;
constexpr GLenum kCompressedRed = 0x8225, kCompressedRg = 0x8226;

}  // namespace

TextureFormat find_texture_format(GLint internal_format) {
  using enum BaseFormat;
  switch (static_cast<GLenum>(internal_format)) {
    case GL_COMPRESSED_ALPHA: return {kAlpha, kR8, kR8, true};
    case GL_ALPHA:
    case GL_ALPHA4:
    case GL_ALPHA8: return {kAlpha, kR8, kR8};
    case GL_ALPHA12:
    case GL_ALPHA16: return {kAlpha, kR16, kR8};
    case GL_COMPRESSED_LUMINANCE: return {kLuminance, kR8, kR8, true};
    case 1:
    case GL_LUMINANCE:
    case GL_LUMINANCE4:
    case GL_LUMINANCE8: return {kLuminance, kR8, kR8};
    case GL_LUMINANCE12:
    case GL_LUMINANCE16: return {kLuminance, kR16, kR8};
    case GL_COMPRESSED_LUMINANCE_ALPHA: return {kLuminanceAlpha, kRg8, kRg8, true};
    case 2:
    case GL_LUMINANCE_ALPHA:
    case GL_LUMINANCE4_ALPHA4:
    case GL_LUMINANCE6_ALPHA2:
    case GL_LUMINANCE8_ALPHA8:
    case GL_LUMINANCE12_ALPHA4: return {kLuminanceAlpha, kRg8, kRg8};
    case GL_LUMINANCE12_ALPHA12:
    case GL_LUMINANCE16_ALPHA16: return {kLuminanceAlpha, kRg16, kRg8};
    case GL_COMPRESSED_INTENSITY: return {kIntensity, kR8, kR8, true};
    case GL_INTENSITY:
    case GL_INTENSITY4:
    case GL_INTENSITY8: return {kIntensity, kR8, kR8};
    case GL_INTENSITY12:
    case GL_INTENSITY16: return {kIntensity, kR16, kR8};
    case kCompressedRed: return {kRed, kR8, kR8, true};
    case GL_RED:
    case kR8: return {kRed, kR8, kR8};
    case kR16: return {kRed, kR16, kR8};
    case kCompressedRg: return {kRg, kRg8, kRg8, true};
    case kRgFormat:
    case kRg8: return {kRg, kRg8, kRg8};
    case kRg16: return {kRg, kRg16, kRg8};
    case GL_COMPRESSED_RGB: return {kRgb, GL_RGB8, GL_RGB8, true};
    case kRgbDxt1: return {kRgb, kRgbDxt1, GL_RGB8, true};
    case kRgbaDxt1:
    case kRgbaDxt3:
    case kRgbaDxt5: return {kRgba, static_cast<GLenum>(internal_format), GL_RGBA8, true};
    case 3:
    case GL_RGB:
    case GL_RGB8: return {kRgb, GL_RGB8, GL_RGB8};
    case GL_R3_G3_B2: return {kRgb, GL_R3_G3_B2, kRgb565};
    case GL_RGB4: return {kRgb, GL_RGB4, kRgb565};
    case GL_RGB5: return {kRgb, GL_RGB5, kRgb565};
    case GL_RGB10: return {kRgb, GL_RGB10, GL_RGB8};
    case GL_RGB12: return {kRgb, GL_RGB12, GL_RGB8};
    case GL_RGB16: return {kRgb, GL_RGB16, GL_RGB8};
    case GL_COMPRESSED_RGBA: return {kRgba, GL_RGBA8, GL_RGBA8, true};
    case 4:
    case GL_RGBA:
    case GL_RGBA8: return {kRgba, GL_RGBA8, GL_RGBA8};
    case GL_RGBA2: return {kRgba, GL_RGBA2, GL_RGBA4};
    case GL_RGBA4: return {kRgba, GL_RGBA4, GL_RGBA4};
    case GL_RGB5_A1: return {kRgba, GL_RGB5_A1, GL_RGB5_A1};
    case GL_RGB10_A2: return {kRgba, GL_RGB10_A2, GL_RGBA8};
    case GL_RGBA12: return {kRgba, GL_RGBA12, GL_RGBA8};
    case GL_RGBA16: return {kRgba, GL_RGBA16, GL_RGBA8};
    case kDepthStencil:
    case kDepth24Stencil8: return {kDepth, kDepth24Stencil8, kDepth24Stencil8};
    case GL_DEPTH_COMPONENT16: return {kDepth, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT16};
    case GL_DEPTH_COMPONENT:
    case GL_DEPTH_COMPONENT24: return {kDepth, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT24};
    case GL_DEPTH_COMPONENT32: return {kDepth, GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT24};
    default: return {};
  }
}

unsigned stored_components(BaseFormat base) {
  switch (base) {
    case BaseFormat::kAlpha:
    case BaseFormat::kLuminance:
    case BaseFormat::kIntensity:
    case BaseFormat::kRed:
    case BaseFormat::kDepth: return 1;
    case BaseFormat::kLuminanceAlpha:
    case BaseFormat::kRg: return 2;
    case BaseFormat::kRgb: return 3;
    case BaseFormat::kRgba: return 4;
  }
  return 4;
}

GLenum base_format_name(BaseFormat base) {
  switch (base) {
    case BaseFormat::kAlpha: return GL_ALPHA;
    case BaseFormat::kLuminance: return GL_LUMINANCE;
    case BaseFormat::kLuminanceAlpha: return GL_LUMINANCE_ALPHA;
    case BaseFormat::kIntensity: return GL_INTENSITY;
    case BaseFormat::kRed: return GL_RED;
    case BaseFormat::kRg: return kRgFormat;
    case BaseFormat::kRgb: return GL_RGB;
    case BaseFormat::kRgba: return GL_RGBA;
    case BaseFormat::kDepth: return GL_DEPTH_COMPONENT;
  }
  return GL_RGBA;
}

int stored_channel(BaseFormat base, GLenum size_name) {
  const bool has_rgb = base == BaseFormat::kRgb || base == BaseFormat::kRgba;
  const bool has_rg = has_rgb || base == BaseFormat::kRg;
  switch (size_name) {
    case GL_TEXTURE_RED_SIZE: return has_rg || base == BaseFormat::kRed ? 0 : -1;
    case GL_TEXTURE_GREEN_SIZE: return has_rg ? 1 : -1;
    case GL_TEXTURE_BLUE_SIZE: return has_rgb ? 2 : -1;
    case GL_TEXTURE_ALPHA_SIZE:
      if (base == BaseFormat::kAlpha) return 0;
      if (base == BaseFormat::kLuminanceAlpha) return 1;
      return base == BaseFormat::kRgba ? 3 : -1;
    case GL_TEXTURE_LUMINANCE_SIZE:
      return base == BaseFormat::kLuminance || base == BaseFormat::kLuminanceAlpha ? 0 : -1;
    case GL_TEXTURE_INTENSITY_SIZE: return base == BaseFormat::kIntensity ? 0 : -1;
    default: return base == BaseFormat::kDepth ? 0 : -1;
  }
}

std::array<GLint, 4> es_channel_bits(GLenum es_format) {
  switch (es_format) {
    case kR8: return {8, 0, 0, 0};
    case kRg8: return {8, 8, 0, 0};
    case GL_RGB8: return {8, 8, 8, 0};
    case kRgb565: return {5, 6, 5, 0};
    case GL_RGBA4: return {4, 4, 4, 4};
    case GL_RGB5_A1: return {5, 5, 5, 1};
    case GL_DEPTH_COMPONENT16: return {16, 0, 0, 0};
    case GL_DEPTH_COMPONENT24: return {24, 0, 0, 0};
    default: return {8, 8, 8, 8};
  }
}

}  // namespace legacy_gl
