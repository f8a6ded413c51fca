#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace legacy_gl {

inline constexpr unsigned kMaxTextureStages = 8;

/// kNone: the unit draws nothing. A 1D texture is a 2D one of height 1.
enum class TextureKind : std::uint8_t { kNone, k1D, k2D, k3D, kCube };

/// What the red, or red and green, channel of the driver's texture stands for (GL 2.1 spec table
/// 3.21).
enum class TextureBase : std::uint8_t {
  kAlpha,
  kLuminance,
  kLuminanceAlpha,
  kIntensity,
  kRgb,
  kRgba
};

enum class TextureMode : std::uint8_t { kModulate, kReplace, kDecal, kBlend, kAdd, kCombine };

enum class CombineFunction : std::uint8_t {
  kReplace,
  kModulate,
  kAdd,
  kAddSigned,
  kInterpolate,
  kSubtract,
  kDot3Rgb,
  kDot3Rgba
};

constexpr unsigned argument_count(CombineFunction function) {
  if (function == CombineFunction::kReplace) return 1;
  return function == CombineFunction::kInterpolate ? 3 : 2;
}

/// kTexture0 + n is unit n's texture.
enum class CombineSource : std::uint8_t { kConstant, kPrimaryColor, kPrevious, kTexture0 };
enum class CombineOperand : std::uint8_t { kColor, kOneMinusColor, kAlpha, kOneMinusAlpha };

/// One half of the combine environment; arguments that the function does not read are zero.
struct CombineKey {
  CombineFunction function = CombineFunction::kReplace;
  std::uint8_t scale = 0;                 ///< 1, 2 or 4
  std::array<std::uint8_t, 3> sources{};  ///< CombineSource
  std::array<CombineOperand, 3> operands{};
  bool operator==(const CombineKey&) const = default;
};

/// Where a texture coordinate comes from. kLinear is the product of a plane with the position.
enum class CoordinateSource : std::uint8_t { kVertex, kLinear, kSphere, kReflection, kNormal };

struct TextureStageKey {
  TextureKind kind = TextureKind::kNone;
  TextureBase base = TextureBase::kAlpha;
  TextureMode mode = TextureMode::kModulate;
  bool matrix = false;      ///< the texture matrix is not the identity
  bool projective = false;  ///< q may differ from 1
  bool lod_bias = false;
  bool shadow = false;     ///< compares the depth texture with r
  std::uint8_t clamp = 0;  ///< bits s, t, r: GL_CLAMP, the coordinate stays in [0, 1]
  bool mipmap = false;     ///< with clamp: levels are chosen before the coordinate is clamped
  std::array<CoordinateSource, 4> sources{};  ///< of s, t, r, q
  CombineKey rgb, alpha;                      ///< with TextureMode::kCombine
  bool operator==(const TextureStageKey&) const = default;

  bool reads_vertex() const {
    return kind != TextureKind::kNone &&
           std::count(sources.begin(), sources.end(), CoordinateSource::kVertex) != 0;
  }
  bool generates(CoordinateSource source) const {
    return std::count(sources.begin(), sources.end(), source) != 0;
  }
  bool reads_normal() const {
    return generates(CoordinateSource::kSphere) || generates(CoordinateSource::kReflection) ||
           generates(CoordinateSource::kNormal);
  }
};

/// The units up to the highest that draws. Comparing and copying costs nothing where none does.
struct TextureKey {
  std::uint8_t count = 0;
  bool normalize = false;  ///< normals that generate coordinates are made unit length
  std::array<TextureStageKey, kMaxTextureStages> stages{};

  bool operator==(const TextureKey& other) const {
    return count == other.count && normalize == other.normalize &&
           std::equal(stages.begin(), stages.begin() + count, other.stages.begin());
  }
  bool reads_planes() const {
    return std::any_of(stages.begin(), stages.begin() + count, [](const TextureStageKey& stage) {
      return stage.generates(CoordinateSource::kLinear);
    });
  }
  bool reads_normal() const {
    return std::any_of(stages.begin(), stages.begin() + count,
                       [](const TextureStageKey& stage) { return stage.reads_normal(); });
  }
};

std::size_t hash_of(const TextureKey& key);

/// In words, as line 1 of the GLSL says it: "" where nothing is textured.
std::string describe(const TextureKey& key);

}  // namespace legacy_gl
