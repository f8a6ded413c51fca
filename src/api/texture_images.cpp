// GL 2.1 spec 3.8.1, 3.8.2: glTexImage, glTexSubImage.
#include <algorithm>
#include <memory>

#include "api/texture_image_rules.hpp"
#include "dlist/dispatch.hpp"
#include "record/pending.hpp"
#include "texture/pixel_format.hpp"
#include "texture/recorded_pixels.hpp"

using namespace legacy_gl;

namespace {

/// The arguments of all of them; sizes that the call does not have are 1, offsets 0.
struct ImageCall {
  GLenum target;
  unsigned dimensions;
  GLint level;
  bool replaces_part;
  GLint internal_format;
  GLint border;
  ImageOffset offset;
  ImageSize size;
  GLenum format, type;
};

bool is_depth_stencil(const ImageCall& call) { return call.format == kDepthStencil; }

bool has_depth(const ImageCall& call) {
  return call.format == GL_DEPTH_COMPONENT || is_depth_stencil(call);
}

GLenum transfer_error(const ImageCall& call) {
  if (is_depth_stencil(call))
    return call.type == kUnsignedInt24_8 ? GL_NO_ERROR : GL_INVALID_OPERATION;
  if (call.format == GL_STENCIL_INDEX) return GL_INVALID_ENUM;
  return pixel_format_error(call.format, call.type);
}

/// Words of depth and stencil go to the driver as they are.
Texels image_texels(const Context& c, const ImageCall& call, const PixelStore& store,
                    const void* pixels, const ImageSize& size, BaseFormat base) {
  if (!is_depth_stencil(call))
    return unpack_texels(store, pixels, size, call.format, call.type, base,
                         c.driver->textures.takes_bytes_only(), c.pixels);
  RecordedPixels words = record_pixels(store, pixels, size, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
  if (store.swap_bytes)
    for (std::size_t i = 0; i < words.bytes.size(); i += 4)
      std::reverse(words.bytes.begin() + static_cast<std::ptrdiff_t>(i),
                   words.bytes.begin() + static_cast<std::ptrdiff_t>(i + 4));
  return {1, Texels::Type::kDepths, std::move(words.bytes)};
}

void define(Context& c, const ImageCall& call, const PixelStore& store, const void* pixels) {
  const std::optional<ImageTarget> target = image_target(call.target, call.dimensions);
  if (!target) return raise_error(c, GL_INVALID_ENUM);
  NewImage image{*target, call.level, call.internal_format, call.border, call.size};
  if (const GLenum error = new_image_error(c, image)) return raise_error(c, error);
  if (const GLenum error = transfer_error(call)) return raise_error(c, error);
  const TextureFormat format = find_texture_format(call.internal_format);
  if ((format.base == BaseFormat::kDepth) != has_depth(call))
    return raise_error(c, GL_INVALID_OPERATION);
  if (target->proxy) return define_proxy(c, image);
  if (!image_fits(c, image)) return raise_error(c, GL_INVALID_VALUE);
  const PixelStore inner = inside_border(store, image);
  const ImageSize size = size_without_border(image);
  if (!pixels || !size.texels()) return define_image(c, image, nullptr);
  const Texels texels = image_texels(c, call, inner, pixels, size, format.base);
  define_image(c, image, &texels);
}

void replace(Context& c, const ImageCall& call, const PixelStore& store, const void* pixels) {
  const std::optional<ImageTarget> target = image_target(call.target, call.dimensions);
  if (!target || target->proxy) return raise_error(c, GL_INVALID_ENUM);
  if (const GLenum error = level_error(c, *target, call.level)) return raise_error(c, error);
  if (const GLenum error = transfer_error(call)) return raise_error(c, error);
  const ImagePlace place{bound_texture(c, target->target), target->face, call.level};
  if (const GLenum error = part_error(place, call.offset, call.size)) return raise_error(c, error);
  const BaseFormat base = place.texture.images.at(place.face, place.level).format.base;
  if ((base == BaseFormat::kDepth) != has_depth(call)) return raise_error(c, GL_INVALID_OPERATION);
  if (refuses_texels(c, place.texture.images.at(place.face, place.level))) return;
  if (!pixels || !call.size.texels()) return;
  before_texture_change(c);
  c.driver->textures.replace(place, call.offset, call.size,
                             image_texels(c, call, store, pixels, call.size, base));
  image_changed(c, place);
}

void execute(Context& c, const ImageCall& call, const PixelStore& store, const void* pixels) {
  if (refused_inside(c)) return;
  PixelStore applied = store;
  if (call.dimensions < 3) applied.skip_images = applied.image_height = 0;
  if (call.replaces_part) replace(c, call, applied, pixels);
  else define(c, call, applied, pixels);
}

/// In a list; nullptr: without pixels.
void play_image(Context& c, ImageCall call, const RecordedPixels* recorded) {
  if (!recorded) return execute(c, call, PixelStore{}, nullptr);
  if (!is_depth_stencil(call)) call.type = recorded->type;
  execute(c, call, recorded->store, recorded->bytes.data());
}

/// Display lists keep what the pointer points to now (GL 2.1 spec 5.4).
void record_image(Context& c, const ImageCall& call, const void* pixels) {
  const ImageSize& size = call.size;
  const bool sized = size.width > 0 && size.height > 0 && size.depth > 0;
  const RecordedPixels* recorded = nullptr;
  if (pixels && sized && !transfer_error(call)) {
    PixelStore store = c.unpack;
    if (call.dimensions < 3) store.skip_images = store.image_height = 0;
    const auto kept = std::make_shared<const RecordedPixels>(
        is_depth_stencil(call)
            ? record_pixels(store, pixels, size, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT)
            : record_pixels(store, pixels, size, call.format, call.type));
    c.lists.keep(kept);
    recorded = kept.get();
  }
  dispatch<play_image>(call, recorded);
}

void image_call(const ImageCall& call, const void* pixels) {
  with_context([&](Context& context) {
    const std::optional<ImageTarget> target = image_target(call.target, call.dimensions);
    const bool proxy = target && target->proxy;  // executed at once (GL 2.1 spec 5.4)
    if (context.list_modes.compiling && !proxy) record_image(context, call, pixels);
    else execute(context, call, context.unpack, pixels);
  });
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexImage1D(GLenum target, GLint level,
                                                    GLint internalformat, GLsizei width,
                                                    GLint border, GLenum format, GLenum type,
                                                    const void* pixels) {
  image_call({target, 1, level, false, internalformat, border, {}, {width, 1, 1}, format, type},
             pixels);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexImage2D(GLenum target, GLint level,
                                                    GLint internalformat, GLsizei width,
                                                    GLsizei height, GLint border, GLenum format,
                                                    GLenum type, const void* pixels) {
  image_call(
      {target, 2, level, false, internalformat, border, {}, {width, height, 1}, format, type},
      pixels);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexImage3D(GLenum target, GLint level,
                                                    GLint internalformat, GLsizei width,
                                                    GLsizei height, GLsizei depth, GLint border,
                                                    GLenum format, GLenum type,
                                                    const void* pixels) {
  image_call(
      {target, 3, level, false, internalformat, border, {}, {width, height, depth}, format, type},
      pixels);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexSubImage1D(GLenum target, GLint level, GLint xoffset,
                                                       GLsizei width, GLenum format, GLenum type,
                                                       const void* pixels) {
  image_call({target, 1, level, true, 0, 0, {xoffset}, {width, 1, 1}, format, type}, pixels);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexSubImage2D(GLenum target, GLint level, GLint xoffset,
                                                       GLint yoffset, GLsizei width, GLsizei height,
                                                       GLenum format, GLenum type,
                                                       const void* pixels) {
  image_call({target, 2, level, true, 0, 0, {xoffset, yoffset}, {width, height, 1}, format, type},
             pixels);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexSubImage3D(GLenum target, GLint level, GLint xoffset,
                                                       GLint yoffset, GLint zoffset, GLsizei width,
                                                       GLsizei height, GLsizei depth, GLenum format,
                                                       GLenum type, const void* pixels) {
  image_call({target,
              3,
              level,
              true,
              0,
              0,
              {xoffset, yoffset, zoffset},
              {width, height, depth},
              format,
              type},
             pixels);
}
