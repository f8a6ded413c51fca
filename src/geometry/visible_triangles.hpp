#pragma once
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "geometry/surface.hpp"
#include "state/raster.hpp"

namespace legacy_gl {

/// How the places of a surface become samples of the framebuffer.
struct SurfaceView {
  glm::mat4 to_clip{1.0f};
  ViewportState viewport;
  /// Sides that are not drawn, in window coordinates.
  bool drops_clockwise = false, drops_counterclockwise = false;
  /// Of the dropped sides those stay that touch one that is drawn: on the outline, within a few
  /// hundredths of a pixel, a driver may still show them.
  bool keeps_outline = false;
  bool operator==(const SurfaceView&) const = default;
};

/// Finds the triangles that may cover a sample of the framebuffer: not beyond a clip plane, not a
/// dropped side, not between the samples. A driver that computes on the CPU spends most of a scene
/// of many small triangles on the others. In doubt a triangle counts as seen.
class VisibleTriangles {
 public:
  /// Appends the vertices of the triangles that may be seen, in their order.
  void append(const Surface& surface, const SurfaceView& view, std::vector<std::uint32_t>& indices);

 private:
  struct ScreenPlace {
    float x, y;  ///< in window coordinates, where samples are at whole numbers
    std::uint32_t flags;
  };

  void project(const Surface& surface, const SurfaceView& view);
  static bool is_dropped(const ScreenPlace& a, const ScreenPlace& b, const ScreenPlace& c,
                         const SurfaceView& view);
  static bool may_cover(const ScreenPlace& a, const ScreenPlace& b, const ScreenPlace& c);

  std::vector<ScreenPlace> places_;
  std::vector<std::uint8_t> dropped_;  ///< for each triangle
};

}  // namespace legacy_gl
