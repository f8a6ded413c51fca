#pragma once
#include <cstdint>

namespace legacy_gl {

enum class FogMode : std::uint8_t { kNone, kLinear, kExp, kExp2 };

/// GL_NEVER to GL_ALWAYS, in the order of their enums; kAlways is no test.
enum class AlphaFunction : std::uint8_t {
  kAlways,
  kNever,
  kLess,
  kEqual,
  kLessOrEqual,
  kGreater,
  kNotEqual,
  kGreaterOrEqual
};

/// Which fragments of a primitive there are, beside those that it is made of.
enum class Coverage : std::uint8_t {
  kWhole,
  kPolygonStipple,  ///< where the pattern has a bit
  kSmoothPoint      ///< in a circle, whose edge takes away from alpha
};

/// What happens to fragments beside texturing, and where primitives are clipped.
struct FragmentKey {
  FogMode fog = FogMode::kNone;
  bool fog_coordinate = false;  ///< fog by the vertices' fog coordinate, and not by their depth
  AlphaFunction alpha = AlphaFunction::kAlways;
  std::uint8_t clip_planes = 0;  ///< a bit for each plane that is enabled
  Coverage coverage = Coverage::kWhole;
  bool operator==(const FragmentKey&) const = default;

  bool has_fog() const { return fog != FogMode::kNone; }
  bool has_alpha_test() const { return alpha != AlphaFunction::kAlways; }
};

}  // namespace legacy_gl
