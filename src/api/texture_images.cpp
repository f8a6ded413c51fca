// GL 2.1 spec 3.8.1, 3.8.2: glTexImage, glTexSubImage.
#include <cstring>
#include <new>

#include "api/texture_image_rules.hpp"
#include "dlist/dispatch.hpp"
#include "texture/pixel_format.hpp"

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

GLenum transfer_error(const ImageCall& call) {
  if (call.format == GL_STENCIL_INDEX) return GL_INVALID_ENUM;
  return pixel_format_error(call.format, call.type);
}

/// GL_COLOR_INDEX goes through pixel maps, which are not built.
bool refuses_indices(Context& c, const ImageCall& call) {
  if (call.format != GL_COLOR_INDEX) return false;
  diagnose(c, "glTexImage: GL_COLOR_INDEX needs pixel maps, which are not built yet");
  raise_error(c, GL_INVALID_OPERATION);
  return true;
}

void define(Context& c, const ImageCall& call, const PixelStore& store, const void* pixels) {
  const std::optional<ImageTarget> target = image_target(call.target, call.dimensions);
  if (!target) return raise_error(c, GL_INVALID_ENUM);
  NewImage image{*target, call.level, call.internal_format, call.border, call.size};
  if (const GLenum error = new_image_error(c, image)) return raise_error(c, error);
  if (const GLenum error = transfer_error(call)) return raise_error(c, error);
  const TextureFormat format = find_texture_format(call.internal_format);
  if ((format.base == BaseFormat::kDepth) != (call.format == GL_DEPTH_COMPONENT))
    return raise_error(c, GL_INVALID_OPERATION);
  if (target->proxy) return define_proxy(c, image);
  if (!image_fits(c, image)) return raise_error(c, GL_INVALID_VALUE);
  if (refuses_indices(c, call)) return;
  const PixelStore inner = inside_border(store, image);
  const ImageSize size = size_without_border(image);
  if (!pixels || !size.texels()) return define_image(c, image, nullptr);
  const Texels texels = unpack_texels(inner, pixels, size, call.format, call.type, format.base,
                                      c.backend->textures().takes_bytes_only());
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
  if ((base == BaseFormat::kDepth) != (call.format == GL_DEPTH_COMPONENT))
    return raise_error(c, GL_INVALID_OPERATION);
  if (refuses_indices(c, call) || !pixels || !call.size.texels()) return;
  texture_changes(c);
  c.backend->textures().replace(place, call.offset, call.size,
                                unpack_texels(store, pixels, call.size, call.format, call.type,
                                              base, c.backend->textures().takes_bytes_only()));
  image_changed(c, place);
}

void execute(Context& c, const ImageCall& call, const PixelStore& store, const void* pixels) {
  if (refused_inside(c)) return;
  PixelStore applied = store;
  if (call.dimensions < 3) applied.skip_images = applied.image_height = 0;
  try {
    if (call.replaces_part) replace(c, call, applied, pixels);
    else define(c, call, applied, pixels);
  } catch (const std::bad_alloc&) {
    raise_error(c, GL_OUT_OF_MEMORY);
  }
}

/// In a list: the call, and behind it the image without gaps when there is one.
struct RecordedImage {
  ImageCall call;
  bool has_pixels, swap_bytes;
};

void play_image(Context& c, const void* payload) {
  RecordedImage head;
  std::memcpy(&head, payload, sizeof head);
  PixelStore store;
  store.alignment = 1;
  store.swap_bytes = head.swap_bytes;
  const std::byte* const pixels = static_cast<const std::byte*>(payload) + sizeof head;
  execute(c, head.call, store, head.has_pixels ? pixels : nullptr);
}

/// Display lists keep what the pointer points to now (GL 2.1 spec 5.4).
void record(Context& c, const ImageCall& call, const void* pixels) {
  RecordedImage head{call, false, c.unpack.swap_bytes};
  const ImageSize& size = call.size;
  const bool sized = size.width > 0 && size.height > 0 && size.depth > 0;
  head.has_pixels = pixels && sized && call.type != GL_BITMAP && !transfer_error(call);
  const std::size_t row =
      sized ? static_cast<std::size_t>(size.width) * bytes_per_pixel(call.format, call.type) : 0;
  const std::size_t rows =
      sized ? static_cast<std::size_t>(size.height) * static_cast<std::size_t>(size.depth) : 0;
  auto* to = static_cast<std::byte*>(
      c.lists.append(&play_image, sizeof head + (head.has_pixels ? row * rows : 0)));
  std::memcpy(to, &head, sizeof head);
  if (!head.has_pixels) return;
  to += sizeof head;
  PixelStore store = c.unpack;
  if (call.dimensions < 3) store.skip_images = store.image_height = 0;
  const ImageRows at = image_rows(store, size, call.format, call.type);
  for (std::size_t i = 0; i < rows; ++i, to += row) {
    const auto height = static_cast<std::size_t>(size.height);
    std::memcpy(to, static_cast<const std::byte*>(pixels) + at(i / height, i % height), row);
  }
}

void image_call(const ImageCall& call, const void* pixels) {
  Context* const context = current_context;
  if (!context) return report_no_context();
  const std::optional<ImageTarget> target = image_target(call.target, call.dimensions);
  const bool proxy = target && target->proxy;  // executed at once (GL 2.1 spec 5.4)
  if (context->lists.compiling && !proxy) {
    record(*context, call, pixels);
    if (context->lists.mode == GL_COMPILE) return;
  }
  execute(*context, call, context->unpack, pixels);
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
