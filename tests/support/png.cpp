#include <png.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/image.hpp"

namespace legacy_gl::test {

void write_png(const Image& image, const std::string& path) {
  std::vector<std::uint8_t> rows(static_cast<std::size_t>(image.width) *
                                 static_cast<std::size_t>(image.height) * 4);
  std::size_t next = 0;
  for (int y = image.height - 1; y >= 0; --y)
    for (int x = 0; x < image.width; ++x)
      for (int channel = 0; channel < 4; ++channel) {
        const float steps = image.steps(x, y, channel);
        rows[next++] = steps > 0.0F
                           ? static_cast<std::uint8_t>(std::lround(std::min(steps, 255.0F)))
                           : std::uint8_t{0};
      }
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGBA;
  if (png_image_write_to_file(&header, path.c_str(), 0, rows.data(), 0, nullptr) == 0)
    throw std::runtime_error("write_png: " + path + ": " + header.message);
}

}  // namespace legacy_gl::test
