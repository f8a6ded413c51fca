#include "cpu_pipeline/feedback.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "cpu_pipeline/lit_vertex.hpp"
#include "cpu_pipeline/texture_coordinates.hpp"
#include "cpu_pipeline/view_volume.hpp"
#include "execute/lighting_setters.hpp"
#include "geometry/polygon_triangles.hpp"
#include "geometry/unfilled.hpp"
#include "geometry/window_coordinates.hpp"
#include "record/pending.hpp"

namespace legacy_gl {

namespace {

struct Vertex {
  glm::vec4 clip{0};
  std::array<glm::vec4, 2> colors{};  ///< of the front and the back face
  glm::vec4 texture{0};
  bool edge = true;  ///< to the next vertex of a polygon
};

/// GL 2.1 spec 2.14.8.
Vertex between(const Vertex& a, const Vertex& b, float part) {
  Vertex v;
  v.clip = glm::mix(a.clip, b.clip, part);
  for (unsigned face = 0; face < 2; ++face)
    v.colors[face] = glm::mix(a.colors[face], b.colors[face], part);
  v.texture = glm::mix(a.texture, b.texture, part);
  return v;
}

class Feedback {
 public:
  explicit Feedback(Context& context)
      : context_(context),
        polygon_state_(context.raster.polygon),
        planes_(clipping_planes(context)),
        flat_(context.lighting.shade_model == GL_FLAT),
        two_side_(context.lighting.enabled && context.lighting.model.two_side) {
    const Recorder& recorder = context.recorder;
    const glm::mat4 to_clip =
        context.transform.projection.top().single * context.transform.modelview.top().single;
    latch_color_material(context);
    vertices_.reserve(recorder.vertex_count());
    for (std::uint32_t i = 0; i < recorder.vertex_count(); ++i)
      vertices_.push_back(
          read(recorder.data() + std::size_t{i} * recorder.offsets().stride, to_clip));
  }

  void run(const PrimitiveRun& run) {
    const auto at = [&](std::uint32_t i) -> const Vertex& {
      return vertices_[run.indexed ? context_.recorder.elements()[run.first + i] : run.first + i];
    };
    const std::uint32_t n = run.count;
    switch (run.mode) {
      case GL_POINTS:
        for (std::uint32_t i = 0; i < n; ++i) clipped_point(at(i));
        break;
      case GL_LINES:
        for (std::uint32_t i = 0; i + 1 < n; i += 2) clipped_line(at(i), at(i + 1), true);
        break;
      case GL_LINE_LOOP:
      case GL_LINE_STRIP:
        for (std::uint32_t i = 0; i + 1 < n; ++i) clipped_line(at(i), at(i + 1), i == 0);
        if (run.mode == GL_LINE_LOOP) clipped_line(at(n - 1), at(0), false);
        break;
      default: {
        const bool flagged = uses_edge_flags(run.mode);
        for_each_triangle(run.mode, n,
                          [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, unsigned edges) {
                            if (edges & kEdgeCA)
                              begins_polygon_ = true;  // only the first triangle has it
                            triangle({at(a), at(b), at(c)}, edges, flagged);
                          });
      }
    }
  }

 private:
  using Polygon = std::vector<Vertex>;

  Vertex read(const float* p, const glm::mat4& to_clip) const {
    const Recorder& recorder = context_.recorder;
    const VertexLayout& layout = recorder.layout();
    const VertexOffsets& offsets = recorder.offsets();
    const glm::vec4 position(p[0], p[1], p[2], offsets.position_size == 4 ? p[3] : 1);
    const auto vec3_at = [p](unsigned at) { return glm::vec3(p[at], p[at + 1], p[at + 2]); };
    const auto vec4_at = [&](unsigned at) { return glm::vec4(vec3_at(at), p[at + 3]); };
    const glm::vec3 normal =
        layout.fields & kFieldNormal ? vec3_at(offsets.normal) : context_.current.normal;
    Vertex v;
    v.clip = to_clip * position;
    if (layout.fields & kFieldEdgeFlag) v.edge = p[offsets.edge_flag] != 0;
    const FeedbackState& feedback = context_.feedback;
    if (feedback.has_texture()) {
      const unsigned at = offsets.texcoords[0];
      v.texture = transformed_texture_coordinates(context_, 0, position, normal, vec4_at(at));
    }
    if (!feedback.has_color()) return v;
    const glm::vec4 color =
        layout.fields & kFieldColor ? vec4_at(offsets.color) : context_.current.color;
    if (!context_.lighting.enabled) {
      v.colors[kFront] = glm::clamp(color, 0.0f, 1.0f);  // GL 2.1 spec 2.14.6
      return v;
    }
    const Materials materials = materials_of(p, color);
    for (const unsigned face : {kFront, kBack})
      if (face == kFront || two_side_)
        v.colors[face] = light_vertex(context_, materials, position, normal, face).primary;
    return v;
  }

  /// Those that the vertex carries, and that follow its colour.
  Materials materials_of(const float* p, const glm::vec4& color) const {
    const Recorder& recorder = context_.recorder;
    Materials materials = context_.lighting.materials;
    const MaterialMask tracked = tracked_materials(context_);
    for (unsigned i = 0; i < 2 * kPropertyCount; ++i) {
      const unsigned face = i / kPropertyCount, property = i % kPropertyCount;
      glm::vec4 value = material_value(materials, face, property);
      if (tracked & 1u << i) value = color;
      else if (recorder.layout().materials & 1u << i)
        for (unsigned c = 0; c < material_size(property); ++c)
          value[static_cast<int>(c)] = p[recorder.offsets().materials[i] + c];
      store_material_value(materials, face, property, value);
    }
    return materials;
  }

  void clipped_point(const Vertex& v) {
    for (const glm::vec4& plane : planes_)
      if (!(glm::dot(plane, v.clip) >= 0)) return;
    point(v, kFront);
  }

  void clipped_line(const Vertex& a, const Vertex& b, bool resets) {
    float from = 0, until = 1;
    for (const glm::vec4& plane : planes_) {
      const float at_a = glm::dot(plane, a.clip), at_b = glm::dot(plane, b.clip);
      if (!(at_a >= 0) && !(at_b >= 0)) return;
      if (at_a < 0) from = std::max(from, at_a / (at_a - at_b));
      if (at_b < 0) until = std::min(until, at_a / (at_a - at_b));
    }
    if (from > until) return;
    Vertex first = from > 0 ? between(a, b, from) : a,
           second = until < 1 ? between(a, b, until) : b;
    if (flat_) first.colors = second.colors = b.colors;
    line(first, second, kFront, resets);
  }

  void triangle(const std::array<Vertex, 3>& corners, unsigned edges, bool flagged) {
    const double area =
        signed_area(context_.raster.viewport, corners[0].clip, corners[1].clip, corners[2].clip) *
        (polygon_state_.front_face == GL_CCW ? 1 : -1);
    const bool back = !(area > 0);  // row M11
    if (polygon_state_.cull_enabled &&
        polygon_state_.cull_face != (back ? GLenum{GL_FRONT} : GLenum{GL_BACK}))
      return;
    polygon_.assign(corners.begin(), corners.end());
    for (unsigned i = 0; i < 3; ++i) {
      polygon_[i].edge = (edges >> i & 1) && (!flagged || corners[i].edge);
      if (flat_) polygon_[i].colors = corners[2].colors;
    }
    mode_ = back ? polygon_state_.back_mode : polygon_state_.front_mode;
    color_ = two_side_ && area < 0 ? kBack : kFront;
    if (!clip_polygon()) return piece(polygon_[0], polygon_[1], polygon_[2], true, true);
    const std::size_t n = polygon_.size();
    for (std::size_t i = 2; i < n; ++i)  // the first vertex is the last of each
      piece(polygon_[i - 1], polygon_[i], polygon_[0], i + 1 == n, i == 2);
  }

  /// Whether anything was cut off.
  bool clip_polygon() {
    bool changed = false;
    for (std::size_t p = 0; p < planes_.size(); ++p) {
      const glm::vec4& plane = planes_[p];
      clipped_.clear();
      const std::size_t n = polygon_.size();
      for (std::size_t i = 0; i < n; ++i) {
        const Vertex &a = polygon_[i], &b = polygon_[(i + 1) % n];
        const float at_a = glm::dot(plane, a.clip), at_b = glm::dot(plane, b.clip);
        if (at_a >= 0) clipped_.push_back(a);
        else changed = true;
        if ((at_a >= 0) == (at_b >= 0)) continue;
        clipped_.push_back(between(a, b, at_a / (at_a - at_b)));
        // Leaving, the next edge lies in the plane: seen in a clip plane, not in the view volume
        // (row D10). Coming back, it goes on as it was.
        clipped_.back().edge = at_a >= 0 ? p >= kViewVolumePlanes : a.edge;
      }
      polygon_.swap(clipped_);
    }
    return changed;
  }

  /// A triangle a, b, c of a polygon, whose edge from b to c and from c to a may be inner ones.
  void piece(const Vertex& a, const Vertex& b, const Vertex& c, bool last, bool first) {
    const bool ab = a.edge, bc = last && b.edge, ca = first && c.edge;
    switch (mode_) {
      case GL_FILL:
        context_.feedback.put_token(GL_POLYGON_TOKEN);
        context_.feedback.put(3);
        for (const Vertex* v : {&a, &b, &c}) put(*v, color_);
        break;
      case GL_LINE:
        if (ca) edge(c, a);
        if (ab) edge(a, b);
        if (bc) edge(b, c);
        break;
      default:
        if (ab) point(a, color_);
        if (bc) point(b, color_);
        if (ca) point(c, color_);
    }
  }

  /// GL 2.1 spec 3.5.4: the first one of a polygon starts its stipple anew.
  void edge(const Vertex& a, const Vertex& b) {
    line(a, b, color_, begins_polygon_);
    begins_polygon_ = false;
  }

  void point(const Vertex& v, unsigned color) {
    context_.feedback.put_token(GL_POINT_TOKEN);
    put(v, color);
  }

  void line(const Vertex& a, const Vertex& b, unsigned color, bool resets) {
    context_.feedback.put_token(resets ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN);
    put(a, color);
    put(b, color);
  }

  void put(const Vertex& v, unsigned color) {
    context_.feedback.put_vertex(glm::vec4(to_window(context_.raster.viewport, v.clip), v.clip.w),
                                 v.colors[color], v.texture);
  }

  Context& context_;
  const PolygonState& polygon_state_;
  std::vector<glm::vec4> planes_;
  bool flat_, two_side_;
  std::vector<Vertex> vertices_;  ///< of the batch
  Polygon polygon_, clipped_;
  GLenum mode_ = GL_FILL;    ///< of the polygon
  unsigned color_ = kFront;  ///< the face that colours it
  bool begins_polygon_ = true;
};

}  // namespace

void feed_back_recorded(Context& context) {
  if (!context.recorder.runs().empty()) {
    Feedback feedback(context);
    for (const PrimitiveRun& run : context.recorder.runs()) feedback.run(run);
  }
  context.recorder.clear();
}

void feed_back_raster_position(Context& context, GLenum token) {
  flush_pending(context);
  const RasterPosition& raster = context.current.raster;
  context.feedback.put_token(token);
  context.feedback.put_vertex(raster.position, raster.color, raster.texture_coordinates[0]);
}

}  // namespace legacy_gl
