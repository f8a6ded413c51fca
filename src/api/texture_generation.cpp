// GL 2.1 spec 2.11.4: glTexGen and glGetTexGen.
#include <cmath>
#include <glm/matrix.hpp>

#include "api/scalar_parameters.hpp"
#include "api/texture_targets.hpp"
#include "dlist/dispatch.hpp"
#include "execute/queries.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

struct Values {
  std::array<double, 4> v{};
};

TexgenCoordinate* find_coordinate(Context& c, GLenum name) {
  const GLenum i = name - GL_S;
  return i < 4 ? &active_unit(c).texgen.coordinates[i] : nullptr;
}

bool is_mode(GLenum coordinate, GLenum mode) {
  switch (mode) {
    case GL_OBJECT_LINEAR:
    case GL_EYE_LINEAR: return true;
    case GL_SPHERE_MAP: return coordinate == GL_S || coordinate == GL_T;
    case GL_REFLECTION_MAP:
    case GL_NORMAL_MAP: return coordinate != GL_Q;
    default: return false;
  }
}

/// To eye coordinates by the inverse of the modelview matrix of now; where it has none, the plane
/// is undefined and stays finite.
glm::dvec4 plane_to_eye(Context& c, const Values& values) {
  const glm::dvec4 plane(values.v[0], values.v[1], values.v[2], values.v[3]);
  const glm::dvec4 eye = plane * glm::inverse(c.transform.modelview.top().exact);
  return std::isfinite(eye.x + eye.y + eye.z + eye.w) ? eye : glm::dvec4(0);
}

void tex_gen(Context& c, GLenum coordinate_name, GLenum name, Values values, bool vector) {
  if (refused_inside(c)) return;
  TexgenCoordinate* const coordinate = find_coordinate(c, coordinate_name);
  if (!coordinate) return raise_error(c, GL_INVALID_ENUM);
  TexgenCoordinate changed = *coordinate;
  const double mode = values.v[0];
  switch (name) {
    case GL_TEXTURE_GEN_MODE:
      changed.mode = mode >= 0 && mode < 65536 ? static_cast<GLenum>(mode) : GLenum{GL_NONE};
      if (!is_mode(coordinate_name, changed.mode)) return raise_error(c, GL_INVALID_ENUM);
      break;
    case GL_OBJECT_PLANE:
      if (!vector) return raise_error(c, GL_INVALID_ENUM);
      for (int i = 0; i < 4; ++i)
        changed.object_plane[i] = static_cast<float>(values.v[static_cast<unsigned>(i)]);
      break;
    case GL_EYE_PLANE:
      if (!vector) return raise_error(c, GL_INVALID_ENUM);
      changed.eye_plane = plane_to_eye(c, values);
      break;
    default: return raise_error(c, GL_INVALID_ENUM);
  }
  if (changed == *coordinate) return;
  if (coordinate->enabled) before_texture_change(c);
  *coordinate = changed;
}

template <typename T>
Values read(GLenum name, const T* values) {
  Values result;
  if (!values) return result;
  const unsigned count = name == GL_OBJECT_PLANE || name == GL_EYE_PLANE ? 4 : 1;
  for (unsigned i = 0; i < count; ++i) result.v[i] = static_cast<double>(values[i]);
  return result;
}

template <typename T>
Values one(T value) {
  return {{static_cast<double>(value)}};
}

template <typename T>
void get_tex_gen(Context& c, GLenum coordinate_name, GLenum name, T* results) {
  if (refused_inside(c)) return;
  const TexgenCoordinate* const coordinate = find_coordinate(c, coordinate_name);
  if (!coordinate) return raise_error(c, GL_INVALID_ENUM);
  QueryValues values;
  values.kind = ValueKind::kFloat;
  switch (name) {
    case GL_TEXTURE_GEN_MODE: values.put(coordinate->mode); break;
    case GL_OBJECT_PLANE: values.put(coordinate->object_plane); break;
    case GL_EYE_PLANE: values.put(glm::vec4(coordinate->eye_plane)); break;
    default: return raise_error(c, GL_INVALID_ENUM);
  }
  for (unsigned i = 0; results && i < values.count; ++i) {
    if constexpr (std::is_same_v<T, GLint>) results[i] = as_integer(values.kind, values.values[i]);
    else results[i] = static_cast<T>(values.values[i]);
  }
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexGeni(GLenum coord, GLenum pname, GLint param) {
  dispatch<tex_gen>(coord, pname, one(param), takes_scalars_for_vectors());
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexGenf(GLenum coord, GLenum pname, GLfloat param) {
  dispatch<tex_gen>(coord, pname, one(param), takes_scalars_for_vectors());
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexGend(GLenum coord, GLenum pname, GLdouble param) {
  dispatch<tex_gen>(coord, pname, one(param), takes_scalars_for_vectors());
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexGeniv(GLenum coord, GLenum pname, const GLint* params) {
  dispatch<tex_gen>(coord, pname, read(pname, params), true);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexGenfv(GLenum coord, GLenum pname,
                                                  const GLfloat* params) {
  dispatch<tex_gen>(coord, pname, read(pname, params), true);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglTexGendv(GLenum coord, GLenum pname,
                                                  const GLdouble* params) {
  dispatch<tex_gen>(coord, pname, read(pname, params), true);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetTexGeniv(GLenum coord, GLenum pname, GLint* params) {
  execute_now<get_tex_gen<GLint>>(coord, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetTexGenfv(GLenum coord, GLenum pname, GLfloat* params) {
  execute_now<get_tex_gen<GLfloat>>(coord, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetTexGendv(GLenum coord, GLenum pname, GLdouble* params) {
  execute_now<get_tex_gen<GLdouble>>(coord, pname, params);
}
