// GL 2.1 spec 3.10: glFog.
#include <algorithm>

#include "api/scalar_parameters.hpp"
#include "dlist/dispatch.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

using Floats4 = std::array<float, 4>;

unsigned fog_parameter_count(GLenum pname) {
  switch (pname) {
    case GL_FOG_COLOR: return 4;
    case GL_FOG_MODE:
    case GL_FOG_DENSITY:
    case GL_FOG_START:
    case GL_FOG_END:
    case GL_FOG_INDEX:
    case GL_FOG_COORD_SRC: return 1;
    default: return 0;
  }
}

GLenum to_enum(float value) { return static_cast<GLenum>(std::clamp(value, 0.0f, 65535.0f)); }

void set_fog(Context& c, GLenum pname, Floats4 v) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  FogState& fog = c.fog;
  switch (pname) {
    case GL_FOG_MODE: {
      const GLenum mode = to_enum(v[0]);
      if (mode != GL_LINEAR && mode != GL_EXP && mode != GL_EXP2)
        return raise_error(c, GL_INVALID_ENUM);
      assign(c, fog.mode, mode, kDirtyKey | kDirtyFragments);
      return;
    }
    case GL_FOG_COORD_SRC: {
      const GLenum source = to_enum(v[0]);
      if (source != GL_FOG_COORD && source != GL_FRAGMENT_DEPTH)
        return raise_error(c, GL_INVALID_ENUM);
      assign(c, fog.coordinate_source, source, kDirtyKey);
      return;
    }
    case GL_FOG_DENSITY:
      if (v[0] < 0) return raise_error(c, GL_INVALID_VALUE);
      assign(c, fog.density, v[0], kDirtyFragments);
      return;
    case GL_FOG_START: assign(c, fog.start, v[0], kDirtyFragments); return;
    case GL_FOG_END: assign(c, fog.end, v[0], kDirtyFragments); return;
    case GL_FOG_INDEX: fog.index = v[0]; return;
    case GL_FOG_COLOR:
      assign(c, fog.color, glm::vec4(v[0], v[1], v[2], v[3]), kDirtyFragments);
      return;
    default: raise_error(c, GL_INVALID_ENUM);
  }
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglFogf(GLenum pname, GLfloat param) {
  dispatch<set_fog>(scalar_only(pname, fog_parameter_count(pname)), Floats4{param});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglFogi(GLenum pname, GLint param) {
  dispatch<set_fog>(scalar_only(pname, fog_parameter_count(pname)),
                    Floats4{static_cast<float>(param)});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglFogfv(GLenum pname, const GLfloat* params) {
  Floats4 values{};
  std::copy_n(params, fog_parameter_count(pname), values.begin());
  dispatch<set_fog>(pname, values);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglFogiv(GLenum pname, const GLint* params) {
  Floats4 values{};
  for (unsigned i = 0; i < fog_parameter_count(pname); ++i)
    // Integer colours map to [-1, 1] (GL 2.1 spec table 2.9).
    values[i] = pname == GL_FOG_COLOR ? static_cast<float>((2.0 * params[i] + 1.0) / 4294967295.0)
                                      : static_cast<float>(params[i]);
  dispatch<set_fog>(pname, values);
}
