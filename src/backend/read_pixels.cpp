#include "backend/read_pixels.hpp"

#include <vector>

#include "texture/pixel_format.hpp"

namespace legacy_gl {

namespace {

/// Formats that only the fixed-function pipeline had.
bool is_legacy_format(GLenum format) {
  return format == GL_ALPHA || format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA;
}

/// The driver's own pack modes: as the application's, and afterwards as they are initially.
void set_pack_modes(const Driver& driver, const PixelStore& store) {
  driver.PixelStorei(GL_PACK_ALIGNMENT, store.alignment);
  driver.PixelStorei(GL_PACK_ROW_LENGTH, store.row_length);
  driver.PixelStorei(GL_PACK_SKIP_ROWS, store.skip_rows);
  driver.PixelStorei(GL_PACK_SKIP_PIXELS, store.skip_pixels);
  if (driver.is_es()) return;
  driver.PixelStorei(GL_PACK_SWAP_BYTES, store.swap_bytes);
  driver.PixelStorei(GL_PACK_LSB_FIRST, store.lsb_first);
}

bool reads_floats(const Driver& driver) {
  if (!driver.is_es()) return true;
  // ES reads floats from a floating-point buffer alone, and bytes from every other.
  GLint type = 0;
  driver.GetIntegerv(GL_IMPLEMENTATION_COLOR_READ_TYPE, &type);
  return type == GL_FLOAT || type == GL_HALF_FLOAT;
}

bool driver_reads(const Driver& driver, GLenum format, GLenum type, const PixelStore& store) {
  if (!driver.is_es()) return !is_legacy_format(format);
  if (store.swap_bytes && bytes_per_element(type) > 1) return false;  // ES has no such mode
  return format == GL_RGBA && type == (reads_floats(driver) ? GL_FLOAT : GL_UNSIGNED_BYTE);
}

std::vector<float> read_colors(const Driver& driver, const PixelRectangle& rectangle) {
  const auto count =
      static_cast<std::size_t>(rectangle.width) * 4 * static_cast<std::size_t>(rectangle.height);
  std::vector<float> colors(count);
  if (reads_floats(driver)) {
    driver.ReadPixels(rectangle.x, rectangle.y, rectangle.width, rectangle.height, GL_RGBA,
                      GL_FLOAT, colors.data());
    return colors;
  }
  std::vector<GLubyte> bytes(count);
  driver.ReadPixels(rectangle.x, rectangle.y, rectangle.width, rectangle.height, GL_RGBA,
                    GL_UNSIGNED_BYTE, bytes.data());
  for (std::size_t i = 0; i < count; ++i) colors[i] = static_cast<float>(bytes[i]) / 255.0f;
  return colors;
}

}  // namespace

bool can_read_pixels(const Driver& driver, GLenum format) {
  return !driver.is_es() || color_format(format).count != 0;
}

void read_pixels(const Driver& driver, const PixelRectangle& rectangle, const PixelStore& store,
                 GLenum format, GLenum type, std::byte* pixels) {
  if (driver_reads(driver, format, type, store)) {
    set_pack_modes(driver, store);
    driver.ReadPixels(rectangle.x, rectangle.y, rectangle.width, rectangle.height, format, type,
                      pixels);
    set_pack_modes(driver, PixelStore{});
    return;
  }
  const std::vector<float> colors = read_colors(driver, rectangle);
  const ImageLayout layout = image_layout(store, rectangle.width, format, type);
  const auto width = static_cast<std::size_t>(rectangle.width);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rectangle.height); ++row)
    pack_colors(colors.data() + row * width * 4, width, format, type, store.swap_bytes,
                pixels + layout.first + row * layout.stride);
}

}  // namespace legacy_gl
