#include "texture/pixel_format.hpp"

#include "texture/texture_format.hpp"

namespace legacy_gl {

ColorFormat color_format(GLenum format) {
  using enum PixelChannel;
  switch (format) {
    case GL_RED: return {1, {kRed}};
    case GL_GREEN: return {1, {kGreen}};
    case GL_BLUE: return {1, {kBlue}};
    case GL_ALPHA: return {1, {kAlpha}};
    case kRgFormat: return {2, {kRed, kGreen}};
    case GL_RGB: return {3, {kRed, kGreen, kBlue}};
    case GL_BGR: return {3, {kBlue, kGreen, kRed}};
    case GL_RGBA: return {4, {kRed, kGreen, kBlue, kAlpha}};
    case GL_BGRA: return {4, {kBlue, kGreen, kRed, kAlpha}};
    case GL_LUMINANCE: return {1, {kLuminance}};
    case GL_LUMINANCE_ALPHA: return {2, {kLuminance, kAlpha}};
    default: return {};
  }
}

PackedType packed_type(GLenum type) {
  switch (type) {
    case GL_UNSIGNED_BYTE_3_3_2: return {1, {3, 3, 2, 0}, false};
    case GL_UNSIGNED_BYTE_2_3_3_REV: return {1, {3, 3, 2, 0}, true};
    case GL_UNSIGNED_SHORT_5_6_5: return {2, {5, 6, 5, 0}, false};
    case GL_UNSIGNED_SHORT_5_6_5_REV: return {2, {5, 6, 5, 0}, true};
    case GL_UNSIGNED_SHORT_4_4_4_4: return {2, {4, 4, 4, 4}, false};
    case GL_UNSIGNED_SHORT_4_4_4_4_REV: return {2, {4, 4, 4, 4}, true};
    case GL_UNSIGNED_SHORT_5_5_5_1: return {2, {5, 5, 5, 1}, false};
    case GL_UNSIGNED_SHORT_1_5_5_5_REV: return {2, {5, 5, 5, 1}, true};
    case GL_UNSIGNED_INT_8_8_8_8: return {4, {8, 8, 8, 8}, false};
    case GL_UNSIGNED_INT_8_8_8_8_REV: return {4, {8, 8, 8, 8}, true};
    case GL_UNSIGNED_INT_10_10_10_2: return {4, {10, 10, 10, 2}, false};
    case GL_UNSIGNED_INT_2_10_10_10_REV: return {4, {10, 10, 10, 2}, true};
    default: return {};
  }
}

unsigned bytes_per_element(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE: return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT: return 2;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT:
    case kUnsignedInt24_8: return 4;
    default: return packed_type(type).bytes;
  }
}

unsigned bytes_per_pixel(GLenum format, GLenum type) {
  const unsigned element = bytes_per_element(type);
  if (packed_type(type).bytes) return element;
  const unsigned count = color_format(format).count;
  return element * (count ? count : 1);  // depth, stencil and colour indices are one number
}

GLenum pixel_format_error(GLenum format, GLenum type) {
  const bool is_index = format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX;
  const unsigned count = color_format(format).count;
  if (!count && !is_index && format != GL_DEPTH_COMPONENT) return GL_INVALID_ENUM;
  if (type == GL_BITMAP) return is_index ? GL_NO_ERROR : GL_INVALID_ENUM;
  if (type == kUnsignedInt24_8) return GL_INVALID_OPERATION;  // EXT_packed_depth_stencil
  if (!bytes_per_element(type)) return GL_INVALID_ENUM;
  const PackedType packed = packed_type(type);
  if (!packed.bytes) return GL_NO_ERROR;
  // Three components stand for RGB alone, four for RGBA or BGRA.
  const bool fits = packed.count() == 3 ? format == GL_RGB : format == GL_RGBA || format == GL_BGRA;
  return fits ? GL_NO_ERROR : GL_INVALID_OPERATION;
}

GLenum pixel_rectangle_error(GLenum format, GLenum type) {
  if (format == kDepthStencil) return type == kUnsignedInt24_8 ? GL_NO_ERROR : GL_INVALID_ENUM;
  return pixel_format_error(format, type);
}

ImageLayout image_layout(const PixelStore& store, GLsizei width, GLenum format, GLenum type) {
  const auto size = [](GLint value) { return static_cast<std::size_t>(value); };
  const std::size_t pixel = bytes_per_pixel(format, type);
  const std::size_t row = pixel * size(store.row_length > 0 ? store.row_length : width);
  // An alignment that the element's size exceeds is the element's anyway: rows are whole elements.
  const std::size_t alignment = size(store.alignment);
  ImageLayout layout;
  layout.stride = (row + alignment - 1) / alignment * alignment;
  layout.first = size(store.skip_rows) * layout.stride + size(store.skip_pixels) * pixel;
  return layout;
}

}  // namespace legacy_gl
