#include "driver/read_pixels.hpp"

#include <algorithm>
#include <cmath>

#include "texture/pixel_format.hpp"
#include "texture/pixel_transfer.hpp"
#include "texture/texture_format.hpp"

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

bool driver_reads(const Driver& driver, GLenum format, GLenum type, const PixelStore& store) {
  if (!driver.is_es()) return !is_legacy_format(format);
  if (store.swap_bytes && bytes_per_element(type) > 1) return false;  // ES has no such mode
  return format == GL_RGBA && type == (reads_floats(driver) ? GL_FLOAT : GL_UNSIGNED_BYTE);
}

std::size_t pixel_count(const PixelRectangle& rectangle) {
  return static_cast<std::size_t>(rectangle.width) * static_cast<std::size_t>(rectangle.height);
}

/// Calls `pack(row, to)` for each row of the rectangle.
template <typename Pack>
void for_each_row(const PixelRectangle& rectangle, const ImageLayout& layout, std::byte* pixels,
                  Pack pack) {
  for (std::size_t row = 0; row < static_cast<std::size_t>(rectangle.height); ++row)
    pack(row, pixels + layout.first + row * layout.stride);
}

/// No mode of the driver's.
bool transfers(const PixelState& transfer, GLenum format, GLenum type) {
  if (format == GL_DEPTH_COMPONENT) return transfer.changes_depths();
  if (format == GL_STENCIL_INDEX) return transfer.changes_stencil() || type == GL_BITMAP;
  if (format == kDepthStencil) return transfer.changes_depths() || transfer.changes_stencil();
  return transfer.changes_colors();
}

void read_stencil(const Driver& driver, const PixelRectangle& rectangle, const PixelStore& store,
                  GLenum type, const PixelState& transfer, std::byte* pixels) {
  std::vector<GLubyte> bytes(pixel_count(rectangle));
  set_pack_modes(driver, PixelStore{.alignment = 1});
  driver.ReadPixels(rectangle.x, rectangle.y, rectangle.width, rectangle.height, GL_STENCIL_INDEX,
                    GL_UNSIGNED_BYTE, bytes.data());
  set_pack_modes(driver, PixelStore{});
  std::vector<GLuint> indices(bytes.begin(), bytes.end());
  transfer_stencil(transfer, indices.data(), indices.size());
  const auto width = static_cast<std::size_t>(rectangle.width);
  if (type == GL_BITMAP) {
    pack_bits(store, indices.data(), rectangle.width, rectangle.height, pixels);
    return;
  }
  for_each_row(rectangle, image_layout(store, rectangle.width, GL_STENCIL_INDEX, type), pixels,
               [&](std::size_t row, std::byte* to) {
                 pack_indices(indices.data() + row * width, width, type, store.swap_bytes, to);
               });
}

void read_depth_stencil(const Driver& driver, const PixelRectangle& rectangle,
                        const PixelStore& store, const PixelState& transfer, std::byte* pixels) {
  const std::vector<float> depths = read_depths(driver, rectangle, transfer);
  std::vector<GLuint> words(depths.size());
  read_stencil(driver, rectangle, PixelStore{.alignment = 1}, GL_UNSIGNED_INT, transfer,
               reinterpret_cast<std::byte*>(words.data()));
  for (std::size_t i = 0; i < words.size(); ++i) {
    const double depth = std::clamp(static_cast<double>(depths[i]), 0.0, 1.0);
    words[i] = static_cast<GLuint>(std::llround(depth * 0xffffff)) << 8 | (words[i] & 0xffu);
  }
  const auto width = static_cast<std::size_t>(rectangle.width);
  for_each_row(rectangle, image_layout(store, rectangle.width, kDepthStencil, kUnsignedInt24_8),
               pixels, [&](std::size_t row, std::byte* to) {
                 pack_indices(words.data() + row * width, width, GL_UNSIGNED_INT, store.swap_bytes,
                              to);
               });
}

}  // namespace

bool reads_floats(const Driver& driver) {
  if (!driver.is_es()) return true;
  // ES reads floats from a floating-point buffer alone, and bytes from every other.
  GLint type = 0;
  driver.GetIntegerv(GL_IMPLEMENTATION_COLOR_READ_TYPE, &type);
  return type == GL_FLOAT || type == GL_HALF_FLOAT;
}

std::vector<float> read_colors(const Driver& driver, const PixelRectangle& rectangle,
                               const PixelState& transfer) {
  const std::size_t count = pixel_count(rectangle);
  std::vector<float> colors(count * 4);
  if (reads_floats(driver)) {
    driver.ReadPixels(rectangle.x, rectangle.y, rectangle.width, rectangle.height, GL_RGBA,
                      GL_FLOAT, colors.data());
  } else {
    std::vector<GLubyte> bytes(count * 4);
    driver.ReadPixels(rectangle.x, rectangle.y, rectangle.width, rectangle.height, GL_RGBA,
                      GL_UNSIGNED_BYTE, bytes.data());
    for (std::size_t i = 0; i < bytes.size(); ++i)
      colors[i] = static_cast<float>(bytes[i]) / 255.0f;
  }
  if (!transfer.changes_colors()) return colors;
  transfer_colors(transfer, colors.data(), count);
  for (float& value : colors) value = std::clamp(value, 0.0f, 1.0f);
  return colors;
}

std::vector<float> read_depths(const Driver& driver, const PixelRectangle& rectangle,
                               const PixelState& transfer) {
  std::vector<float> depths(pixel_count(rectangle));
  driver.ReadPixels(rectangle.x, rectangle.y, rectangle.width, rectangle.height, GL_DEPTH_COMPONENT,
                    GL_FLOAT, depths.data());
  if (transfer.changes_depths()) transfer_depths(transfer, depths.data(), depths.size());
  return depths;
}

bool can_read_pixels(const Driver& driver, GLenum format) {
  return !driver.is_es() || color_format(format).count != 0;
}

void read_pixels(const Driver& driver, const PixelRectangle& rectangle, const PixelStore& store,
                 GLenum format, GLenum type, const PixelState& transfer, std::byte* pixels) {
  driver.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  if (!transfers(transfer, format, type) && driver_reads(driver, format, type, store)) {
    set_pack_modes(driver, store);
    driver.ReadPixels(rectangle.x, rectangle.y, rectangle.width, rectangle.height, format, type,
                      pixels);
    set_pack_modes(driver, PixelStore{});
    return;
  }
  if (format == GL_STENCIL_INDEX)
    return read_stencil(driver, rectangle, store, type, transfer, pixels);
  if (format == kDepthStencil)
    return read_depth_stencil(driver, rectangle, store, transfer, pixels);
  const bool depth = format == GL_DEPTH_COMPONENT;
  std::vector<float> colors;
  if (!depth) {
    colors = read_colors(driver, rectangle, transfer);
  } else {
    const std::vector<float> depths = read_depths(driver, rectangle, transfer);
    colors.resize(depths.size() * 4);
    for (std::size_t i = 0; i < depths.size(); ++i) colors[i * 4] = depths[i];
  }
  const auto width = static_cast<std::size_t>(rectangle.width);
  for_each_row(rectangle, image_layout(store, rectangle.width, format, type), pixels,
               [&](std::size_t row, std::byte* to) {
                 pack_colors(colors.data() + row * width * 4, width,
                             depth ? GLenum{GL_RED} : format, type, store.swap_bytes, to);
               });
}

}  // namespace legacy_gl
