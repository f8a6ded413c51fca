#pragma once
#include <cstddef>
#include <glm/vec4.hpp>
#include <vector>

struct legacy_gl_context;

namespace legacy_gl {

inline constexpr std::size_t kViewVolumePlanes = 6;

/// Planes in clip coordinates, all positive inside: those of the view volume, and behind them the
/// enabled clip planes (GL 2.1 spec 2.12).
std::vector<glm::vec4> clipping_planes(const legacy_gl_context& context);

}  // namespace legacy_gl
