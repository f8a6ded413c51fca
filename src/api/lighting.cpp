// GL 2.1 spec 2.14: lights, light model, materials, colour material, shade model.
#include "execute/lighting_setters.hpp"

#include <algorithm>

#include "api/scalar_parameters.hpp"
#include "dlist/dispatch.hpp"
#include "execute/set_material_color.hpp"

using namespace legacy_gl;

namespace {

/// Integer colours map to [-1, 1] (GL 2.1 spec table 2.9); every other integer is its own value.
float from_integer(GLint value, bool is_color) {
  if (!is_color) return static_cast<float>(value);
  return static_cast<float>((2.0 * value + 1.0) / 4294967295.0);
}

bool is_light_color(GLenum pname) {
  return pname == GL_AMBIENT || pname == GL_DIFFUSE || pname == GL_SPECULAR;
}
bool is_material_color(GLenum pname) {
  return is_light_color(pname) || pname == GL_EMISSION || pname == GL_AMBIENT_AND_DIFFUSE;
}

Floats4 read(const GLfloat* values, unsigned count) {
  Floats4 result{};
  std::copy_n(values, count, result.begin());
  return result;
}

Floats4 read(const GLint* values, unsigned count, bool is_color) {
  Floats4 result{};
  for (unsigned i = 0; i < count; ++i) result[i] = from_integer(values[i], is_color);
  return result;
}

[[gnu::noinline]] void material_in_general(GLenum face, GLenum pname, const GLfloat* params) {
  dispatch<set_material>(face, pname, read(params, material_parameter_count(pname)));
}

}  // namespace

LEGACY_GL_API void LEGACY_GL_APIENTRY lglLightf(GLenum light, GLenum pname, GLfloat param) {
  dispatch<set_light>(light, scalar_only(pname, light_parameter_count(pname)), Floats4{param});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLightfv(GLenum light, GLenum pname,
                                                 const GLfloat* params) {
  dispatch<set_light>(light, pname, read(params, light_parameter_count(pname)));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLighti(GLenum light, GLenum pname, GLint param) {
  lglLightf(light, pname, static_cast<GLfloat>(param));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLightiv(GLenum light, GLenum pname, const GLint* params) {
  dispatch<set_light>(light, pname,
                      read(params, light_parameter_count(pname), is_light_color(pname)));
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lglLightModelf(GLenum pname, GLfloat param) {
  dispatch<set_light_model>(scalar_only(pname, light_model_parameter_count(pname)), Floats4{param});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLightModelfv(GLenum pname, const GLfloat* params) {
  dispatch<set_light_model>(pname, read(params, light_model_parameter_count(pname)));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLightModeli(GLenum pname, GLint param) {
  lglLightModelf(pname, static_cast<GLfloat>(param));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglLightModeliv(GLenum pname, const GLint* params) {
  dispatch<set_light_model>(
      pname, read(params, light_model_parameter_count(pname), pname == GL_LIGHT_MODEL_AMBIENT));
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lglMaterialf(GLenum face, GLenum pname, GLfloat param) {
  dispatch<set_material>(face, scalar_only(pname, material_parameter_count(pname)), Floats4{param});
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMaterialfv(GLenum face, GLenum pname,
                                                    const GLfloat* params) {
  Context* const context = direct_context;
  if (context && set_material_color(*context, face, pname, params)) [[likely]]
    return;
  material_in_general(face, pname, params);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMateriali(GLenum face, GLenum pname, GLint param) {
  lglMaterialf(face, pname, static_cast<GLfloat>(param));
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglMaterialiv(GLenum face, GLenum pname,
                                                    const GLint* params) {
  dispatch<set_material>(face, pname,
                         read(params, material_parameter_count(pname), is_material_color(pname)));
}

LEGACY_GL_API void LEGACY_GL_APIENTRY lglColorMaterial(GLenum face, GLenum mode) {
  dispatch<set_color_material>(face, mode);
}
LEGACY_GL_API void LEGACY_GL_APIENTRY lglShadeModel(GLenum mode) {
  dispatch<set_shade_model>(mode);
}
