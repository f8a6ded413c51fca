#include "geometry/line_stipple.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/vec2.hpp>
#include <optional>

#include "geometry/clip_test.hpp"
#include "geometry/wide_lines.hpp"

namespace legacy_gl {

namespace {

/// A few roundings of window coordinates, in parts of the window: so much farther the parts' ends
/// lie, lest one that begins on the edge of a pixel have a fragment of the pixel before.
constexpr float kRounding = 0x1p-22f;

class Cutter {
 public:
  Cutter(const LineStippleState& state, ExpandedBatch& batch)
      : state_(state), batch_(batch), at_(offsets_of(batch.layout)) {
    const std::array<GLint, 4>& box = state.viewport.box;
    past_edge_ = kRounding * static_cast<float>(std::max(box[0] + box[2], box[1] + box[3]));
  }

  void cut_all() {
    if (!state_.lit) clamp_colors();
    batch_.uncut.swap(batch_.indices);
    batch_.indices.clear();
    const std::uint32_t* const restarts_end = batch_.restarts.data() + batch_.restarts.size();
    restart_ = batch_.restarts.data();
    for (PrimitiveGroup& group : batch_.groups) {
      const auto first = static_cast<std::uint32_t>(batch_.indices.size());
      const auto from = batch_.uncut.begin() + group.first;
      if (is_line(group.mode)) cut(group, restarts_end);
      else batch_.indices.insert(batch_.indices.end(), from, from + group.count);
      group.first = first;
      group.count = static_cast<std::uint32_t>(batch_.indices.size()) - first;
    }
  }

 private:
  /// Colours are clamped before lines are cut (GL 2.1 spec 2.14.6, 2.14.8).
  void clamp_colors() {
    const auto clamp = [this](unsigned offset, unsigned size) {
      for (std::size_t at = offset; at < batch_.vertices.size(); at += at_.stride)
        for (std::size_t i = at; i < at + size; ++i)
          batch_.vertices[i] = std::clamp(batch_.vertices[i], 0.0f, 1.0f);
    };
    if (batch_.layout.fields & kFieldColor) clamp(at_.color, 4);
    if (batch_.layout.fields & kFieldSecondaryColor) clamp(at_.secondary_color, 3);
  }

  void cut(PrimitiveGroup& group, const std::uint32_t* restarts_end) {
    fragment_ = 0;
    const std::uint32_t end = group.first + group.count;
    const std::uint32_t step = group.mode == GL_LINES ? 2 : 1;
    for (std::uint32_t i = group.first; i + 1 < end; i += step) {
      if (restart_ != restarts_end && *restart_ == i) {
        fragment_ = 0;
        ++restart_;
      }
      cut(batch_.uncut[i], batch_.uncut[i + 1]);
    }
    if (group.mode == GL_LINE_LOOP && group.count > 1)
      cut(batch_.uncut[end - 1], batch_.uncut[group.first]);
    group.mode = GL_LINES;
  }

  glm::vec4 clip(std::uint32_t vertex) const {
    const float* const p = batch_.vertices.data() + std::size_t{vertex} * at_.stride;
    const glm::mat4& m = state_.modelview_projection;
    return m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3] * (at_.position_size == 4 ? p[3] : 1);
  }

  /// In pixels, from any origin.
  glm::vec2 window(const glm::vec4& clip) const {
    const std::array<GLint, 4>& box = state_.viewport.box;
    return glm::vec2(clip) / clip.w *
           glm::vec2(static_cast<float>(box[2]) / 2, static_cast<float>(box[3]) / 2);
  }

  bool is_drawn(int fragment) const {
    const int bit = fragment / state_.line.stipple_factor & 15;
    return state_.line.stipple_pattern >> bit & 1;
  }

  /// The line is clipped first (GL 2.1 spec 2.12): the pattern begins where it comes into view.
  void cut(std::uint32_t a, std::uint32_t b) {
    const glm::vec4 clip_a = clip(a), clip_b = clip(b);
    const std::optional<VisiblePart> visible = visible_part(clip_a, clip_b, state_.clip_planes);
    if (!visible) return;
    ends_ = {a, b};
    visible_ = *visible;
    const glm::vec4 first = clip_a + visible_.begin * (clip_b - clip_a);
    const glm::vec4 last = visible_.end == 1 ? clip_b : clip_a + visible_.end * (clip_b - clip_a);
    if (!(first.w > 0) || !(last.w > 0)) return;
    w_ = {first.w, last.w};
    const glm::vec2 extent = window(last) - window(first);
    const float length = std::max(std::abs(extent.x), std::abs(extent.y));
    if (!std::isfinite(length)) return;

    const int count = static_cast<int>(std::ceil(length));
    int begin = -1;
    for (int i = 0; i < count; ++i) {
      const bool drawn = is_drawn(fragment_ + i);
      if (drawn && begin < 0) begin = i;
      if (drawn || begin < 0) continue;
      part(begin, i, length);
      begin = -1;
    }
    if (begin >= 0) part(begin, -1, length);
    fragment_ += count;
  }

  /// From one whole distance along the line to another; -1 is the line's end.
  void part(int begin, int end, float length) {
    const auto distance = [=, this](int at) {
      return std::min((static_cast<float>(at) + past_edge_) / length, 1.0f);
    };
    vertex(begin == 0 ? visible_.begin : along_line(distance(begin)));
    vertex(end < 0 ? visible_.end : along_line(distance(end)));
  }

  /// Where on the line from a to b that part of its visible way on the screen is.
  float along_line(float way) const {
    const float part = way * w_[0] / (w_[1] + way * (w_[0] - w_[1]));
    return visible_.begin + part * (visible_.end - visible_.begin);
  }

  void vertex(float t) {
    const std::size_t to = batch_.vertices.size();
    batch_.indices.push_back(static_cast<std::uint32_t>(to / at_.stride));
    batch_.vertices.resize(to + at_.stride);
    const float* const a = batch_.vertices.data() + std::size_t{ends_[0]} * at_.stride;
    const float* const b = batch_.vertices.data() + std::size_t{ends_[1]} * at_.stride;
    float* const target = batch_.vertices.data() + to;
    const auto mix = [=](unsigned first, unsigned size) {
      for (unsigned i = first; i < first + size; ++i)
        target[i] = t == 1 ? b[i] : a[i] + t * (b[i] - a[i]);
    };
    if (!state_.flat) return mix(0, at_.stride);
    std::memcpy(target, b, at_.stride * sizeof(float));
    mix(0, at_.position_size);
    if (batch_.layout.fields & kFieldFogCoord) mix(at_.fog_coord, 1);
    if (batch_.layout.fields & kFieldDepthOffset) mix(at_.depth_offset, 1);
    for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
      if (batch_.layout.texcoords & 1u << unit)
        mix(at_.texcoords[unit], texcoord_size(batch_.layout, unit));
  }

  const LineStippleState& state_;
  ExpandedBatch& batch_;
  VertexOffsets at_;
  const std::uint32_t* restart_ = nullptr;
  float past_edge_ = 0;  ///< in pixels
  int fragment_ = 0;     ///< since the pattern began; each line has a whole number of them
  std::array<std::uint32_t, 2> ends_{};
  VisiblePart visible_;
  std::array<float, 2> w_{};  ///< of the visible part's ends, in clip coordinates
};

}  // namespace

void stipple_lines(const LineStippleState& state, ExpandedBatch& batch) {
  Cutter(state, batch).cut_all();
}

}  // namespace legacy_gl
