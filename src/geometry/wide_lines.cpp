#include "geometry/wide_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/vec2.hpp>
#include <optional>

#include "geometry/clip_test.hpp"

namespace legacy_gl {

namespace {

/// How far the segment goes in window coordinates, of what is in the view volume; nothing when none
/// of it is. The line is clipped before it is widened (GL 2.1 spec 2.12).
std::optional<glm::vec2> visible_extent(const glm::vec4& a, const glm::vec4& b,
                                        const ViewportState& viewport) {
  const std::optional<VisiblePart> part = visible_part(a, b, {});
  if (!part) return {};
  const glm::vec4 first = a + part->begin * (b - a), last = a + part->end * (b - a);
  if (!(first.w > 0) || !(last.w > 0)) return {};
  const glm::vec2 size(static_cast<float>(viewport.box[2]), static_cast<float>(viewport.box[3]));
  return (glm::vec2(last) / last.w - glm::vec2(first) / first.w) * size / 2.0f;
}

class Widener {
 public:
  Widener(const VertexLayout& layout, const float* vertices, const WideLineState& state,
          std::vector<float>& widened)
      : vertices_(vertices), state_(state), widened_(widened), from_(offsets_of(layout)) {
    has_depth_offset_ = layout.fields & kFieldDepthOffset;
    shared_floats_ = from_.stride - (has_depth_offset_ ? 1 : 0);  // the depth offset is the last
  }

  void segment(std::uint32_t a, std::uint32_t b) {
    const std::optional<glm::vec2> extent = visible_extent(clip(a), clip(b), state_.viewport);
    if (!extent) return;
    const int minor = std::abs(extent->x) >= std::abs(extent->y) ? 1 : 0;
    const float pixel = 2 / static_cast<float>(std::max(state_.viewport.box[minor ? 3 : 2], 1));
    for (unsigned i = 0; i < state_.width; ++i) {
      glm::vec2 offset(0);
      offset[minor] = (static_cast<float>(i) - static_cast<float>(state_.width - 1) / 2) * pixel;
      vertex(a, offset);
      vertex(b, offset);
    }
  }

 private:
  const float* at(std::uint32_t vertex) const {
    return vertices_ + std::size_t{vertex} * from_.stride;
  }

  glm::vec4 clip(std::uint32_t vertex) const {
    const float* const p = at(vertex);
    const glm::mat4& m = state_.modelview_projection;
    return m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3] * (from_.position_size == 4 ? p[3] : 1);
  }

  void vertex(std::uint32_t vertex, const glm::vec2& offset) {
    const float* const from = at(vertex);
    widened_.insert(widened_.end(), from, from + shared_floats_);
    widened_.push_back(offset.x);
    widened_.push_back(offset.y);
    widened_.push_back(has_depth_offset_ ? from[from_.depth_offset] : 0);
  }

  const float* vertices_;
  const WideLineState& state_;
  std::vector<float>& widened_;
  VertexOffsets from_;
  bool has_depth_offset_ = false;
  unsigned shared_floats_ = 0;
};

}  // namespace

VertexLayout widened_layout(const VertexLayout& layout) {
  VertexLayout widened = layout;
  widened.fields &= static_cast<std::uint16_t>(~kFieldDepthOffset);
  widened.fields |= kFieldLineOffset;
  return widened;
}

void widen_lines(const VertexLayout& layout, const float* vertices, GLenum mode,
                 std::span<const std::uint32_t> indices, const WideLineState& state,
                 std::vector<float>& widened) {
  Widener widener(layout, vertices, state, widened);
  const std::size_t step = mode == GL_LINES ? 2 : 1;
  for (std::size_t i = 0; i + 1 < indices.size(); i += step)
    widener.segment(indices[i], indices[i + 1]);
  if (mode == GL_LINE_LOOP && indices.size() > 1) widener.segment(indices.back(), indices.front());
}

}  // namespace legacy_gl
