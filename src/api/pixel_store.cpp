// GL 2.1 spec 3.6.1, 4.3.2: glPixelStore. Client state: no display list holds it.
#include <cmath>
#include <limits>

#include "dlist/dispatch.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

struct PixelStoreField {
  GLint* number = nullptr;
  bool* flag = nullptr;
};

PixelStoreField find_field(PixelStore& pack, PixelStore& unpack, GLenum name) {
  switch (name) {
    case GL_PACK_SWAP_BYTES: return {.flag = &pack.swap_bytes};
    case GL_PACK_LSB_FIRST: return {.flag = &pack.lsb_first};
    case GL_PACK_ROW_LENGTH: return {.number = &pack.row_length};
    case GL_PACK_IMAGE_HEIGHT: return {.number = &pack.image_height};
    case GL_PACK_SKIP_PIXELS: return {.number = &pack.skip_pixels};
    case GL_PACK_SKIP_ROWS: return {.number = &pack.skip_rows};
    case GL_PACK_SKIP_IMAGES: return {.number = &pack.skip_images};
    case GL_PACK_ALIGNMENT: return {.number = &pack.alignment};
    case GL_UNPACK_SWAP_BYTES: return {.flag = &unpack.swap_bytes};
    case GL_UNPACK_LSB_FIRST: return {.flag = &unpack.lsb_first};
    case GL_UNPACK_ROW_LENGTH: return {.number = &unpack.row_length};
    case GL_UNPACK_IMAGE_HEIGHT: return {.number = &unpack.image_height};
    case GL_UNPACK_SKIP_PIXELS: return {.number = &unpack.skip_pixels};
    case GL_UNPACK_SKIP_ROWS: return {.number = &unpack.skip_rows};
    case GL_UNPACK_SKIP_IMAGES: return {.number = &unpack.skip_images};
    case GL_UNPACK_ALIGNMENT: return {.number = &unpack.alignment};
    default: return {};
  }
}

bool is_alignment(GLint value) { return value == 1 || value == 2 || value == 4 || value == 8; }

void pixel_store(Context& c, GLenum name, GLint value) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  const PixelStoreField field = find_field(c.pack, c.unpack, name);
  if (field.flag) {
    *field.flag = value != 0;
    return;
  }
  if (!field.number) return raise_error(c, GL_INVALID_ENUM);
  const bool valid =
      name == GL_PACK_ALIGNMENT || name == GL_UNPACK_ALIGNMENT ? is_alignment(value) : value >= 0;
  if (!valid) return raise_error(c, GL_INVALID_VALUE);
  *field.number = value;
}

/// A number is rounded, a flag is true when not zero: 0.2 is true (GL 2.1 spec 3.6.1).
GLint pixel_store_value(GLenum name, GLfloat value) {
  switch (name) {
    case GL_PACK_SWAP_BYTES:
    case GL_PACK_LSB_FIRST:
    case GL_UNPACK_SWAP_BYTES:
    case GL_UNPACK_LSB_FIRST: return value != 0;
    default: break;
  }
  constexpr auto kLimit = static_cast<float>(std::numeric_limits<GLint>::max());
  if (!(std::abs(value) < kLimit)) return -1;
  return static_cast<GLint>(std::round(value));
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglPixelStorei(GLenum pname, GLint param) {
  execute_now<pixel_store>(pname, param);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglPixelStoref(GLenum pname, GLfloat param) {
  execute_now<pixel_store>(pname, pixel_store_value(pname, param));
}
