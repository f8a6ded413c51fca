#pragma once
#include <array>
#include <cstdint>
#include <glm/vec4.hpp>

namespace legacy_gl {

inline constexpr unsigned kMaxClipPlanes = 6;

/// GL 2.1 spec 2.12: the planes in eye coordinates, as they were when they were specified.
struct ClipPlanes {
  std::uint8_t enabled = 0;  ///< a bit for each plane
  std::array<glm::dvec4, kMaxClipPlanes> planes_eye{};
  bool operator==(const ClipPlanes&) const = default;
};

}  // namespace legacy_gl
