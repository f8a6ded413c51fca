// GL 2.1 spec 3.8.2: glCopyTexImage, glCopyTexSubImage.

#include "api/texture_image_rules.hpp"
#include "dlist/dispatch.hpp"
#include "execute/framebuffer.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

/// What is copied from the framebuffer it must have; OpenGL ES gives no depth away.
GLenum source_error(Context& c, BaseFormat base) {
  if (base != BaseFormat::kDepth) return GL_NO_ERROR;
  if (!framebuffer_bits(c, FramebufferChannel::kDepth)) return GL_INVALID_OPERATION;
  if (!c.driver->functions.is_es()) return GL_NO_ERROR;
  diagnose(c, "glCopyTexImage: this driver (OpenGL ES) copies colours alone");
  return GL_INVALID_OPERATION;
}

void copy_image(Context& c, GLenum target_name, unsigned dimensions, GLint level,
                GLenum internal_format, PixelRectangle from, GLint border) {
  if (refused_inside(c)) return;
  const std::optional<ImageTarget> target = image_target(target_name, dimensions);
  if (!target || target->proxy) return raise_error(c, GL_INVALID_ENUM);
  const NewImage image{
      *target, level, static_cast<GLint>(internal_format), border, {from.width, from.height, 1}};
  // The numbers 1 to 4 are no formats here.
  if (internal_format <= 4) return raise_error(c, GL_INVALID_VALUE);
  if (const GLenum error = new_image_error(c, image)) return raise_error(c, error);
  if (!image_fits(c, image)) return raise_error(c, GL_INVALID_VALUE);
  const BaseFormat base = find_texture_format(image.internal_format).base;
  if (const GLenum error = source_error(c, base)) return raise_error(c, error);
  const ImageSize size = size_without_border(image);
  define_image(c, image, nullptr);
  if (!size.texels()) return;
  const ImagePlace place{bound_texture(c, target->target), target->face, level};
  from.x += border;
  from.width = size.width;
  if (dimensions == 2) from.y += border;
  from.height = size.height;
  c.driver->textures.copy(place, {}, from, c.pixels);
  image_changed(c, place);
}

void copy_part(Context& c, GLenum target_name, unsigned dimensions, GLint level, ImageOffset offset,
               PixelRectangle from) {
  if (refused_inside(c)) return;
  const std::optional<ImageTarget> target = image_target(target_name, dimensions);
  if (!target || target->proxy) return raise_error(c, GL_INVALID_ENUM);
  if (const GLenum error = level_error(c, *target, level)) return raise_error(c, error);
  const ImagePlace place{bound_texture(c, target->target), target->face, level};
  if (const GLenum error = part_error(place, offset, {from.width, from.height, 1}))
    return raise_error(c, error);
  const BaseFormat base = place.texture.images.at(place.face, place.level).format.base;
  if (const GLenum error = source_error(c, base)) return raise_error(c, error);
  if (refuses_texels(c, place.texture.images.at(place.face, place.level))) return;
  before_texture_change(c);
  if (!from.width || !from.height) return;
  c.driver->textures.copy(place, offset, from, c.pixels);
  image_changed(c, place);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglCopyTexImage1D(GLenum target, GLint level,
                                                        GLenum internalformat, GLint x, GLint y,
                                                        GLsizei width, GLint border) {
  dispatch<copy_image>(target, 1u, level, internalformat, PixelRectangle{x, y, width, 1}, border);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCopyTexImage2D(GLenum target, GLint level,
                                                        GLenum internalformat, GLint x, GLint y,
                                                        GLsizei width, GLsizei height,
                                                        GLint border) {
  dispatch<copy_image>(target, 2u, level, internalformat, PixelRectangle{x, y, width, height},
                       border);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCopyTexSubImage1D(GLenum target, GLint level,
                                                           GLint xoffset, GLint x, GLint y,
                                                           GLsizei width) {
  dispatch<copy_part>(target, 1u, level, ImageOffset{xoffset}, PixelRectangle{x, y, width, 1});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCopyTexSubImage2D(GLenum target, GLint level,
                                                           GLint xoffset, GLint yoffset, GLint x,
                                                           GLint y, GLsizei width, GLsizei height) {
  dispatch<copy_part>(target, 2u, level, ImageOffset{xoffset, yoffset},
                      PixelRectangle{x, y, width, height});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCopyTexSubImage3D(GLenum target, GLint level,
                                                           GLint xoffset, GLint yoffset,
                                                           GLint zoffset, GLint x, GLint y,
                                                           GLsizei width, GLsizei height) {
  dispatch<copy_part>(target, 3u, level, ImageOffset{xoffset, yoffset, zoffset},
                      PixelRectangle{x, y, width, height});
}
