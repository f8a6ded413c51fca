// RGBA8 pictures of the samples: difference and PNG.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace samples {

// Rows from the bottom up, as glReadPixels and OSMesa give them.
struct Picture {
  Picture(int picture_width, int picture_height)
      : width(picture_width),
        height(picture_height),
        rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4) {}

  int width;
  int height;
  std::vector<std::uint8_t> rgba;
};

struct Difference {
  Picture amplified;  // |first - second| × amplification, opaque
  int largest = 0;    // of any channel, in steps of 1/255
  std::size_t differing_pixels = 0;
};

// Both pictures have the same size.
Difference difference(const Picture& first, const Picture& second, int amplification);

// Opaque. Throws std::runtime_error when the file cannot be written.
void write_png(const Picture& picture, const std::filesystem::path& path);

}  // namespace samples
