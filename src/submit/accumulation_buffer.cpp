#include "submit/accumulation_buffer.hpp"

#include <algorithm>

namespace legacy_gl {

void AccumulationBuffer::grow(const PixelRectangle& area) {
  const GLsizei width = std::max(width_, area.x + area.width);
  const GLsizei height = std::max(height_, area.y + area.height);
  if (width == width_ && height == height_) return;
  const auto row = [](GLsizei pixels) { return static_cast<std::size_t>(pixels) * 4; };
  std::vector<float> values(row(width) * static_cast<std::size_t>(height));
  for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y)
    std::copy_n(values_.data() + y * row(width_), row(width_), values.data() + y * row(width));
  values_ = std::move(values);
  width_ = width;
  height_ = height;
}

template <typename Row>
void AccumulationBuffer::for_each_row(const PixelRectangle& area, Row row) {
  grow(area);
  for (GLsizei y = 0; y < area.height; ++y) {
    const std::size_t first =
        static_cast<std::size_t>(area.y + y) * static_cast<std::size_t>(width_) +
        static_cast<std::size_t>(area.x);
    row(static_cast<std::size_t>(y), values_.data() + 4 * first,
        static_cast<std::size_t>(area.width) * 4);
  }
}

void AccumulationBuffer::clear(const PixelRectangle& area, const glm::vec4& value) {
  for_each_row(area, [&](std::size_t, float* values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) values[i] = value[static_cast<int>(i % 4)];
  });
}

void AccumulationBuffer::load(const PixelRectangle& area, const std::vector<float>& colors,
                              float factor) {
  for_each_row(area, [&](std::size_t y, float* values, std::size_t count) {
    const float* const from = colors.data() + y * count;
    for (std::size_t i = 0; i < count; ++i) values[i] = factor * from[i];
  });
}

void AccumulationBuffer::add(const PixelRectangle& area, const std::vector<float>& colors,
                             float factor) {
  for_each_row(area, [&](std::size_t y, float* values, std::size_t count) {
    const float* const from = colors.data() + y * count;
    for (std::size_t i = 0; i < count; ++i) values[i] += factor * from[i];
  });
}

void AccumulationBuffer::scale_and_bias(const PixelRectangle& area, float scale, float bias) {
  for_each_row(area, [&](std::size_t, float* values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) values[i] = scale * values[i] + bias;
  });
}

std::vector<float> AccumulationBuffer::scaled(const PixelRectangle& area, float factor) {
  std::vector<float> colors;
  for_each_row(area, [&](std::size_t, const float* values, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      colors.push_back(std::clamp(factor * values[i], 0.0f, 1.0f));
  });
  return colors;
}

}  // namespace legacy_gl
