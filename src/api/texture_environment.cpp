// GL 2.1 spec 3.8.13: glTexEnv and glGetTexEnv.
#include <cmath>

#include "api/texture_targets.hpp"
#include "dlist/dispatch.hpp"
#include "execute/queries.hpp"
#include "record/normalise.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

struct Values {
  std::array<float, 4> v{};
  GLenum as_enum() const {
    return v[0] >= 0 && v[0] < 65536 ? static_cast<GLenum>(v[0]) : GLenum{GL_INVALID_ENUM};
  }
};

bool is_mode(GLenum mode) {
  switch (mode) {
    case GL_MODULATE:
    case GL_REPLACE:
    case GL_DECAL:
    case GL_BLEND:
    case GL_ADD:
    case GL_COMBINE: return true;
    default: return false;
  }
}

bool is_function(GLenum function, bool alpha) {
  switch (function) {
    case GL_REPLACE:
    case GL_MODULATE:
    case GL_ADD:
    case GL_ADD_SIGNED:
    case GL_INTERPOLATE:
    case GL_SUBTRACT: return true;
    case GL_DOT3_RGB:
    case GL_DOT3_RGBA: return !alpha;
    default: return false;
  }
}

bool is_source(GLenum source) {
  switch (source) {
    case GL_TEXTURE:
    case GL_CONSTANT:
    case GL_PRIMARY_COLOR:
    case GL_PREVIOUS: return true;
    default: return source - GL_TEXTURE0 < kMaxTextureUnits;
  }
}

bool is_operand(GLenum operand, bool alpha) {
  if (operand == GL_SRC_ALPHA || operand == GL_ONE_MINUS_SRC_ALPHA) return true;
  return !alpha && (operand == GL_SRC_COLOR || operand == GL_ONE_MINUS_SRC_COLOR);
}

/// Where a name of the combine environment has its place; nullptr for another name.
GLenum* combine_field(TextureEnvironment& e, GLenum name, bool (*&valid)(GLenum, bool),
                      bool& alpha) {
  alpha = false;
  valid = [](GLenum source, bool) { return is_source(source); };
  if (const GLenum i = name - GL_SRC0_RGB; i < 3) return &e.rgb.sources[i];
  if (const GLenum i = name - GL_SRC0_ALPHA; i < 3) return &e.alpha.sources[i];
  valid = is_operand;
  if (const GLenum i = name - GL_OPERAND0_RGB; i < 3) return &e.rgb.operands[i];
  alpha = true;
  if (const GLenum i = name - GL_OPERAND0_ALPHA; i < 3) return &e.alpha.operands[i];
  valid = is_function;
  if (name == GL_COMBINE_ALPHA) return &e.alpha.function;
  alpha = false;
  return name == GL_COMBINE_RGB ? &e.rgb.function : nullptr;
}

GLenum set(TextureEnvironment& e, GLenum name, const Values& values) {
  const GLenum value = values.as_enum();
  switch (name) {
    case GL_TEXTURE_ENV_MODE:
      if (!is_mode(value)) return GL_INVALID_ENUM;
      e.mode = value;
      return GL_NO_ERROR;
    case GL_TEXTURE_ENV_COLOR:
      for (int i = 0; i < 4; ++i)
        e.color[i] = std::clamp(values.v[static_cast<unsigned>(i)], 0.0f, 1.0f);
      return GL_NO_ERROR;
    case GL_RGB_SCALE:
    case GL_ALPHA_SCALE: {
      const float scale = values.v[0];
      if (scale != 1 && scale != 2 && scale != 4) return GL_INVALID_VALUE;
      (name == GL_RGB_SCALE ? e.rgb : e.alpha).scale = scale;
      return GL_NO_ERROR;
    }
    default: break;
  }
  bool (*valid)(GLenum, bool) = nullptr;
  bool alpha = false;
  GLenum* const field = combine_field(e, name, valid, alpha);
  if (!field || !valid(value, alpha)) return GL_INVALID_ENUM;
  *field = value;
  return GL_NO_ERROR;
}

void tex_env(Context& c, GLenum target, GLenum name, Values values, bool vector) {
  if (refused_inside(c)) return;
  TextureEnvironment environment = active_unit(c).environment;
  GLenum error = GL_INVALID_ENUM;
  if (target == GL_TEXTURE_FILTER_CONTROL && name == GL_TEXTURE_LOD_BIAS) {
    environment.lod_bias = values.v[0];
    error = GL_NO_ERROR;
  } else if (target == GL_TEXTURE_ENV && (vector || name != GL_TEXTURE_ENV_COLOR)) {
    error = set(environment, name, values);
  }
  if (error) return raise_error(c, error);
  if (environment == active_unit(c).environment) return;
  before_texture_change(c);
  active_unit(c).environment = environment;
}

template <typename T>
Values read(GLenum name, const T* values) {
  Values result;
  if (!values) return result;
  const unsigned count = name == GL_TEXTURE_ENV_COLOR ? 4 : 1;
  for (unsigned i = 0; i < count; ++i) {
    if constexpr (std::is_integral_v<T>)
      result.v[i] = count == 4 ? normalised(values[i]) : static_cast<float>(values[i]);
    else result.v[i] = static_cast<float>(values[i]);
  }
  return result;
}

bool read_environment(TextureEnvironment e, GLenum name, QueryValues& v) {
  v.kind = ValueKind::kInteger;
  switch (name) {
    case GL_TEXTURE_ENV_MODE: v.put(e.mode); return true;
    case GL_TEXTURE_ENV_COLOR:
      v.kind = ValueKind::kNormalised;
      v.put(e.color);
      return true;
    case GL_RGB_SCALE: v.put(static_cast<double>(e.rgb.scale)); return true;
    case GL_ALPHA_SCALE: v.put(static_cast<double>(e.alpha.scale)); return true;
    default: break;
  }
  bool (*valid)(GLenum, bool) = nullptr;
  bool alpha = false;
  const GLenum* const field = combine_field(e, name, valid, alpha);
  if (field) v.put(*field);
  return field != nullptr;
}

template <typename T>
void get_tex_env(Context& c, GLenum target, GLenum name, T* results) {
  if (refused_inside(c)) return;
  QueryValues values;
  bool known = false;
  if (target == GL_TEXTURE_FILTER_CONTROL && name == GL_TEXTURE_LOD_BIAS) {
    values.kind = ValueKind::kFloat;
    values.put(static_cast<double>(active_unit(c).environment.lod_bias));
    known = true;
  } else if (target == GL_TEXTURE_ENV) {
    known = read_environment(active_unit(c).environment, name, values);
  }
  if (!known) return raise_error(c, GL_INVALID_ENUM);
  for (unsigned i = 0; results && i < values.count; ++i) {
    if constexpr (std::is_same_v<T, GLint>) results[i] = as_integer(values.kind, values.values[i]);
    else results[i] = static_cast<T>(values.values[i]);
  }
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexEnvf(GLenum target, GLenum pname, GLfloat param) {
  dispatch<tex_env>(target, pname, Values{{param}}, false);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexEnvi(GLenum target, GLenum pname, GLint param) {
  dispatch<tex_env>(target, pname, Values{{static_cast<float>(param)}}, false);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexEnvfv(GLenum target, GLenum pname,
                                                  const GLfloat* params) {
  dispatch<tex_env>(target, pname, read(pname, params), true);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexEnviv(GLenum target, GLenum pname,
                                                  const GLint* params) {
  dispatch<tex_env>(target, pname, read(pname, params), true);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetTexEnvfv(GLenum target, GLenum pname, GLfloat* params) {
  execute_now<get_tex_env<GLfloat>>(target, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetTexEnviv(GLenum target, GLenum pname, GLint* params) {
  execute_now<get_tex_env<GLint>>(target, pname, params);
}
