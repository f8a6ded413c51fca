#pragma once
#include <glm/vec4.hpp>
#include <vector>

#include "driver/read_pixels.hpp"

namespace legacy_gl {

/// The accumulation buffer (GL 2.1 spec 4.2.4): floats of our own, since drivers have none. It
/// grows to what it is asked for.
class AccumulationBuffer {
 public:
  void clear(const PixelRectangle& area, const glm::vec4& value);
  /// GL_LOAD and GL_ACCUM: `colors` of the area, four floats each.
  void load(const PixelRectangle& area, const std::vector<float>& colors, float factor);
  void add(const PixelRectangle& area, const std::vector<float>& colors, float factor);
  /// GL_MULT and GL_ADD.
  void scale_and_bias(const PixelRectangle& area, float scale, float bias);
  /// GL_RETURN: clamped to [0, 1].
  std::vector<float> scaled(const PixelRectangle& area, float factor);

 private:
  /// The first value of each row of the area.
  template <typename Row>
  void for_each_row(const PixelRectangle& area, Row row);
  void grow(const PixelRectangle& area);

  GLsizei width_ = 0, height_ = 0;
  std::vector<float> values_;
};

}  // namespace legacy_gl
