// GL 2.1 spec 5.6: glHint. The hints are kept and asked for; no drawing depends on one.
#include "dlist/dispatch.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

GLenum* find_hint(HintState& hints, GLenum target) {
  switch (target) {
    case GL_PERSPECTIVE_CORRECTION_HINT: return &hints.perspective_correction;
    case GL_POINT_SMOOTH_HINT: return &hints.point_smooth;
    case GL_LINE_SMOOTH_HINT: return &hints.line_smooth;
    case GL_POLYGON_SMOOTH_HINT: return &hints.polygon_smooth;
    case GL_FOG_HINT: return &hints.fog;
    case GL_GENERATE_MIPMAP_HINT: return &hints.generate_mipmap;
    case GL_TEXTURE_COMPRESSION_HINT: return &hints.texture_compression;
    case GL_PHONG_HINT_WIN: return &hints.phong;
    default: return nullptr;
  }
}

void set_hint(Context& c, GLenum target, GLenum mode) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  GLenum* const hint = find_hint(c.hints, target);
  if (!hint || (mode != GL_FASTEST && mode != GL_NICEST && mode != GL_DONT_CARE))
    return raise_error(c, GL_INVALID_ENUM);
  *hint = mode;
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglHint(GLenum target, GLenum mode) {
  dispatch<set_hint>(target, mode);
}
