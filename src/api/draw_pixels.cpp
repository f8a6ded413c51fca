// GL 2.1 spec 3.6.4, 4.3.3: glDrawPixels, glCopyPixels.
#include <memory>

#include "api/pixel_buffers.hpp"
#include "cpu_pipeline/feedback.hpp"
#include "dlist/dispatch.hpp"
#include "driver/driver_objects.hpp"
#include "driver/read_pixels.hpp"
#include "execute/framebuffer.hpp"
#include "record/pending.hpp"
#include "submit/pixels.hpp"
#include "texture/pixel_format.hpp"
#include "texture/recorded_pixels.hpp"

using namespace legacy_gl;

namespace {

struct PixelCall {
  GLsizei width, height;
  GLenum format, type;
};

PixelSource source_of(GLenum format) {
  if (format == GL_DEPTH_COMPONENT) return PixelSource::kDepths;
  return format == GL_STENCIL_INDEX ? PixelSource::kStencil : PixelSource::kColors;
}

GLenum draw_error(const Context& c, const PixelCall& call) {
  if (c.recorder.inside_begin_end()) return GL_INVALID_OPERATION;
  if (call.width < 0 || call.height < 0) return GL_INVALID_VALUE;
  if (const GLenum error = pixel_rectangle_error(call.format, call.type)) return error;
  return missing_buffer_error(c, call.format);
}

void draw_depth_stencil(Context& c, const PixelCall& call, const PixelStore& store,
                        const void* pixels) {
  const ImageSize size{call.width, call.height, 1};
  DepthStencilTexels texels = unpack_depth_stencil(store, pixels, size, c.pixels);
  flush_pending(c);
  draw_pixels(c, {PixelSource::kStencil, call.width, call.height, std::move(texels.stencil)});
  draw_pixels(c, {PixelSource::kDepths, call.width, call.height, std::move(texels.depths), true});
}

void draw(Context& c, const PixelCall& call, const PixelStore& store, const void* pixels) {
  if (call.format == kDepthStencil) return draw_depth_stencil(c, call, store, pixels);
  const ImageSize size{call.width, call.height, 1};
  PixelImage image{source_of(call.format), call.width, call.height, {}};
  switch (image.source) {
    case PixelSource::kDepths:
      image.texels = unpack_depths(store, pixels, size, call.type, c.pixels);
      break;
    case PixelSource::kStencil:
      image.texels = unpack_stencil(store, pixels, size, call.type, c.pixels);
      break;
    default:
      image.texels = unpack_texels(store, pixels, size, call.format, call.type, BaseFormat::kRgba,
                                   false, c.pixels);
  }
  flush_pending(c);
  draw_pixels(c, image);
}

void draw_pixels(Context& c, const PixelCall& call, const PixelStore& store, const void* pixels) {
  if (const GLenum error = draw_error(c, call)) return raise_error(c, error);
  if (!c.current.raster.valid) return;
  if (c.selection.is_feeding_back()) feed_back_raster_position(c, GL_DRAW_PIXEL_TOKEN);
  if (!c.selection.is_rendering() || !pixels || !call.width || !call.height) return;
  PixelStore applied = store;
  applied.skip_images = applied.image_height = 0;
  draw(c, call, applied, pixels);
}

/// Of a display list; nullptr: without pixels.
void play_pixels(Context& c, PixelCall call, const RecordedPixels* recorded) {
  if (!recorded) return draw_pixels(c, call, PixelStore{}, nullptr);
  call.type = recorded->type;
  draw_pixels(c, call, recorded->store, recorded->bytes.data());
}

void record_pixel_call(Context& c, const PixelCall& call, const void* pixels) {
  const RecordedPixels* recorded = nullptr;
  if (pixels && call.width > 0 && call.height > 0 &&
      !pixel_rectangle_error(call.format, call.type)) {
    PixelStore store = c.unpack;
    store.skip_images = store.image_height = 0;
    const auto kept = std::make_shared<const RecordedPixels>(
        record_pixels(store, pixels, {call.width, call.height, 1}, call.format, call.type));
    c.lists.keep(kept);
    recorded = kept.get();
  }
  dispatch<play_pixels>(call, recorded);
}

/// The format in which glCopyPixels reads; GL_NONE: `type` names no buffer.
GLenum copied_format(GLenum type) {
  switch (type) {
    case GL_COLOR: return GL_RGBA;
    case GL_DEPTH: return GL_DEPTH_COMPONENT;
    case GL_STENCIL: return GL_STENCIL_INDEX;
    case kDepthStencil: return kDepthStencil;
    default: return GL_NONE;
  }
}

void copy_pixels(Context& c, PixelRectangle from, GLenum type) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  const GLenum format = copied_format(type);
  if (format == GL_NONE) return raise_error(c, GL_INVALID_ENUM);
  if (from.width < 0 || from.height < 0) return raise_error(c, GL_INVALID_VALUE);
  if (const GLenum error = missing_buffer_error(c, format)) return raise_error(c, error);
  if (const GLenum error = multisampled_object_error(c)) return raise_error(c, error);
  const Driver& driver = c.driver->functions;
  if (!can_read_pixels(driver, format)) {
    diagnose(c, "glCopyPixels: this driver (OpenGL ES) reads colours alone");
    return raise_error(c, GL_INVALID_OPERATION);
  }
  if (!c.current.raster.valid) return;
  if (c.selection.is_feeding_back()) feed_back_raster_position(c, GL_COPY_PIXEL_TOKEN);
  if (!c.selection.is_rendering() || !from.width || !from.height) return;
  const GLenum element = format == kDepthStencil      ? kUnsignedInt24_8
                         : format == GL_STENCIL_INDEX ? GL_UNSIGNED_BYTE
                         : format == GL_RGBA && !c.pixels.changes_colors() && !reads_floats(driver)
                             ? GL_UNSIGNED_BYTE
                             : GL_FLOAT;
  flush_pending(c);
  PixelStore store;
  store.alignment = 1;
  std::vector<std::byte> pixels(static_cast<std::size_t>(from.width) *
                                static_cast<std::size_t>(from.height) *
                                bytes_per_pixel(format, element));
  read_pixels(driver, from, store, format, element, PixelState{}, pixels.data());
  draw(c, {from.width, from.height, format, element}, store, pixels.data());
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglDrawPixels(GLsizei width, GLsizei height, GLenum format,
                                                    GLenum type, const void* pixels) {
  const PixelCall call{width, height, format, type};
  with_context([&](Context& c) {
    if (c.list_modes.compiling) record_pixel_call(c, call, pixels);
    else draw_pixels(c, call, c.unpack, pixels);
  });
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglCopyPixels(GLint x, GLint y, GLsizei width, GLsizei height,
                                                    GLenum type) {
  dispatch<copy_pixels>(PixelRectangle{x, y, width, height}, type);
}
