#include "driver/pixel_texture.hpp"

#include <algorithm>

#include "driver/debug_labels.hpp"
#include "driver/textures.hpp"

namespace legacy_gl {

namespace {

GLint storage_format(const Texels& texels) {
  const bool bytes = texels.type == Texels::Type::kBytes;
  if (texels.components == 1) return bytes ? GL_R8 : GL_R32F;
  return bytes ? GL_RGBA8 : GL_RGBA32F;
}

}  // namespace

PixelTexture::~PixelTexture() {
  if (texture_) driver_.DeleteTextures(1, &texture_);
}

void PixelTexture::load(const PixelImage& image, const PixelTile& tile) {
  const GLint format = storage_format(image.texels);
  const bool bytes = image.texels.type == Texels::Type::kBytes;
  const GLenum components = image.texels.components == 1 ? GL_RED : GL_RGBA;
  const GLenum type = bytes ? GL_UNSIGNED_BYTE : GL_FLOAT;
  const bool is_new = !texture_;
  if (is_new) driver_.GenTextures(1, &texture_);
  driver_.BindTexture(GL_TEXTURE_2D, texture_);
  if (is_new) label(driver_, GL_TEXTURE, texture_, "pixel rectangles");
  set_unpack_modes(driver_);
  if (format != format_ || tile.width > width_ || tile.height > height_) {
    format_ = format;
    width_ = tile.width;
    height_ = tile.height;
    driver_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    driver_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    driver_.TexImage2D(GL_TEXTURE_2D, 0, format, width_, height_, 0, components, type, nullptr);
  }
  const std::size_t pixel = image.texels.components * (bytes ? 1u : 4u);
  const std::size_t first =
      static_cast<std::size_t>(tile.y) * static_cast<std::size_t>(image.width) +
      static_cast<std::size_t>(tile.x);
  driver_.PixelStorei(GL_UNPACK_ROW_LENGTH, image.width);
  driver_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, tile.width, tile.height, components, type,
                        image.texels.data.data() + first * pixel);
  driver_.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

}  // namespace legacy_gl
