// Images as OpenGL gives them, and the comparison of two of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace legacy_gl::test {

enum class PixelFormat { rgba8, rgba32f };

// Row 0 is the bottom row. `bytes` holds the pixels of an rgba8 image, `floats` those of an rgba32f
// image; the other one is empty.
struct Image {
  PixelFormat format = PixelFormat::rgba8;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
  std::vector<float> floats;

  Image() = default;
  Image(PixelFormat pixel_format, int image_width, int image_height);

  // One channel (0 red … 3 alpha) in steps of 1/255, whatever the format.
  float steps(int x, int y, int channel) const;
  // Where to let glReadPixels and its like write.
  void* data();
};

// Every scene clears to (0, 0, 0, 0) and everything it draws has a non-zero alpha (a fragment's
// alpha is the material's diffuse alpha or the current colour's): a pixel is covered when its alpha
// is not 0.
bool is_covered(const Image& image, int x, int y);
int covered_pixels(const Image& image);
// Distinct colours among the covered pixels, rounded to RGBA8.
int distinct_colors(const Image& image);

struct Comparison {
  std::array<float, 4> max_difference_steps = {0, 0, 0, 0};  // per channel, in 1/255; inf for NaN
  int differing_pixels = 0;
  int covered_only_in_first = 0;
  int covered_only_in_second = 0;
  // The worst pixel, for the message.
  int worst_x = 0;
  int worst_y = 0;

  float max_difference() const;
  bool same_coverage() const { return covered_only_in_first == 0 && covered_only_in_second == 0; }
  bool identical() const { return differing_pixels == 0; }
};

// Both images must have the same size and format.
Comparison compare(const Image& first, const Image& second);

// |first - second| times `gain`, clamped; opaque, so that a viewer shows it.
Image amplified_difference(const Image& first, const Image& second, float gain);

// RGBA8 PNG by libpng, top row first; floats are clamped to [0, 1]. Throws std::runtime_error.
void write_png(const Image& image, const std::string& path);

}  // namespace legacy_gl::test
