#include "geometry/unfilled.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "geometry/polygon_triangles.hpp"
#include "geometry/window_coordinates.hpp"

namespace legacy_gl {

namespace {

bool joins_with_next(GLenum mode) {
  return mode == GL_POINTS || mode == GL_LINES || mode == GL_TRIANGLES;
}

struct Triangle {
  std::array<std::uint32_t, 3> vertex;  ///< of the batch
  unsigned edges;
};

/// Which side of its polygon each edge of a triangle is, AB, BC and CA, counted from the polygon's
/// first vertex. Triangles are as for_each_triangle gives them. Polygons of many sides come in
/// their order: CA, AB, BC.
using Sides = std::array<unsigned, 3>;
Sides sides_of(GLenum mode, bool first_triangle) {
  constexpr unsigned kInner = 0;
  switch (mode) {
    case GL_QUADS: return first_triangle ? Sides{0, kInner, 3} : Sides{1, 2, kInner};
    case GL_QUAD_STRIP: return first_triangle ? Sides{3, kInner, 2} : Sides{0, 1, kInner};
    case GL_POLYGON: return {1, 2, 0};
    default: return {0, 1, 2};
  }
}

/// Of GL_POLYGON each triangle's sides follow those of the one before.
bool ends_polygon(GLenum mode, bool first_triangle) {
  return (mode != GL_QUADS && mode != GL_QUAD_STRIP) || !first_triangle;
}

double determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
         a.z * (b.x * c.y - b.y * c.x);
}

class Expander {
 public:
  Expander(const VertexBatch& batch, const UnfilledState& state, ExpandedBatch& expanded)
      : batch_(batch), state_(state), out_(expanded), from_(offsets_of(batch.layout)) {
    const PolygonState& polygon = state.polygon;
    culls_[0] = polygon.cull_enabled && polygon.cull_face != GL_BACK;
    culls_[1] = polygon.cull_enabled && polygon.cull_face != GL_FRONT;
    modes_ = {polygon.front_mode, polygon.back_mode};
    for (unsigned face = 0; face < 2; ++face)
      offset_[face] = (modes_[face] == GL_LINE && polygon.offset_line_enabled) ||
                      (modes_[face] == GL_POINT && polygon.offset_point_enabled);
    const bool offset = offset_[0] || offset_[1];
    needs_facing_ = modes_[0] != modes_[1] || culls_[0] != culls_[1] || state.two_side;
    if (needs_facing_ || offset) transform_vertices();

    out_.layout = batch.layout;
    out_.layout.fields &= static_cast<std::uint16_t>(~kFieldEdgeFlag);
    if (state.lighting_position) out_.layout.fields |= kFieldLightingPosition;
    if (offset) out_.layout.fields |= kFieldDepthOffset;
    out_.own_vertices = state.flat || offset;
    to_ = offsets_of(out_.layout);
    shared_floats_ = from_.stride - (batch.layout.fields & kFieldEdgeFlag ? 1 : 0);
    out_.vertices.clear();
    out_.indices.clear();
    out_.groups.clear();
    out_.restarts.clear();
  }

  void expand(const PrimitiveRun& run) {
    const auto vertex = [&](std::uint32_t k) {
      return run.indexed ? batch_.elements[run.first + k] : run.first + k;
    };
    if (!is_polygonal(run.mode)) {
      open_group(run.mode, false);
      for (std::uint32_t k = 0; k < run.count; ++k) {
        restarts_ = run.mode == GL_LINES && k % 2 == 0;
        note_restart();
        add_index(corner(vertex(k), vertex(k), 0));
      }
      return;
    }
    const bool flagged = uses_edge_flags(run.mode) && batch_.layout.fields & kFieldEdgeFlag;
    for_each_triangle(run.mode, run.count,
                      [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, unsigned edges) {
                        Triangle triangle{{vertex(a), vertex(b), vertex(c)}, edges};
                        const bool first = edges & kEdgeCA;
                        restarts_ = restarts_ || first;
                        if (state_.line_stipple) sides_ = sides_of(run.mode, first);
                        if (flagged) drop_unflagged(triangle);
                        expand(triangle);
                        if (state_.line_stipple && ends_polygon(run.mode, first)) add_held_lines();
                      });
  }

 private:
  void transform_vertices() {
    out_.clip.resize(batch_.vertex_count);
    const glm::mat4& m = state_.modelview_projection;
    for (std::uint32_t i = 0; i < batch_.vertex_count; ++i) {
      const float* const p = batch_.vertices + std::size_t{i} * from_.stride;
      const float w = from_.position_size == 4 ? p[3] : 1;
      out_.clip[i] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3] * w;
    }
  }

  void drop_unflagged(Triangle& triangle) const {
    for (unsigned i = 0; i < 3; ++i)
      if (batch_.vertices[std::size_t{triangle.vertex[i]} * from_.stride + from_.edge_flag] == 0)
        triangle.edges &= ~(1u << i);
  }

  /// Positive for front faces.
  double facing(const Triangle& triangle) const {
    const double area = signed_area(state_.viewport, out_.clip[triangle.vertex[0]],
                                    out_.clip[triangle.vertex[1]], out_.clip[triangle.vertex[2]]);
    return state_.polygon.front_face == GL_CCW ? area : -area;
  }

  /// GL 2.1 spec 3.5.5: m * factor + r * units, in window depth.
  double depth_offset(const Triangle& triangle) const {
    std::array<glm::dvec4, 3> window;  // homogeneous
    const ViewportState& viewport = state_.viewport;
    for (unsigned i = 0; i < 3; ++i) {
      const glm::dvec4 clip(out_.clip[triangle.vertex[i]]);
      window[i] = {clip.x * viewport.box[2] / 2, clip.y * viewport.box[3] / 2,
                   clip.z * (viewport.depth_far - viewport.depth_near) / 2, clip.w};
    }
    const auto of = [&](unsigned x, unsigned y) {
      const auto row = [&](unsigned i) {
        return glm::dvec3(window[i][static_cast<int>(x)], window[i][static_cast<int>(y)],
                          window[i].w);
      };
      return determinant(row(0), row(1), row(2));
    };
    const double area = of(0, 1);
    const double slope =
        area == 0 ? 0 : std::max(std::abs(of(2, 1)), std::abs(of(0, 2))) / std::abs(area);
    return slope * static_cast<double>(state_.polygon.offset_factor) +
           state_.depth_resolution * static_cast<double>(state_.polygon.offset_units);
  }

  /// The offset of one vertex in normalised device coordinates: its depth stays in the depth range.
  float clamped_offset(std::uint32_t vertex, double offset) const {
    const ViewportState& viewport = state_.viewport;
    const double range = (viewport.depth_far - viewport.depth_near) / 2;
    const glm::vec4& clip = out_.clip[vertex];
    if (range == 0) return 0;
    const double moved = offset / range;
    if (!(clip.w > 0) || std::abs(clip.z) > clip.w) return static_cast<float>(moved);
    const double depth = static_cast<double>(clip.z) / static_cast<double>(clip.w);
    return static_cast<float>(std::clamp(depth + moved, -1.0, 1.0) - depth);
  }

  void expand(const Triangle& triangle) {
    // No area is a back face, but the reference colours it as a front face.
    const double face = needs_facing_ ? facing(triangle) : 1;
    const bool back = !(face > 0), back_color = state_.two_side && face < 0;
    const GLenum mode = modes_[back];
    if (mode != GL_FILL && (culls_[back] || !triangle.edges)) return;
    const double offset = offset_[back] ? depth_offset(triangle) : 0;
    std::array<std::uint32_t, 3> index;
    for (unsigned i = 0; i < 3; ++i)
      index[i] = corner(triangle.vertex[i], triangle.vertex[2], offset);
    switch (mode) {
      case GL_FILL:
        open_group(GL_TRIANGLES, false);
        for (unsigned i = 0; i < 3; ++i) add_index(index[i]);
        break;
      case GL_LINE:
        for (const unsigned i : {2u, 0u, 1u})
          if (triangle.edges & 1u << i)
            add_edge(i, {index[i], index[(i + 1) % 3], back_color, true});
        break;
      default:
        open_group(GL_POINTS, back_color);
        for (unsigned i = 0; i < 3; ++i)
          if (triangle.edges & 1u << i) add_index(index[i]);
    }
  }

  /// The index of `vertex` as one of a polygon that `provoking` colours where shading is flat.
  std::uint32_t corner(std::uint32_t vertex, std::uint32_t provoking, double offset) {
    if (!out_.own_vertices) return vertex;
    const std::size_t at = out_.vertices.size();
    out_.vertices.resize(at + to_.stride);
    float* const to = out_.vertices.data() + at;
    const float* const position = batch_.vertices + std::size_t{vertex} * from_.stride;
    const float* const colored =
        state_.flat ? batch_.vertices + std::size_t{provoking} * from_.stride : position;
    std::memcpy(to, colored, shared_floats_ * sizeof(float));
    std::memcpy(to, position, from_.position_size * sizeof(float));
    if (state_.flat && batch_.layout.texcoords)
      for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
        if (batch_.layout.texcoords & 1u << unit)
          std::memcpy(to + to_.texcoords[unit], position + from_.texcoords[unit],
                      texcoord_size(batch_.layout, unit) * sizeof(float));
    if (out_.layout.fields & kFieldLightingPosition)
      std::memcpy(to + to_.lighting_position, colored, from_.position_size * sizeof(float));
    if (out_.layout.fields & kFieldDepthOffset)
      to[to_.depth_offset] = offset == 0 ? 0 : clamped_offset(vertex, offset);
    return static_cast<std::uint32_t>(at / to_.stride);
  }

  void open_group(GLenum mode, bool back) {
    if (!out_.groups.empty() && joins_with_next(mode) && out_.groups.back().mode == mode &&
        out_.groups.back().back == back)
      return;
    out_.groups.push_back({mode, back, static_cast<std::uint32_t>(out_.indices.size()), 0});
  }

  void add_index(std::uint32_t index) {
    out_.indices.push_back(index);
    ++out_.groups.back().count;
  }

  /// The next line is the first that the pattern of lines goes along.
  void note_restart() {
    if (restarts_ && state_.line_stipple)
      out_.restarts.push_back(static_cast<std::uint32_t>(out_.indices.size()));
    restarts_ = false;
  }

  struct Line {
    std::uint32_t from, to;
    bool back_color, drawn;
  };

  void add_line(const Line& line) {
    open_group(GL_LINES, line.back_color);
    note_restart();
    add_index(line.from);
    add_index(line.to);
  }

  /// The pattern goes along the edges from the polygon's first vertex on (GL 2.1 spec 3.5.4).
  void add_edge(unsigned edge, const Line& line) {
    if (state_.line_stipple) held_[sides_[edge]] = line;
    else add_line(line);
  }

  void add_held_lines() {
    for (Line& line : held_)
      if (std::exchange(line.drawn, false)) add_line(line);
  }

  const VertexBatch& batch_;
  const UnfilledState& state_;
  ExpandedBatch& out_;
  VertexOffsets from_, to_;
  unsigned shared_floats_ = 0;     ///< at the start of a vertex, in both layouts
  std::array<GLenum, 2> modes_{};  ///< by face: front, back
  std::array<bool, 2> culls_{}, offset_{};
  bool needs_facing_ = false;
  bool restarts_ = false;
  Sides sides_{};               ///< of the triangle, for its edges
  std::array<Line, 4> held_{};  ///< lines of a polygon whose pattern goes along its sides
};

}  // namespace

bool is_polygonal(GLenum mode) { return mode >= GL_TRIANGLES && mode <= GL_POLYGON; }

void expand_unfilled(const VertexBatch& batch, const UnfilledState& state,
                     ExpandedBatch& expanded) {
  Expander expander(batch, state, expanded);
  for (const PrimitiveRun& run : batch.runs) expander.expand(run);
}

}  // namespace legacy_gl
