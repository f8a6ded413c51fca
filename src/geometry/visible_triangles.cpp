#include "geometry/visible_triangles.hpp"

#include <cmath>

#include "geometry/float4.hpp"
#include "geometry/screen_triangle.hpp"

namespace legacy_gl {

namespace {

enum : std::uint32_t {
  kBeyondAnyPlane = 63,  ///< one bit for each clip plane
  kUnsafe = 64,          ///< behind the eye, before the near plane or far outside: no coordinates
  kTouchesDrawn = 128,   ///< a side that is drawn meets the place
};

}  // namespace

void VisibleTriangles::project(const Surface& surface, const SurfaceView& view) {
  places_.resize(surface.places.size());
  const Columns matrix = columns(view.to_clip);
  const ScreenScale screen(view.viewport);
  ScreenPlace* to = places_.data();
  for (const glm::vec3& place : surface.places) {
    const Float4 clip = product(matrix, place.x, place.y, place.z, 1);
    const Float4 w = splat(clip[3]);
    const Int4 above = clip > w, below = clip < -w;
    const float inverse = 1 / clip[3];
    to->x = clip[0] * inverse * screen.half_width + screen.center_x;
    to->y = clip[1] * inverse * screen.half_height + screen.center_y;
    const bool safe =
        clip[3] > 1e-30f && !below[2] && std::abs(to->x) < kFar && std::abs(to->y) < kFar;
    to->flags = static_cast<std::uint32_t>((above[0] & 1) | (above[1] & 2) | (above[2] & 4) |
                                           (below[0] & 8) | (below[1] & 16) | (below[2] & 32)) |
                (safe ? 0u : std::uint32_t{kUnsafe});
    ++to;
  }
}

bool VisibleTriangles::is_dropped(const ScreenPlace& a, const ScreenPlace& b, const ScreenPlace& c,
                                  const SurfaceView& view) {
  if ((a.flags | b.flags | c.flags) & kUnsafe) return false;
  const ScreenTriangle<ScreenPlace> triangle{a, b, c};
  if (!triangle.has_side()) return false;
  return triangle.area > 0 ? view.drops_counterclockwise : view.drops_clockwise;
}

bool VisibleTriangles::may_cover(const ScreenPlace& a, const ScreenPlace& b, const ScreenPlace& c) {
  if (a.flags & b.flags & c.flags & kBeyondAnyPlane) return false;
  if ((a.flags | b.flags | c.flags) & kUnsafe) return true;
  return ScreenTriangle<ScreenPlace>{a, b, c}.may_cover_sample();
}

void VisibleTriangles::append(const Surface& surface, const SurfaceView& view,
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
