#include <array>

#include "oracle/sampler.hpp"

namespace oracle {
namespace {

constexpr GLenum max_lights = 8;

void apply_light(const GlFunctions& gl, GLenum name, const Light& light) {
  gl.LoadMatrixd(light.position_modelview.data());
  gl.Lightfv(name, GL_POSITION, light.position_specified.data());
  gl.LoadMatrixd(light.spot_direction_modelview.data());
  gl.Lightfv(name, GL_SPOT_DIRECTION, light.spot_direction_specified.data());
  gl.Lightfv(name, GL_AMBIENT, light.ambient.data());
  gl.Lightfv(name, GL_DIFFUSE, light.diffuse.data());
  gl.Lightfv(name, GL_SPECULAR, light.specular.data());
  gl.Lightf(name, GL_SPOT_EXPONENT, light.spot_exponent);
  gl.Lightf(name, GL_SPOT_CUTOFF, light.spot_cutoff_degrees);
  gl.Lightf(name, GL_CONSTANT_ATTENUATION, light.constant_attenuation);
  gl.Lightf(name, GL_LINEAR_ATTENUATION, light.linear_attenuation);
  gl.Lightf(name, GL_QUADRATIC_ATTENUATION, light.quadratic_attenuation);
}

void apply_material(const GlFunctions& gl, GLenum face, const Material& material) {
  gl.Materialfv(face, GL_AMBIENT, material.ambient.data());
  gl.Materialfv(face, GL_DIFFUSE, material.diffuse.data());
  gl.Materialfv(face, GL_SPECULAR, material.specular.data());
  gl.Materialfv(face, GL_EMISSION, material.emission.data());
  gl.Materialf(face, GL_SHININESS, material.shininess);
}

GLenum name_of(ColorMaterial::Face face) {
  switch (face) {
    case ColorMaterial::Face::front: return GL_FRONT;
    case ColorMaterial::Face::back: return GL_BACK;
    case ColorMaterial::Face::front_and_back: return GL_FRONT_AND_BACK;
  }
  return GL_NONE;
}

GLenum name_of(ColorMaterial::Mode mode) {
  switch (mode) {
    case ColorMaterial::Mode::ambient_and_diffuse: return GL_AMBIENT_AND_DIFFUSE;
    case ColorMaterial::Mode::ambient: return GL_AMBIENT;
    case ColorMaterial::Mode::diffuse: return GL_DIFFUSE;
    case ColorMaterial::Mode::specular: return GL_SPECULAR;
    case ColorMaterial::Mode::emission: return GL_EMISSION;
  }
  return GL_NONE;
}

void set_enabled(const GlFunctions& gl, GLenum capability, bool enabled) {
  if (enabled) {
    gl.Enable(capability);
  } else {
    gl.Disable(capability);
  }
}

}  // namespace

void apply_state(const GlFunctions& gl, const State& state, const Matrix4& projection) {
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadMatrixd(projection.data());
  gl.MatrixMode(GL_MODELVIEW);
  for (GLenum i = 0; i < max_lights; ++i) {
    const bool used = i < state.lights.size();
    if (used) apply_light(gl, GL_LIGHT0 + i, state.lights[i]);
    set_enabled(gl, GL_LIGHT0 + i, used);
  }
  gl.LoadMatrixd(state.modelview.data());
  // Off while the materials are set: glMaterial on a tracked property is ignored.
  gl.Disable(GL_COLOR_MATERIAL);
  apply_material(gl, GL_FRONT, state.front);
  apply_material(gl, GL_BACK, state.back);
  gl.ColorMaterial(name_of(state.color_material.face), name_of(state.color_material.mode));
  set_enabled(gl, GL_COLOR_MATERIAL, state.color_material.enabled);
  const LightModel& model = state.light_model;
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, model.ambient.data());
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, model.local_viewer);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, model.two_side);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                 model.separate_specular_color ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  set_enabled(gl, GL_NORMALIZE, state.normalize);
  set_enabled(gl, GL_RESCALE_NORMAL, state.rescale_normal);
  gl.Enable(GL_LIGHTING);
}

}  // namespace oracle
