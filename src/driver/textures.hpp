#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "driver/driver.hpp"
#include "driver/read_pixels.hpp"
#include "texture/texture_state.hpp"
#include "texture/unpack_pixels.hpp"

namespace legacy_gl {

/// Which image of a texture.
struct ImagePlace {
  TextureObject& texture;
  unsigned face = 0;
  GLint level = 0;
};

/// Where in an image, in texels.
struct ImageOffset {
  GLint x = 0, y = 0, z = 0;
};

/// Texels come without gaps, and no buffer object of the application's is read.
void set_unpack_modes(const Driver& driver);

/// Textures in the driver: their images, their parameters, and which are bound to its units.
class Textures {
 public:
  explicit Textures(const Driver& driver);

  /// Binds what the units draw with, its parameters up to date.
  void bind(const ActiveTextures& active);
  void forget_bindings();
  void free_deleted(DeletedNames& names) { names.collect(driver_.DeleteTextures); }
  /// Makes a unit active for what is not a texture object.
  void select_unit(unsigned unit);

  /// Gives the image size and format, and texels unless it is nullptr. False when the driver has no
  /// memory for it.
  bool define(const ImagePlace& place, const TextureImage& image, const Texels* texels);
  void replace(const ImagePlace& place, const ImageOffset& offset, const ImageSize& size,
               const Texels& texels);
  /// The same with blocks of a compressed format; nullptr: what they are is undefined.
  bool define_compressed(const ImagePlace& place, const TextureImage& image, const void* data,
                         GLsizei bytes);
  void replace_compressed(const ImagePlace& place, const ImageOffset& offset, const ImageSize& size,
                          const void* data, GLsizei bytes);
  void read_compressed(const ImagePlace& place, void* data);
  bool offers_s3tc() const { return offers_s3tc_; }
  /// From the framebuffer, whose rectangle starts at `from`. `window` bounds what it has.
  void copy(const ImagePlace& place, const ImageOffset& offset, const PixelRectangle& from,
            const PixelState& transfer);
  /// The image's colours, four floats a texel.
  std::vector<float> read(const ImagePlace& place);
  /// Of an image of depths and stencil indices, as kUnsignedInt24_8 has them; not on OpenGL ES.
  std::vector<GLuint> read_depth_stencil(const ImagePlace& place);
  /// All levels above the base level (GL 2.1 spec 3.8.8), in the driver and in `images`.
  void generate_mipmap(TextureObject& texture);

  /// Bits of a stored channel.
  GLint channel_bits(const ImagePlace& place, unsigned channel);
  bool fits(TextureTarget target, GLint level, const ImageSize& size) const;
  GLint largest_size(TextureTarget target) const;
  /// The driver's name of it, made if need be.
  GLuint driver_name(TextureObject& texture);
  bool takes_bytes_only() const { return driver_.is_es(); }
  bool has_border_color() const { return has_border_color_; }

 private:
  void bind_to_change(TextureObject& texture);
  void bind_unit(unsigned unit, TextureObject& texture);
  void apply_parameters(TextureObject& texture);
  std::vector<float> read_from_framebuffer(const ImagePlace& place, const TextureImage& image);

  const Driver& driver_;
  bool has_border_color_ = true;
  bool offers_s3tc_ = false;
  std::array<std::uint64_t, kMaxTextureUnits> bound_{};  ///< serial numbers; 0: not known
  unsigned active_unit_ = ~0u;
  bool samplers_unbound_ = false;
};

}  // namespace legacy_gl
