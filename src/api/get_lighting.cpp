// GL 2.1 spec 6.1.3: glGetLight, glGetMaterial.
#include <glm/vec3.hpp>

#include "dlist/dispatch.hpp"
#include "execute/lighting_setters.hpp"
#include "execute/queries.hpp"
#include "record/pending.hpp"

using namespace legacy_gl;

namespace {

bool read_light(const Light& light, GLenum pname, QueryValues& v) {
  v.kind = ValueKind::kFloat;
  switch (pname) {
    case GL_AMBIENT:
      v.kind = ValueKind::kNormalised;
      v.put(light.ambient);
      return true;
    case GL_DIFFUSE:
      v.kind = ValueKind::kNormalised;
      v.put(light.diffuse);
      return true;
    case GL_SPECULAR:
      v.kind = ValueKind::kNormalised;
      v.put(light.specular);
      return true;
    case GL_POSITION: v.put(glm::vec4(light.position_eye)); return true;
    case GL_SPOT_DIRECTION: v.put(glm::vec3(light.spot_direction_eye)); return true;
    case GL_SPOT_EXPONENT: v.put(light.spot_exponent); return true;
    case GL_SPOT_CUTOFF: v.put(light.spot_cutoff_degrees); return true;
    case GL_CONSTANT_ATTENUATION: v.put(light.constant_attenuation); return true;
    case GL_LINEAR_ATTENUATION: v.put(light.linear_attenuation); return true;
    case GL_QUADRATIC_ATTENUATION: v.put(light.quadratic_attenuation); return true;
    default: return false;
  }
}

bool read_material(const Material& material, GLenum pname, QueryValues& v) {
  v.kind = ValueKind::kNormalised;
  switch (pname) {
    case GL_AMBIENT: v.put(material.ambient); return true;
    case GL_DIFFUSE: v.put(material.diffuse); return true;
    case GL_SPECULAR: v.put(material.specular); return true;
    case GL_EMISSION: v.put(material.emission); return true;
    case GL_SHININESS:
      v.kind = ValueKind::kFloat;
      v.put(material.shininess);
      return true;
    case GL_COLOR_INDEXES:
      v.kind = ValueKind::kFloat;
      v.put(material.color_indexes);
      return true;
    default: return false;
  }
}

void store(const QueryValues& v, GLfloat* results) {
  for (unsigned i = 0; i < v.count; ++i) results[i] = static_cast<GLfloat>(v.values[i]);
}
void store(const QueryValues& v, GLint* results) {
  for (unsigned i = 0; i < v.count; ++i) results[i] = as_integer(v.kind, v.values[i]);
}

template <typename T>
void get_light(Context& c, GLenum name, GLenum pname, T* results) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  const GLenum index = name - GL_LIGHT0;
  QueryValues values;
  if (index >= c.lighting.lights.size() || !read_light(c.lighting.lights[index], pname, values))
    return raise_error(c, GL_INVALID_ENUM);
  store(values, results);
}

template <typename T>
void get_material(Context& c, GLenum face, GLenum pname, T* results) {
  if (c.recorder.inside_begin_end()) return raise_error(c, GL_INVALID_OPERATION);
  if (face != GL_FRONT && face != GL_BACK) return raise_error(c, GL_INVALID_ENUM);
  latch_color_material(c);
  QueryValues values;
  if (!read_material(c.lighting.materials[face == GL_FRONT ? kFront : kBack], pname, values))
    return raise_error(c, GL_INVALID_ENUM);
  store(values, results);
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetLightfv(GLenum light, GLenum pname, GLfloat* params) {
  execute_now<get_light<GLfloat>>(light, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetLightiv(GLenum light, GLenum pname, GLint* params) {
  execute_now<get_light<GLint>>(light, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetMaterialfv(GLenum face, GLenum pname, GLfloat* params) {
  execute_now<get_material<GLfloat>>(face, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglGetMaterialiv(GLenum face, GLenum pname, GLint* params) {
  execute_now<get_material<GLint>>(face, pname, params);
}
