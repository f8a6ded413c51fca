#include "cpu_pipeline/selection.hpp"

#include <glm/geometric.hpp>
#include <vector>

#include "cpu_pipeline/view_volume.hpp"
#include "geometry/unfilled.hpp"
#include "record/pending.hpp"

namespace legacy_gl {

namespace {

using Polygon = std::vector<glm::vec4>;  ///< clip coordinates

/// Polygons hit as filled ones whatever their mode is: row D22.
class Selector {
 public:
  explicit Selector(Context& context) : context_(context), planes_(clipping_planes(context)) {
    to_clip_ = context.transform.projection.top().single * context.transform.modelview.top().single;
  }

  void run(const PrimitiveRun& run) {
    const std::uint32_t n = run.count;
    switch (run.mode) {
      case GL_POINTS:
        for (std::uint32_t i = 0; i < n; ++i) primitive(run, {i});
        break;
      case GL_LINES:
        for (std::uint32_t i = 0; i + 1 < n; i += 2) primitive(run, {i, i + 1});
        break;
      case GL_LINE_LOOP:
      case GL_LINE_STRIP:
        for (std::uint32_t i = 0; i + 1 < n; ++i) primitive(run, {i, i + 1});
        if (run.mode == GL_LINE_LOOP) primitive(run, {n - 1, 0});
        break;
      case GL_TRIANGLES:
        for (std::uint32_t i = 0; i + 2 < n; i += 3) primitive(run, {i, i + 1, i + 2});
        break;
      case GL_TRIANGLE_STRIP:
        for (std::uint32_t i = 0; i + 2 < n; ++i) primitive(run, {i + i % 2, i + 1 - i % 2, i + 2});
        break;
      case GL_TRIANGLE_FAN:
        for (std::uint32_t i = 1; i + 1 < n; ++i) primitive(run, {0, i, i + 1});
        break;
      case GL_QUADS:
        for (std::uint32_t i = 0; i + 3 < n; i += 4) primitive(run, {i, i + 1, i + 2, i + 3});
        break;
      case GL_QUAD_STRIP:
        for (std::uint32_t i = 0; i + 3 < n; i += 2) primitive(run, {i, i + 1, i + 3, i + 2});
        break;
      default:
        for (std::uint32_t i = 1; i + 1 < n; ++i) primitive(run, {0, i, i + 1});
    }
  }

 private:
  glm::vec4 vertex(const PrimitiveRun& run, std::uint32_t i) const {
    const Recorder& recorder = context_.recorder;
    const std::uint32_t index = run.indexed ? recorder.elements()[run.first + i] : run.first + i;
    const float* const p = recorder.data() + std::size_t{index} * recorder.offsets().stride;
    return to_clip_ * glm::vec4(p[0], p[1], p[2], recorder.offsets().position_size == 4 ? p[3] : 1);
  }

  void primitive(const PrimitiveRun& run, std::initializer_list<std::uint32_t> indices) {
    polygon_.clear();
    for (const std::uint32_t i : indices) polygon_.push_back(vertex(run, i));
    for (const glm::vec4& plane : planes_) clip(plane);
    if (polygon_.empty() || (indices.size() > 2 && is_culled())) return;
    const ViewportState& viewport = context_.raster.viewport;
    for (const glm::vec4& v : polygon_) {
      const double device = static_cast<double>(v.z) / static_cast<double>(v.w);
      context_.selection.add_hit(
          static_cast<float>((viewport.depth_far - viewport.depth_near) * 0.5 * device +
                             (viewport.depth_far + viewport.depth_near) * 0.5));
    }
  }

  /// A point is kept or not; a line and a polygon keep what is on the plane's side.
  void clip(const glm::vec4& plane) {
    clipped_.clear();
    const std::size_t n = polygon_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const glm::vec4 &a = polygon_[i], &b = polygon_[(i + 1) % n];
      const float at_a = glm::dot(plane, a), at_b = glm::dot(plane, b);
      if (at_a >= 0) clipped_.push_back(a);
      if ((at_a >= 0) != (at_b >= 0)) clipped_.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    polygon_.swap(clipped_);
  }

  bool is_culled() const {
    const PolygonState& state = context_.raster.polygon;
    if (!state.cull_enabled) return false;
    if (state.cull_face == GL_FRONT_AND_BACK) return true;
    double area = 0;  // GL 2.1 spec 3.5.1
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const glm::dvec4 a(polygon_[i]), b(polygon_[(i + 1) % polygon_.size()]);
      area += (a.x / a.w) * (b.y / b.w) - (b.x / b.w) * (a.y / a.w);
    }
    const bool front = state.front_face == GL_CCW ? area > 0 : area < 0;
    return front == (state.cull_face == GL_FRONT);
  }

  Context& context_;
  std::vector<glm::vec4> planes_;
  glm::mat4 to_clip_;
  Polygon polygon_, clipped_;
};

}  // namespace

void select_recorded(Context& context) {
  Selector selector(context);
  for (const PrimitiveRun& run : context.recorder.runs()) selector.run(run);
  context.recorder.clear();
}

}  // namespace legacy_gl
