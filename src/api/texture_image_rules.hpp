#pragma once
// What glTexImage, glCopyTexImage and their parts have in common.
#include "api/texture_targets.hpp"
#include "driver/driver_objects.hpp"

namespace legacy_gl {

struct NewImage {
  ImageTarget target;
  GLint level;
  GLint internal_format;
  GLint border;
  ImageSize size;  ///< with the border
};

GLenum level_error(const Context& context, const ImageTarget& target, GLint level);
/// All errors but that of a size that the driver does not have, which a proxy answers otherwise.
GLenum new_image_error(const Context& context, const NewImage& image);
bool image_fits(const Context& context, const NewImage& image);

/// The reference strips borders, and so do we: row D21 of docs/deviations.md.
ImageSize size_without_border(const NewImage& image);
PixelStore inside_border(const PixelStore& store, const NewImage& image);

void define_proxy(Context& context, const NewImage& image);
void define_image(Context& context, const NewImage& image, const Texels* texels);

/// The same with blocks of a compressed format.
void define_compressed_proxy(Context& context, const NewImage& image);
void define_compressed_image(Context& context, const NewImage& image, const void* data,
                             GLsizei bytes);
/// Texels cannot go into compressed images on OpenGL ES, nor come out of them: says so.
bool refuses_texels(Context& context, const TextureImage& image);

/// GL 2.1 spec 3.8.2: a part lies within an image that exists; of a compressed one it is whole
/// blocks.
GLenum part_error(const ImagePlace& place, const ImageOffset& offset, const ImageSize& size);

/// GL 2.1 spec 3.8.8: the levels above follow the base level where that was asked for.
void image_changed(Context& context, const ImagePlace& place);

}  // namespace legacy_gl
