#include "support/image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace legacy_gl::test {

namespace {

std::size_t value_index(const Image& image, int x, int y, int channel) {
  const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(x);
  return pixel * 4 + static_cast<std::size_t>(channel);
}

float difference_steps(float first, float second) {
  if (first == second) return 0.0F;
  const float difference = std::abs(first - second);
  // A NaN on either side must not pass for equality.
  return std::isnan(difference) ? std::numeric_limits<float>::infinity() : difference;
}

std::uint8_t to_byte(float steps) {
  if (!(steps > 0.0F)) return 0;
  return static_cast<std::uint8_t>(std::lround(std::min(steps, 255.0F)));
}

}  // namespace

Image::Image(PixelFormat pixel_format, int image_width, int image_height)
    : format(pixel_format), width(image_width), height(image_height) {
  const std::size_t values =
      static_cast<std::size_t>(image_width) * static_cast<std::size_t>(image_height) * 4;
  if (format == PixelFormat::rgba8) {
    bytes.resize(values);
  } else {
    floats.resize(values);
  }
}

float Image::steps(int x, int y, int channel) const {
  const std::size_t index = value_index(*this, x, y, channel);
  return format == PixelFormat::rgba8 ? static_cast<float>(bytes[index]) : floats[index] * 255.0F;
}

void* Image::data() {
  if (format == PixelFormat::rgba8) return bytes.data();
  return floats.data();
}

bool is_covered(const Image& image, int x, int y) { return image.steps(x, y, 3) != 0.0F; }

int covered_pixels(const Image& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += is_covered(image, x, y) ? 1 : 0;
  return count;
}

int distinct_colors(const Image& image) {
  std::set<std::array<std::uint8_t, 4>> colors;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (!is_covered(image, x, y)) continue;
      std::array<std::uint8_t, 4> color{};
      for (int channel = 0; channel < 4; ++channel)
        color[static_cast<std::size_t>(channel)] = to_byte(image.steps(x, y, channel));
      colors.insert(color);
    }
  }
  return static_cast<int>(colors.size());
}

float Comparison::max_difference() const {
  return *std::max_element(max_difference_steps.begin(), max_difference_steps.end());
}

Comparison compare(const Image& first, const Image& second) {
  if (first.width != second.width || first.height != second.height || first.format != second.format)
    throw std::invalid_argument("compare: the images differ in size or format");
  Comparison result;
  for (int y = 0; y < first.height; ++y) {
    for (int x = 0; x < first.width; ++x) {
      float worst = 0.0F;
      for (int channel = 0; channel < 4; ++channel) {
        const float difference =
            difference_steps(first.steps(x, y, channel), second.steps(x, y, channel));
        if (difference > result.max_difference()) {
          result.worst_x = x;
          result.worst_y = y;
        }
        float& channel_max = result.max_difference_steps[static_cast<std::size_t>(channel)];
        channel_max = std::max(channel_max, difference);
        worst = std::max(worst, difference);
      }
      if (worst > 0.0F) ++result.differing_pixels;
      const bool in_first = is_covered(first, x, y);
      const bool in_second = is_covered(second, x, y);
      if (in_first && !in_second) ++result.covered_only_in_first;
      if (in_second && !in_first) ++result.covered_only_in_second;
    }
  }
  return result;
}

Image amplified_difference(const Image& first, const Image& second, float gain) {
  Image result(PixelFormat::rgba8, first.width, first.height);
  for (int y = 0; y < first.height; ++y) {
    for (int x = 0; x < first.width; ++x) {
      float alpha_difference = 0.0F;
      for (int channel = 0; channel < 4; ++channel) {
        const float difference =
            difference_steps(first.steps(x, y, channel), second.steps(x, y, channel));
        if (channel == 3) {
          alpha_difference = difference;
          result.bytes[value_index(result, x, y, 3)] = 255;
        } else {
          result.bytes[value_index(result, x, y, channel)] = to_byte(difference * gain);
        }
      }
      // A difference in alpha alone has no colour of its own: show it as blue.
      std::uint8_t& blue = result.bytes[value_index(result, x, y, 2)];
      blue = std::max(blue, to_byte(alpha_difference * gain));
    }
  }
  return result;
}

}  // namespace legacy_gl::test
