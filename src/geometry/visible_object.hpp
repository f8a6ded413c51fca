#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/float4.hpp"
#include "geometry/object_surface.hpp"
#include "geometry/screen_triangle.hpp"

namespace legacy_gl {

/// Finds the triangles of a small object that may be seen: what VisibleTriangles does for large
/// ones, but exact at the outline. There the two sides of a closed surface meet, and where a sample
/// is so near that rounding decides which is in front, the hidden one stays.
class VisibleObject {
 public:
  struct View {
    ScreenScale screen;
    /// How sides that are not seen are wound in window coordinates; kOpen: both may be seen.
    Surface::Winding hidden = Surface::Winding::kOpen;
    double depth_steps = 0;  ///< of the depth buffer, in one unit of normalised depth
  };

  /// `clip`: the surface's places in clip coordinates, all within the view volume. The result holds
  /// numbers of triangles, in their order, and lasts until the next call.
  const std::vector<std::uint16_t>& find(const ObjectSurface& surface, const Float4* clip,
                                         const View& view);
  /// All its triangles, as the result of find.
  const std::vector<std::uint16_t>& all(const ObjectSurface& surface);

 private:
  struct Place {
    float x, y;
  };

  /// False where a place has no window coordinates that one can reckon with.
  bool project(const ObjectSurface& surface, const Float4* clip, const View& view);
  void find_hidden(const ObjectSurface& surface, Surface::Winding hidden);
  void add_samples_near(const Place& a, const Place& b);
  ScreenTriangle<Place> triangle(const ObjectSurface& surface, std::size_t t) const {
    const auto& [a, b, c] = surface.triangles[t];
    return {places_[a], places_[b], places_[c]};
  }
  bool may_cover_near_sample(const ScreenTriangle<Place>& triangle) const;

  float reach_ = 0;  ///< in pixels: samples so near to the outline may show either side
  std::vector<Place> places_;
  std::vector<std::uint8_t> hidden_;  ///< for each triangle
  std::vector<Place> near_samples_;   ///< samples next to the outline
  std::vector<std::uint16_t> seen_;
};

}  // namespace legacy_gl
