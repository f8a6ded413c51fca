#include "api/texture_image_rules.hpp"

#include <bit>

#include "record/pending.hpp"
#include "texture/compressed_format.hpp"

namespace legacy_gl {

GLenum level_error(const Context& context, const ImageTarget& target, GLint level) {
  const auto largest = static_cast<unsigned>(context.driver->textures.largest_size(target.target));
  const auto levels = static_cast<GLint>(std::bit_width(largest));
  return level < 0 || level >= levels || level >= static_cast<GLint>(kMaxTextureLevels)
             ? GLenum{GL_INVALID_VALUE}
             : GLenum{GL_NO_ERROR};
}

ImageSize size_without_border(const NewImage& image) {
  ImageSize size = image.size;
  size.width -= 2 * image.border;
  if (image.target.target != kTexture1D) size.height -= 2 * image.border;
  if (image.target.target == kTexture3D) size.depth -= 2 * image.border;
  return size;
}

PixelStore inside_border(const PixelStore& store, const NewImage& image) {
  if (!image.border) return store;
  PixelStore inner = store;
  if (!inner.row_length) inner.row_length = image.size.width;
  ++inner.skip_pixels;
  if (image.target.target == kTexture1D) return inner;
  ++inner.skip_rows;
  if (image.target.target != kTexture3D) return inner;
  if (!inner.image_height) inner.image_height = image.size.height;
  ++inner.skip_images;
  return inner;
}

GLenum new_image_error(const Context& context, const NewImage& image) {
  if (const GLenum error = level_error(context, image.target, image.level)) return error;
  const TextureFormat format = find_texture_format(image.internal_format);
  const ImageSize& size = image.size;
  const ImageSize inner = size_without_border(image);
  if (!format.core || image.border < 0 || image.border > 1 || size.width < 0 || size.height < 0 ||
      size.depth < 0)
    return GL_INVALID_VALUE;
  if (bytes_of_block(image.internal_format)) {
    if (!context.driver->textures.offers_s3tc()) return GL_INVALID_VALUE;
    if (image.target.target != kTexture2D && image.target.target != kTextureCube)
      return GL_INVALID_ENUM;  // EXT_texture_compression_s3tc
  }
  if (image.border && (inner.width < 0 || inner.height < 0 || inner.depth < 0))
    return GL_INVALID_VALUE;
  if (image.target.target == kTextureCube && size.width != size.height) return GL_INVALID_VALUE;
  if (format.base == BaseFormat::kDepth && image.target.target > kTexture2D)
    return GL_INVALID_OPERATION;
  return GL_NO_ERROR;
}

bool image_fits(const Context& context, const NewImage& image) {
  return context.driver->textures.fits(image.target.target, image.level,
                                       size_without_border(image));
}

namespace {

TextureImage texture_image(const NewImage& image) {
  const ImageSize size = size_without_border(image);
  TextureImage result;
  if (!size.texels()) return result;
  result.width = size.width;
  result.height = size.height;
  result.depth = size.depth;
  result.internal_format = image.internal_format;
  result.format = find_texture_format(image.internal_format);
  return result;
}

}  // namespace

namespace {

/// Where the driver compresses nothing, such images have the format that is stored.
NewImage as_stored(const Context& context, const NewImage& image) {
  NewImage stored = image;
  if (bytes_of_block(image.internal_format) && context.driver->functions.is_es())
    stored.internal_format =
        static_cast<GLint>(base_format_name(find_texture_format(image.internal_format).base));
  return stored;
}

}  // namespace

void define_proxy(Context& context, const NewImage& image) {
  define_compressed_proxy(context, as_stored(context, image));
}

void define_compressed_proxy(Context& context, const NewImage& image) {
  const bool fits = image_fits(context, image);
  context.texture.proxies[image.target.target].at(0, image.level) =
      fits ? texture_image(image) : TextureImage{};
}

void define_image(Context& context, const NewImage& image, const Texels* texels) {
  before_texture_change(context);
  const ImagePlace place{bound_texture(context, image.target.target), image.target.face,
                         image.level};
  const TextureImage defined = texture_image(as_stored(context, image));
  if (!defined.exists()) {
    place.texture.images.at(place.face, place.level) = {};
    return;
  }
  if (!context.driver->textures.define(place, defined, texels))
    return raise_error(context, GL_OUT_OF_MEMORY);
  image_changed(context, place);
}

void define_compressed_image(Context& context, const NewImage& image, const void* data,
                             GLsizei bytes) {
  before_texture_change(context);
  const ImagePlace place{bound_texture(context, image.target.target), image.target.face,
                         image.level};
  const TextureImage defined = texture_image(image);
  if (!defined.exists()) {
    place.texture.images.at(place.face, place.level) = {};
    return;
  }
  if (!context.driver->textures.define_compressed(place, defined, data, bytes))
    return raise_error(context, GL_OUT_OF_MEMORY);
  image_changed(context, place);
}

bool refuses_texels(Context& context, const TextureImage& image) {
  if (!bytes_of_block(image.internal_format) || !context.driver->functions.is_es()) return false;
  diagnose(context, "this driver (OpenGL ES) neither compresses texels nor gives them back");
  raise_error(context, GL_INVALID_OPERATION);
  return true;
}

GLenum part_error(const ImagePlace& place, const ImageOffset& offset, const ImageSize& size) {
  const TextureImage& image = place.texture.images.at(place.face, place.level);
  if (!image.exists()) return GL_INVALID_OPERATION;
  const auto within = [](GLint first, GLsizei count, GLsizei whole) {
    return first >= 0 && count >= 0 && first <= whole && count <= whole - first;
  };
  const bool inside = within(offset.x, size.width, image.width) &&
                      within(offset.y, size.height, image.height) &&
                      within(offset.z, size.depth, image.depth);
  if (!inside) return GL_INVALID_VALUE;
  const auto whole_blocks = [](GLint first, GLsizei count, GLsizei whole) {
    return first % kBlockEdge == 0 && (count % kBlockEdge == 0 || first + count == whole);
  };
  if (bytes_of_block(image.internal_format) && !(whole_blocks(offset.x, size.width, image.width) &&
                                                 whole_blocks(offset.y, size.height, image.height)))
    return GL_INVALID_OPERATION;
  return GL_NO_ERROR;
}

void image_changed(Context& context, const ImagePlace& place) {
  TextureObject& texture = place.texture;
  if (!texture.parameters.generate_mipmap || place.level != texture.base_level()) return;
  const TextureImage& image = texture.images.at(place.face, place.level);
  if (bytes_of_block(image.internal_format) && context.driver->functions.is_es()) return;
  // A cube map whose faces do not yet agree has no levels to make.
  TextureParameters base_only = texture.parameters;
  base_only.min_filter = GL_LINEAR;
  if (texture.images.complete(base_only)) context.driver->textures.generate_mipmap(texture);
}

}  // namespace legacy_gl
