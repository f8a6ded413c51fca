// GL 2.1 spec 3.8.4: glTexParameter.
#include <algorithm>
#include <cmath>

#include "api/scalar_parameters.hpp"
#include "api/texture_targets.hpp"
#include "dlist/dispatch.hpp"
#include "driver/driver_objects.hpp"
#include "record/normalise.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

/// The values of a call, whatever type they came in; a double holds each exactly. Colours that came
/// as integers are normalised already.
struct Values {
  std::array<double, 4> v{};
  GLenum as_enum() const { return v[0] >= 0 ? static_cast<GLenum>(v[0]) : GLenum{GL_INVALID_ENUM}; }
  GLint as_integer() const {
    return static_cast<GLint>(std::clamp(std::round(v[0]), -2147483648.0, 2147483647.0));
  }
  float as_float() const { return static_cast<float>(v[0]); }
};

bool is_min_filter(GLenum filter) {
  return filter == GL_NEAREST || filter == GL_LINEAR ||
         (filter >= GL_NEAREST_MIPMAP_NEAREST && filter <= GL_LINEAR_MIPMAP_LINEAR);
}

bool is_wrap(GLenum mode) {
  switch (mode) {
    case GL_CLAMP:
    case GL_CLAMP_TO_EDGE:
    case GL_CLAMP_TO_BORDER:
    case GL_REPEAT:
    case GL_MIRRORED_REPEAT: return true;
    default: return false;
  }
}

/// Stores the value where it is valid, and says the error where not.
GLenum set(TextureParameters& p, GLenum name, const Values& values) {
  const GLenum value = values.as_enum();
  const auto store = [&](GLenum& field, bool valid) -> GLenum {
    if (!valid) return GL_INVALID_ENUM;
    field = value;
    return GL_NO_ERROR;
  };
  const auto store_level = [&](GLint& field) -> GLenum {
    if (values.as_integer() < 0) return GL_INVALID_VALUE;
    field = values.as_integer();
    return GL_NO_ERROR;
  };
  switch (name) {
    case GL_TEXTURE_MIN_FILTER: return store(p.min_filter, is_min_filter(value));
    case GL_TEXTURE_MAG_FILTER:
      return store(p.mag_filter, value == GL_NEAREST || value == GL_LINEAR);
    case GL_TEXTURE_WRAP_S: return store(p.wrap[0], is_wrap(value));
    case GL_TEXTURE_WRAP_T: return store(p.wrap[1], is_wrap(value));
    case GL_TEXTURE_WRAP_R: return store(p.wrap[2], is_wrap(value));
    case GL_TEXTURE_BASE_LEVEL: return store_level(p.base_level);
    case GL_TEXTURE_MAX_LEVEL: return store_level(p.max_level);
    case GL_DEPTH_TEXTURE_MODE:
      return store(p.depth_mode,
                   value == GL_LUMINANCE || value == GL_INTENSITY || value == GL_ALPHA);
    case GL_TEXTURE_COMPARE_MODE:
      return store(p.compare_mode, value == GL_NONE || value == GL_COMPARE_R_TO_TEXTURE);
    case GL_TEXTURE_COMPARE_FUNC:
      return store(p.compare_function, value >= GL_NEVER && value <= GL_ALWAYS);
    case GL_TEXTURE_MIN_LOD: p.min_lod = values.as_float(); return GL_NO_ERROR;
    case GL_TEXTURE_MAX_LOD: p.max_lod = values.as_float(); return GL_NO_ERROR;
    case GL_TEXTURE_LOD_BIAS: p.lod_bias = values.as_float(); return GL_NO_ERROR;
    case GL_GENERATE_MIPMAP: p.generate_mipmap = values.v[0] != 0; return GL_NO_ERROR;
    case GL_TEXTURE_PRIORITY:
      p.priority = std::clamp(values.as_float(), 0.0f, 1.0f);
      return GL_NO_ERROR;
    case GL_TEXTURE_BORDER_COLOR:
      for (int i = 0; i < 4; ++i)
        p.border_color[i] =
            static_cast<float>(std::clamp(values.v[static_cast<unsigned>(i)], 0.0, 1.0));
      return GL_NO_ERROR;
    default: return GL_INVALID_ENUM;
  }
}

void tex_parameter(Context& c, GLenum target_name, GLenum name, Values values, bool vector) {
  if (refused_inside(c)) return;
  const std::optional<TextureTarget> target = texture_target(target_name);
  if (!target || (name == GL_TEXTURE_BORDER_COLOR && !vector))
    return raise_error(c, GL_INVALID_ENUM);
  TextureObject& texture = bound_texture(c, *target);
  TextureParameters parameters = texture.parameters;
  if (const GLenum error = set(parameters, name, values)) return raise_error(c, error);
  if (parameters == texture.parameters) return;
  before_texture_change(c);
  texture.parameters = parameters;
  texture.parameters_stale = true;
  if (!c.driver->textures.has_border_color() &&
      std::count(parameters.wrap.begin(), parameters.wrap.end(), GL_CLAMP_TO_BORDER))
    diagnose(
        c, "glTexParameter: this driver (OpenGL ES) has no border colour; the edge stands for it");
}

template <typename T>
Values read(GLenum name, const T* values) {
  Values result;
  if (!values) return result;
  if (name != GL_TEXTURE_BORDER_COLOR) {
    result.v[0] = static_cast<double>(values[0]);
    return result;
  }
  for (unsigned i = 0; i < 4; ++i) {
    if constexpr (std::is_integral_v<T>) result.v[i] = static_cast<double>(normalised(values[i]));
    else result.v[i] = static_cast<double>(values[i]);
  }
  return result;
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexParameterf(GLenum target, GLenum pname, GLfloat param) {
  dispatch<tex_parameter>(target, pname, Values{{static_cast<double>(param)}},
                          takes_scalars_for_vectors());
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexParameteri(GLenum target, GLenum pname, GLint param) {
  dispatch<tex_parameter>(target, pname, Values{{static_cast<double>(param)}},
                          takes_scalars_for_vectors());
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexParameterfv(GLenum target, GLenum pname,
                                                        const GLfloat* params) {
  dispatch<tex_parameter>(target, pname, read(pname, params), true);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexParameteriv(GLenum target, GLenum pname,
                                                        const GLint* params) {
  dispatch<tex_parameter>(target, pname, read(pname, params), true);
}
