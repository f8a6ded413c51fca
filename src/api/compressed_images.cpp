// GL 2.1 spec 3.8.3, 6.1.4: images in compressed formats. The formats are those of
// EXT_texture_compression_s3tc, which has them in two dimensions alone, where the driver offers
// them.
#include <memory>
#include <new>
#include <vector>

#include "api/texture_image_rules.hpp"
#include "dlist/dispatch.hpp"
#include "record/pending.hpp"
#include "texture/compressed_format.hpp"

using namespace legacy_gl;

namespace {

/// The arguments of all of them; sizes that the call does not have are 1, offsets 0.
struct CompressedCall {
  GLenum target;
  unsigned dimensions;
  GLint level;
  bool replaces_part;
  GLenum format;
  GLint border;
  ImageOffset offset;
  ImageSize size;
  GLsizei bytes;
};

/// What the target and the format say together.
GLenum format_error(const Context& c, const CompressedCall& call) {
  const std::optional<ImageTarget> target = image_target(call.target, call.dimensions);
  const bool offered =
      bytes_of_block(static_cast<GLint>(call.format)) && c.driver->textures.offers_s3tc();
  return target && offered && call.dimensions == 2 ? GLenum{GL_NO_ERROR} : GLenum{GL_INVALID_ENUM};
}

bool has_size(const CompressedCall& call) {
  return call.bytes >= 0 &&
         static_cast<std::size_t>(call.bytes) ==
             compressed_size(static_cast<GLint>(call.format), call.size.width, call.size.height);
}

void define(Context& c, const CompressedCall& call, const void* data) {
  if (const GLenum error = format_error(c, call)) return raise_error(c, error);
  const ImageTarget target = *image_target(call.target, call.dimensions);
  const NewImage image{target, call.level, static_cast<GLint>(call.format), call.border, call.size};
  if (const GLenum error = new_image_error(c, image)) return raise_error(c, error);
  if (call.border || !has_size(call)) return raise_error(c, GL_INVALID_VALUE);
  if (target.proxy) return define_compressed_proxy(c, image);
  if (!image_fits(c, image)) return raise_error(c, GL_INVALID_VALUE);
  define_compressed_image(c, image, data, call.bytes);
}

void replace(Context& c, const CompressedCall& call, const void* data) {
  if (const GLenum error = format_error(c, call)) return raise_error(c, error);
  const ImageTarget target = *image_target(call.target, call.dimensions);
  if (target.proxy) return raise_error(c, GL_INVALID_ENUM);
  if (const GLenum error = level_error(c, target, call.level)) return raise_error(c, error);
  const ImagePlace place{bound_texture(c, target.target), target.face, call.level};
  const TextureImage& image = place.texture.images.at(place.face, place.level);
  if (image.internal_format != static_cast<GLint>(call.format))
    return raise_error(c, GL_INVALID_OPERATION);
  if (const GLenum error = part_error(place, call.offset, call.size)) return raise_error(c, error);
  if (!has_size(call)) return raise_error(c, GL_INVALID_VALUE);
  if (!data || !call.bytes) return;
  before_texture_change(c);
  c.driver->textures.replace_compressed(place, call.offset, call.size, data, call.bytes);
  image_changed(c, place);
}

void execute(Context& c, const CompressedCall& call, const void* data) {
  if (refused_inside(c)) return;
  if (call.replaces_part) replace(c, call, data);
  else define(c, call, data);
}

using Bytes = std::vector<std::byte>;

/// In a list; nullptr: without data.
void play_compressed(Context& c, const CompressedCall& call, const Bytes* data) {
  execute(c, call, data ? data->data() : nullptr);
}

void call_or_record(Context& context, const CompressedCall& call, const void* data) {
  const std::optional<ImageTarget> target = image_target(call.target, call.dimensions);
  const bool proxy = target && target->proxy;  // executed at once (GL 2.1 spec 5.4)
  if (!context.list_modes.compiling || proxy) return execute(context, call, data);
  const Bytes* recorded = nullptr;
  if (data && has_size(call)) {
    const auto* const bytes = static_cast<const std::byte*>(data);
    const auto kept = std::make_shared<const Bytes>(bytes, bytes + call.bytes);
    context.lists.keep(kept);
    recorded = kept.get();
  }
  dispatch<play_compressed>(call, recorded);
}

void compressed_call(const CompressedCall& call, const void* data) {
  with_context([&](Context& context) { call_or_record(context, call, data); });
}

void get_compressed_tex_image(Context& c, GLenum target_name, GLint level, void* data) {
  if (refused_inside(c)) return;
  const std::optional<ImageTarget> target = image_target(target_name, 0);
  if (!target || target->proxy) return raise_error(c, GL_INVALID_ENUM);
  if (const GLenum error = level_error(c, *target, level)) return raise_error(c, error);
  const ImagePlace place{bound_texture(c, target->target), target->face, level};
  if (!bytes_of_block(place.texture.images.at(place.face, level).internal_format))
    return raise_error(c, GL_INVALID_OPERATION);
  if (c.driver->functions.is_es()) {
    diagnose(c, "glGetCompressedTexImage: this driver (OpenGL ES) reads no compressed images");
    return raise_error(c, GL_INVALID_OPERATION);
  }
  if (data) c.driver->textures.read_compressed(place, data);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglCompressedTexImage1D(GLenum target, GLint level,
                                                              GLenum internalformat, GLsizei width,
                                                              GLint border, GLsizei imageSize,
                                                              const void* data) {
  compressed_call({target, 1, level, false, internalformat, border, {}, {width, 1, 1}, imageSize},
                  data);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCompressedTexImage2D(GLenum target, GLint level,
                                                              GLenum internalformat, GLsizei width,
                                                              GLsizei height, GLint border,
                                                              GLsizei imageSize, const void* data) {
  compressed_call(
      {target, 2, level, false, internalformat, border, {}, {width, height, 1}, imageSize}, data);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCompressedTexImage3D(GLenum target, GLint level,
                                                              GLenum internalformat, GLsizei width,
                                                              GLsizei height, GLsizei depth,
                                                              GLint border, GLsizei imageSize,
                                                              const void* data) {
  compressed_call(
      {target, 3, level, false, internalformat, border, {}, {width, height, depth}, imageSize},
      data);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCompressedTexSubImage1D(GLenum target, GLint level,
                                                                 GLint xoffset, GLsizei width,
                                                                 GLenum format, GLsizei imageSize,
                                                                 const void* data) {
  compressed_call({target, 1, level, true, format, 0, {xoffset}, {width, 1, 1}, imageSize}, data);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCompressedTexSubImage2D(GLenum target, GLint level,
                                                                 GLint xoffset, GLint yoffset,
                                                                 GLsizei width, GLsizei height,
                                                                 GLenum format, GLsizei imageSize,
                                                                 const void* data) {
  compressed_call(
      {target, 2, level, true, format, 0, {xoffset, yoffset}, {width, height, 1}, imageSize}, data);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCompressedTexSubImage3D(
    GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset, GLsizei width,
    GLsizei height, GLsizei depth, GLenum format, GLsizei imageSize, const void* data) {
  compressed_call({target,
                   3,
                   level,
                   true,
                   format,
                   0,
                   {xoffset, yoffset, zoffset},
                   {width, height, depth},
                   imageSize},
                  data);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetCompressedTexImage(GLenum target, GLint lod,
                                                               void* img) {
  execute_now<get_compressed_tex_image>(target, lod, img);
}
