#pragma once
// Triangles in window coordinates where samples are at whole numbers, and what rounding may make of
// them.
#include <algorithm>
#include <cmath>

#include "state/raster.hpp"

namespace legacy_gl {

/// How far, in pixels, rounding may move a vertex: llvmpipe snaps to 1/256 of a pixel, and floats
/// as large as kFar are 1/1024 apart.
inline constexpr float kMargin = 1.0f / 128;
inline constexpr float kFar = 8192;

/// From normalised device coordinates.
struct ScreenScale {
  float half_width, half_height, center_x, center_y;

  explicit ScreenScale(const ViewportState& viewport)
      : half_width(0.5f * static_cast<float>(viewport.box[2])),
        half_height(0.5f * static_cast<float>(viewport.box[3])),
        // Samples are in the middle of pixels.
        center_x(static_cast<float>(viewport.box[0]) + half_width - 0.5f),
        center_y(static_cast<float>(viewport.box[1]) + half_height - 0.5f) {}
};

/// The largest whole number that is not larger, of a coordinate nearer than kFar.
inline int floor_of(float coordinate) {
  constexpr int kShift = static_cast<int>(kFar) + 8;
  return static_cast<int>(coordinate + static_cast<float>(kShift)) - kShift;
}

/// An edge of a triangle, and how far outside rounding may put a sample that is on it.
struct ScreenEdge {
  float x, y, dx, dy, reach;

  template <typename Place>
  ScreenEdge(const Place& a, const Place& b)
      : x(a.x),
        y(a.y),
        dx(b.x - a.x),
        dy(b.y - a.y),
        reach(kMargin * (std::abs(dx) + std::abs(dy))) {}
  /// `turn` is 1 where the triangle is counterclockwise, -1 where it is not.
  bool may_contain(float px, float py, float turn) const {
    return turn * (dx * (py - y) - dy * (px - x)) >= -reach;
  }
};

/// Place has x and y, nearer than kFar.
template <typename Place>
struct ScreenTriangle {
  const Place &a, &b, &c;
  ScreenEdge ab{a, b}, bc{b, c}, ca{c, a};
  float area = ab.dx * bc.dy - ab.dy * bc.dx;  ///< twice

  bool has_side() const { return std::abs(area) > ab.reach + bc.reach + ca.reach; }
  bool may_contain(float x, float y) const {
    const float turn = area > 0 ? 1.0f : -1.0f;
    return ab.may_contain(x, y, turn) && bc.may_contain(x, y, turn) && ca.may_contain(x, y, turn);
  }
  bool may_cover_sample() const {
    const int left = floor_of(std::min({a.x, b.x, c.x}) - kMargin) + 1;
    const int right = floor_of(std::max({a.x, b.x, c.x}) + kMargin);
    const int bottom = floor_of(std::min({a.y, b.y, c.y}) - kMargin) + 1;
    const int top = floor_of(std::max({a.y, b.y, c.y}) + kMargin);
    if (right < left || top < bottom) return false;
    if (right - left > 1 || top - bottom > 1) return true;  // many samples: one of them is inside
    if (!has_side()) return true;
    for (int y = bottom; y <= top; ++y)
      for (int x = left; x <= right; ++x)
        if (may_contain(static_cast<float>(x), static_cast<float>(y))) return true;
    return false;
  }
};

}  // namespace legacy_gl
