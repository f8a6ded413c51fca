#include "geometry/visible_object.hpp"

#include <limits>
#include <numeric>

namespace legacy_gl {

namespace {

/// Rounding may move the outline by so much, in pixels, and depths by so many values.
constexpr float kMoved = 1.0f / 256;
constexpr double kRoundedDepths = 8;
/// Where more than these samples would be next to the outline, in pixels, all sides are drawn.
constexpr float kMostReach = 0.25f;

/// The nearest whole number.
Float4 round_of(const Float4& coordinate) {
  constexpr float kShift = 12582912;  // 1.5 * 2^23
  return (coordinate + kShift) - kShift;
}

}  // namespace

bool VisibleObject::project(const ObjectSurface& surface, const Float4* clip, const View& view) {
  const std::size_t count = surface.places.size();
  places_.resize(count);
  Float4 lowest = splat(std::numeric_limits<float>::infinity()), highest = -lowest;
  Int4 safe{-1, -1, -1, -1};
  const Float4 scale{view.screen.half_width, view.screen.half_height, 1, 0};
  const Float4 center{view.screen.center_x, view.screen.center_y, 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const Float4 window = clip[i] * splat(1 / clip[i][3]) * scale + center;
    safe &= (window < kFar) & (window > -kFar);  // no for what is no number
    lowest = least(lowest, window);
    highest = greatest(highest, window);
    places_[i] = {window[0], window[1]};
  }
  const Float4 size = highest - lowest;
  // Of two sides that meet at the outline one is in front of the other by more, the farther from
  // it.
  const double pixels = std::max({1.0f, size[0], size[1]});
  const double depths = double{size[2]} * view.depth_steps * double{surface.thickness};
  reach_ = kMoved + static_cast<float>(std::min(kRoundedDepths * pixels / depths, 1.0));
  return safe[0] && safe[1] && safe[2];
}

/// The samples that are within reach_ of the way from a to b.
void VisibleObject::add_samples_near(const Place& a, const Place& b) {
  const float dx = b.x - a.x, dy = b.y - a.y;
  const bool steep = std::abs(dy) > std::abs(dx);
  const float from = steep ? a.y : a.x, to = steep ? b.y : b.x;  // along the longer axis
  const float start = steep ? a.x : a.y;
  const float slope = to == from ? 0 : (steep ? dx : dy) / (to - from);
  const int first = floor_of(std::min(from, to) - reach_) + 1;
  const int last = floor_of(std::max(from, to) + reach_);
  const Float4 steps{0, 1, 2, 3};
  const float reach = 1.5f * reach_;  // across the axis: the way may be a diagonal
  for (int at = first; at <= last; at += 4) {
    const Float4 along = static_cast<float>(at) + steps;
    const Float4 across = start + (along - from) * slope;
    const Float4 sample = round_of(across), distance = across - sample;
    const Int4 near =
        (distance < reach) & (distance > -reach) & (along <= static_cast<float>(last));
    if (!(near[0] | near[1] | near[2] | near[3])) continue;
    for (int i = 0; i < 4; ++i)
      if (near[i])
        near_samples_.push_back(steep ? Place{sample[i], along[i]} : Place{along[i], sample[i]});
  }
}

bool VisibleObject::may_cover_near_sample(const ScreenTriangle<Place>& triangle) const {
  return std::any_of(near_samples_.begin(), near_samples_.end(),
                     [&](const Place& sample) { return triangle.may_contain(sample.x, sample.y); });
}

void VisibleObject::find_hidden(const ObjectSurface& surface, Surface::Winding hidden) {
  const std::size_t count = surface.triangles.size();
  hidden_.resize(count);
  const float turn = hidden == Surface::Winding::kCounterclockwise ? 1.0f : -1.0f;
  for (std::size_t t = 0; t < count; ++t) {
    const ScreenTriangle<Place> shape = triangle(surface, t);
    hidden_[t] = turn * shape.area > 0 && shape.has_side();
  }
  near_samples_.clear();
  for (const ObjectSurface::Edge& edge : surface.edges)
    if (hidden_[edge.left] != hidden_[edge.right])
      add_samples_near(places_[edge.a], places_[edge.b]);
  if (near_samples_.empty()) return;
  for (std::size_t t = 0; t < count; ++t)
    if (hidden_[t] && may_cover_near_sample(triangle(surface, t))) hidden_[t] = 0;
}

const std::vector<std::uint16_t>& VisibleObject::find(const ObjectSurface& surface,
                                                      const Float4* clip, const View& view) {
  if (!project(surface, clip, view)) return all(surface);
  const std::size_t count = surface.triangles.size();
  if (reach_ < kMostReach && view.hidden != Surface::Winding::kOpen)
    find_hidden(surface, view.hidden);
  else hidden_.assign(count, 0);
  seen_.resize(count);
  std::uint16_t* to = seen_.data();
  for (std::size_t t = 0; t < count; ++t)
    if (!hidden_[t] && triangle(surface, t).may_cover_sample())
      *to++ = static_cast<std::uint16_t>(t);
  seen_.resize(static_cast<std::size_t>(to - seen_.data()));
  return seen_;
}

const std::vector<std::uint16_t>& VisibleObject::all(const ObjectSurface& surface) {
  seen_.resize(surface.triangles.size());
  std::iota(seen_.begin(), seen_.end(), std::uint16_t{0});
  return seen_;
}

}  // namespace legacy_gl
