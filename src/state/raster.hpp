#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "state/gl_types.hpp"

namespace legacy_gl {

// The state that the core profile still has: we keep it so that glGet and the attribute stack need
// no driver round trip, and hand it on when a draw, a clear or a read needs it.

struct DepthState {
  bool test_enabled = false;
  GLenum function = GL_LESS;
  bool write_mask = true;
  double clear_value = 1;
  bool operator==(const DepthState&) const = default;
};

struct StencilState {
  bool test_enabled = false;
  GLenum function = GL_ALWAYS;
  GLint reference = 0;
  GLuint value_mask = 0xff;  ///< all ones, in as many bits as a stencil buffer has at most
  GLuint write_mask = 0xff;
  GLenum fail = GL_KEEP, depth_fail = GL_KEEP, depth_pass = GL_KEEP;
  GLint clear_value = 0;
  bool operator==(const StencilState&) const = default;
};

struct ColorBufferState {
  bool alpha_test_enabled = false;
  GLenum alpha_function = GL_ALWAYS;
  float alpha_reference = 0;
  bool blend_enabled = false;
  GLenum blend_source_rgb = GL_ONE, blend_source_alpha = GL_ONE;
  GLenum blend_destination_rgb = GL_ZERO, blend_destination_alpha = GL_ZERO;
  GLenum blend_equation = GL_FUNC_ADD;
  glm::vec4 blend_color{0};
  bool logic_op_enabled = false;
  GLenum logic_op = GL_COPY;
  bool dither_enabled = true;
  std::array<bool, 4> write_mask{true, true, true, true};
  glm::vec4 clear_color{0};
  float clear_index = 0;
  GLuint index_mask = ~0u;
  bool index_logic_op_enabled = false;
  GLenum draw_buffer = GL_FRONT;  ///< the context sets it when it knows the framebuffer
  bool operator==(const ColorBufferState&) const = default;
};

struct PolygonState {
  bool cull_enabled = false;
  GLenum cull_face = GL_BACK;
  GLenum front_face = GL_CCW;
  GLenum front_mode = GL_FILL, back_mode = GL_FILL;
  bool offset_fill_enabled = false, offset_line_enabled = false, offset_point_enabled = false;
  float offset_factor = 0, offset_units = 0;
  bool smooth_enabled = false;
  bool stipple_enabled = false;
  bool operator==(const PolygonState&) const = default;
};

/// GL 2.1 spec 3.5.2: the lowest row first, the leftmost pixel in the highest bit. A group of its
/// own.
using PolygonStipple = std::array<std::uint32_t, 32>;

constexpr PolygonStipple full_stipple() {
  PolygonStipple rows{};
  for (std::uint32_t& row : rows) row = ~std::uint32_t{0};
  return rows;
}

/// Some polygons are drawn as lines or points.
inline bool is_unfilled(const PolygonState& polygon) {
  return polygon.front_mode != GL_FILL || polygon.back_mode != GL_FILL;
}

/// GL 2.1 spec 3.3.
struct PointState {
  float size = 1;
  float size_min = 0, size_max = 1;  ///< the context sets the largest size that the driver has
  float fade_threshold = 1;
  glm::vec3 attenuation{1, 0, 0};  ///< a, b, c of 1 / (a + b d + c d^2)
  bool smooth_enabled = false;
  bool operator==(const PointState&) const = default;

  /// The size depends on the distance from the eye.
  bool is_attenuated() const { return attenuation != glm::vec3(1, 0, 0); }
  /// Computed for each point: some may fade if samples are taken several a pixel.
  bool is_attenuated_or_fades() const { return is_attenuated() || clamped_size() < fade_threshold; }
  /// Of a point that is not attenuated.
  float clamped_size() const { return std::min(std::max(size, size_min), size_max); }
};

/// Aliased points are whole pixels wide (GL 2.1 spec 3.3.1); halves go down, as the reference
/// rounds them.
inline float drawn_point_size(const PointState& point) {
  const float size = point.clamped_size();
  return point.smooth_enabled ? size : std::max(1.0f, std::ceil(size - 0.5f));
}

struct LineState {
  float width = 1;
  bool smooth_enabled = false;
  bool stipple_enabled = false;
  GLint stipple_factor = 1;  ///< 1 to 256
  GLushort stipple_pattern = 0xffff;
  bool operator==(const LineState&) const = default;
};

inline bool is_stippled(const LineState& line) {
  return line.stipple_enabled && line.stipple_pattern != 0xffff;
}

/// Aliased lines are whole pixels wide (GL 2.1 spec 3.4.2).
inline unsigned whole_line_width(const LineState& line) {
  constexpr float kMost = 255;
  return static_cast<unsigned>(std::clamp(std::floor(line.width + 0.5f), 1.0f, kMost));
}

struct ScissorState {
  bool test_enabled = false;
  std::array<GLint, 4> box{};  ///< x, y, width, height in window coordinates
  bool operator==(const ScissorState&) const = default;
};

struct ViewportState {
  std::array<GLint, 4> box{};  ///< x, y, width, height in window coordinates
  double depth_near = 0, depth_far = 1;
  bool operator==(const ViewportState&) const = default;
};

struct MultisampleState {
  bool enabled = true;
  bool alpha_to_coverage = false, alpha_to_one = false, coverage = false;
  float coverage_value = 1;
  bool coverage_invert = false;
  bool operator==(const MultisampleState&) const = default;
};

struct HintState {
  GLenum perspective_correction = GL_DONT_CARE, point_smooth = GL_DONT_CARE,
         line_smooth = GL_DONT_CARE, polygon_smooth = GL_DONT_CARE, fog = GL_DONT_CARE,
         generate_mipmap = GL_DONT_CARE, texture_compression = GL_DONT_CARE, phong = GL_DONT_CARE;
  bool operator==(const HintState&) const = default;
};

/// Pixel store modes (GL 2.1 spec 3.6.1, table 3.1): client state.
struct PixelStore {
  GLint alignment = 4, row_length = 0, skip_rows = 0, skip_pixels = 0, image_height = 0,
        skip_images = 0;
  bool swap_bytes = false, lsb_first = false;
  bool operator==(const PixelStore&) const = default;
};

struct RasterState {
  DepthState depth;
  StencilState stencil;
  ColorBufferState color_buffer;
  PolygonState polygon;
  PolygonStipple polygon_stipple = full_stipple();
  PointState point;
  LineState line;
  ScissorState scissor;
  ViewportState viewport;
  MultisampleState multisample;
  bool operator==(const RasterState&) const = default;
};

}  // namespace legacy_gl
