#pragma once
#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "driver/driver.hpp"
#include "state/raster_position.hpp"
#include "texture/bitmap_image.hpp"

namespace legacy_gl {

/// Bitmaps that wait to be drawn together, and the texture that keeps those that were drawn
/// before: a glyph is unpacked once, and a text is one draw.
class BitmapAtlas {
 public:
  explicit BitmapAtlas(const Driver& driver) : driver_(driver) {}
  ~BitmapAtlas();
  BitmapAtlas(const BitmapAtlas&) = delete;
  BitmapAtlas& operator=(const BitmapAtlas&) = delete;

  /// No side of a part is longer.
  static constexpr GLsizei kMaxSide = 512;

  /// Adds a bitmap whose left lower corner is at the window coordinates (x, y). False when there is
  /// no room: what waits has to be drawn and forgotten first.
  bool add(const RasterPosition& raster, GLint x, GLint y, const BitmapImage& image);
  /// Forgets every bitmap that was kept; none waits.
  void forget();

  /// Two triangles a bitmap, as draw_pixel_quads (submit/pixel_quads.hpp) reads them.
  const std::vector<float>& vertices() const { return vertices_; }
  void clear() { vertices_.clear(); }
  /// Brings the driver's texture up to date and binds it to the unit that is active. False when the
  /// driver has no memory for it.
  bool bind();

 private:
  struct Slot {
    GLint x, y;
  };
  std::optional<Slot> find_or_store(const BitmapImage& image);
  bool make_texture();
  std::optional<Slot> take_room(GLsizei width, GLsizei height);

  static constexpr GLsizei kSide = 1024;

  const Driver& driver_;
  GLuint texture_ = 0;
  bool has_image_ = false;
  std::vector<unsigned char> texels_;              ///< 0 or 255
  GLsizei changed_from_ = kSide, changed_to_ = 0;  ///< rows that the driver does not have
  std::unordered_map<std::string, Slot> slots_;
  std::string key_;  ///< of the bitmap that is looked for
  GLsizei shelf_y_ = 0, shelf_height_ = 0, shelf_x_ = 0;
  std::vector<float> vertices_;
};

/// The window coordinate 0 to `kPixelWindow` in clip coordinates, for pixel rectangles: their
/// viewport begins at the origin and is a power of two wide, so that no coordinate is rounded.
inline constexpr GLsizei kPixelWindow = 8192;
inline float pixel_clip_coordinate(float window) {
  return window * (2.0f / static_cast<float>(kPixelWindow)) - 1.0f;
}

/// A vertex of a pixel rectangle: window position, texel, and what it takes of the raster position.
void append_pixel_vertex(std::vector<float>& vertices, float x, float y, float s, float t,
                         const RasterPosition& raster);

}  // namespace legacy_gl
