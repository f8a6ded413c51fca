#include "support/picture.hpp"

#include <png.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace samples {

Difference difference(const Picture& first, const Picture& second, int amplification) {
  Difference result{Picture(first.width, first.height)};
  for (std::size_t pixel = 0; pixel < first.rgba.size(); pixel += 4) {
    int largest_here = 0;
    for (std::size_t channel = pixel; channel < pixel + 4; ++channel) {
      const int steps = std::abs(int{first.rgba[channel]} - int{second.rgba[channel]});
      largest_here = std::max(largest_here, steps);
      result.amplified.rgba[channel] =
          static_cast<std::uint8_t>(std::min(steps * amplification, 255));
    }
    result.largest = std::max(result.largest, largest_here);
    result.differing_pixels += largest_here > 0 ? 1 : 0;
  }
  return result;
}

void write_png(const Picture& picture, const std::filesystem::path& path) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(picture.rgba.size() / 4 * 3);
  for (std::size_t pixel = 0; pixel < picture.rgba.size(); pixel += 4) {
    rgb.insert(rgb.end(), {picture.rgba[pixel], picture.rgba[pixel + 1], picture.rgba[pixel + 2]});
  }
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(picture.width);
  header.height = static_cast<png_uint_32>(picture.height);
  header.format = PNG_FORMAT_RGB;
  // A negative stride: the first row in memory is the bottom one.
  const int row_bytes = picture.width * 3;
  if (png_image_write_to_file(&header, path.c_str(), 0, rgb.data(), -row_bytes, nullptr) == 0) {
    throw std::runtime_error(path.string() + ": " + header.message);
  }
}

}  // namespace samples
