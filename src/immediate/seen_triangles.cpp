#include "immediate/seen_triangles.hpp"

#include <algorithm>
#include <cmath>

#include "immediate/float4.hpp"

namespace legacy_gl {

namespace {

/// How far, in pixels, rounding may move a vertex: llvmpipe snaps to 1/256 of a pixel, and floats
/// as large as kFar are 1/1024 apart.
constexpr float kMargin = 1.0f / 128;
constexpr float kFar = 8192;

enum : std::uint32_t {
  kBeyondAnyPlane = 63,  ///< one bit for each clip plane
  kUnsafe = 64,          ///< behind the eye, before the near plane or far outside: no coordinates
  kTouchesDrawn = 128,   ///< a side that is drawn meets the place
};

/// The largest whole number that is not larger, of a coordinate that is not unsafe.
int floor_of(float coordinate) {
  constexpr int kShift = static_cast<int>(kFar) + 8;
  return static_cast<int>(coordinate + static_cast<float>(kShift)) - kShift;
}

/// An edge of a triangle, and how far outside rounding may put a sample that is on it.
struct Edge {
  float x, y, dx, dy, reach;

  template <typename Place>
  Edge(const Place& a, const Place& b)
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

}  // namespace

void SeenTriangles::project(const Surface& surface, const SurfaceView& view) {
  places_.resize(surface.places.size());
  const Columns matrix = columns(view.to_clip);
  const auto& box = view.viewport.box;
  const float half_width = 0.5f * static_cast<float>(box[2]);
  const float half_height = 0.5f * static_cast<float>(box[3]);
  // Samples are in the middle of pixels.
  const float center_x = static_cast<float>(box[0]) + half_width - 0.5f;
  const float center_y = static_cast<float>(box[1]) + half_height - 0.5f;
  ScreenPlace* to = places_.data();
  for (const glm::vec3& place : surface.places) {
    const Float4 clip = product(matrix, place.x, place.y, place.z, 1);
    const Float4 w = splat(clip[3]);
    const Int4 above = clip > w, below = clip < -w;
    const float inverse = 1 / clip[3];
    to->x = clip[0] * inverse * half_width + center_x;
    to->y = clip[1] * inverse * half_height + center_y;
    const bool safe =
        clip[3] > 1e-30f && !below[2] && std::abs(to->x) < kFar && std::abs(to->y) < kFar;
    to->flags = static_cast<std::uint32_t>((above[0] & 1) | (above[1] & 2) | (above[2] & 4) |
                                           (below[0] & 8) | (below[1] & 16) | (below[2] & 32)) |
                (safe ? 0u : std::uint32_t{kUnsafe});
    ++to;
  }
}

template <typename Place>
struct Triangle {
  const Place &a, &b, &c;
  Edge ab{a, b}, bc{b, c}, ca{c, a};
  float area = ab.dx * bc.dy - ab.dy * bc.dx;  ///< twice

  bool has_side() const { return std::abs(area) > ab.reach + bc.reach + ca.reach; }
  bool may_contain(int x, int y) const {
    const float turn = area > 0 ? 1.0f : -1.0f;
    const auto px = static_cast<float>(x), py = static_cast<float>(y);
    return ab.may_contain(px, py, turn) && bc.may_contain(px, py, turn) &&
           ca.may_contain(px, py, turn);
  }
};

bool SeenTriangles::is_dropped(const ScreenPlace& a, const ScreenPlace& b, const ScreenPlace& c,
                               const SurfaceView& view) {
  if ((a.flags | b.flags | c.flags) & kUnsafe) return false;
  const Triangle<ScreenPlace> triangle{a, b, c};
  if (!triangle.has_side()) return false;
  return triangle.area > 0 ? view.drops_counterclockwise : view.drops_clockwise;
}

bool SeenTriangles::may_cover(const ScreenPlace& a, const ScreenPlace& b, const ScreenPlace& c) {
  if (a.flags & b.flags & c.flags & kBeyondAnyPlane) return false;
  if ((a.flags | b.flags | c.flags) & kUnsafe) return true;
  const int left = floor_of(std::min({a.x, b.x, c.x}) - kMargin) + 1;
  const int right = floor_of(std::max({a.x, b.x, c.x}) + kMargin);
  const int bottom = floor_of(std::min({a.y, b.y, c.y}) - kMargin) + 1;
  const int top = floor_of(std::max({a.y, b.y, c.y}) + kMargin);
  if (right < left || top < bottom) return false;
  if (right - left > 1 || top - bottom > 1) return true;  // many samples: one of them is inside
  const Triangle<ScreenPlace> triangle{a, b, c};
  if (!triangle.has_side()) return true;
  for (int y = bottom; y <= top; ++y)
    for (int x = left; x <= right; ++x)
      if (triangle.may_contain(x, y)) return true;
  return false;
}

void SeenTriangles::append(const Surface& surface, const SurfaceView& view,
                           std::vector<std::uint32_t>& indices) {
  project(surface, view);
  const std::size_t triangles = surface.corners.size() / 3;
  const auto place = [&](std::size_t triangle, std::size_t corner) -> const ScreenPlace& {
    return places_[surface.corners[3 * triangle + corner].place];
  };
  dropped_.resize(triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    dropped_[t] = is_dropped(place(t, 0), place(t, 1), place(t, 2), view);
    if (view.keeps_outline && !dropped_[t])
      for (std::size_t k = 0; k < 3; ++k)
        places_[surface.corners[3 * t + k].place].flags |= kTouchesDrawn;
  }
  const std::size_t first = indices.size();
  indices.resize(first + surface.corners.size());
  std::uint32_t* to = indices.data() + first;
  for (std::size_t t = 0; t < triangles; ++t) {
    const ScreenPlace &a = place(t, 0), &b = place(t, 1), &c = place(t, 2);
    if (dropped_[t] && !((a.flags | b.flags | c.flags) & kTouchesDrawn)) continue;
    if (!may_cover(a, b, c)) continue;
    for (std::size_t k = 0; k < 3; ++k) *to++ = surface.corners[3 * t + k].vertex;
  }
  indices.resize(static_cast<std::size_t>(to - indices.data()));
}

}  // namespace legacy_gl
