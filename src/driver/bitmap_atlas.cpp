#include "driver/bitmap_atlas.hpp"

#include <algorithm>

#include "driver/debug_labels.hpp"

namespace legacy_gl {

BitmapAtlas::~BitmapAtlas() {
  if (texture_) driver_.DeleteTextures(1, &texture_);
}

void append_pixel_vertex(std::vector<float>& vertices, float x, float y, float s, float t,
                         const RasterPosition& raster) {
  const float depth = 2 * std::clamp(raster.position.z, 0.0f, 1.0f) - 1;
  const glm::vec4& color = raster.color;
  const glm::vec3& secondary = raster.secondary_color;
  vertices.insert(vertices.end(), {pixel_clip_coordinate(x), pixel_clip_coordinate(y), depth, 1, s,
                                   t, 0, color.r, color.g, color.b, color.a, secondary.r,
                                   secondary.g, secondary.b, raster.distance});
}

std::optional<BitmapAtlas::Slot> BitmapAtlas::take_room(GLsizei width, GLsizei height) {
  if (shelf_x_ + width > kSide) {
    shelf_y_ += shelf_height_;
    shelf_x_ = shelf_height_ = 0;
  }
  if (shelf_y_ + height > kSide) return {};
  const Slot slot{shelf_x_, shelf_y_};
  shelf_x_ += width;
  shelf_height_ = std::max(shelf_height_, height);
  return slot;
}

std::optional<BitmapAtlas::Slot> BitmapAtlas::find_or_store(const BitmapImage& image) {
  key_.assign(image.bits);
  for (const GLsizei side : {image.width, image.height})
    key_.append(reinterpret_cast<const char*>(&side), sizeof side);
  if (const auto at = slots_.find(key_); at != slots_.end()) return at->second;
  const std::optional<Slot> slot = take_room(image.width, image.height);
  if (!slot) return {};
  texels_.resize(std::size_t{kSide} * kSide);
  for (GLsizei y = 0; y < image.height; ++y)
    for (GLsizei x = 0; x < image.width; ++x) {
      const std::size_t byte =
          static_cast<std::size_t>(y) * image.row_bytes() + static_cast<std::size_t>(x) / 8;
      const bool set = static_cast<unsigned char>(image.bits[byte]) & 0x80u >> (x % 8);
      texels_[static_cast<std::size_t>(slot->y + y) * kSide +
              static_cast<std::size_t>(slot->x + x)] = set ? 255 : 0;
    }
  changed_from_ = std::min(changed_from_, slot->y);
  changed_to_ = std::max(changed_to_, slot->y + image.height);
  slots_.emplace(key_, *slot);
  return slot;
}

bool BitmapAtlas::add(const RasterPosition& raster, GLint x, GLint y, const BitmapImage& image) {
  const std::optional<Slot> slot = find_or_store(image);
  if (!slot) return false;
  const auto corner = [&](GLsizei dx, GLsizei dy) {
    append_pixel_vertex(vertices_, static_cast<float>(x + dx), static_cast<float>(y + dy),
                        static_cast<float>(slot->x + dx), static_cast<float>(slot->y + dy), raster);
  };
  corner(0, 0);
  corner(image.width, 0);
  corner(image.width, image.height);
  corner(0, 0);
  corner(image.width, image.height);
  corner(0, image.height);
  return true;
}

void BitmapAtlas::forget() {
  slots_.clear();
  shelf_x_ = shelf_y_ = shelf_height_ = 0;
}

bool BitmapAtlas::make_texture() {
  if (!texture_) driver_.GenTextures(1, &texture_);
  driver_.BindTexture(GL_TEXTURE_2D, texture_);
  label(driver_, GL_TEXTURE, texture_, "glyphs of glBitmap");
  driver_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  driver_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  forget_errors(driver_);
  driver_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, kSide, kSide, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  return driver_.GetError() == GL_NO_ERROR;
}

bool BitmapAtlas::bind() {
  if (has_image_) driver_.BindTexture(GL_TEXTURE_2D, texture_);
  else has_image_ = make_texture();
  if (!has_image_) return false;  // what changed waits for the next
  if (changed_from_ < changed_to_)
    driver_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, changed_from_, kSide, changed_to_ - changed_from_,
                          GL_RED, GL_UNSIGNED_BYTE,
                          &texels_[static_cast<std::size_t>(changed_from_) * kSide]);
  changed_from_ = kSide;
  changed_to_ = 0;
  return true;
}

}  // namespace legacy_gl
