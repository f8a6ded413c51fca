#include "execute/lighting_setters.hpp"
#include "record/pending.hpp"

#include <cmath>
#include <glm/matrix.hpp>

namespace legacy_gl {

namespace {

glm::vec4 color_of(const Floats4& v) { return {v[0], v[1], v[2], v[3]}; }

bool in_begin_end(Context& context) {
  if (!context.recorder.inside_begin_end()) return false;
  raise_error(context, GL_INVALID_OPERATION);
  return true;
}

Light* find_light(Context& context, GLenum light) {
  const GLenum index = light - GL_LIGHT0;
  return index < context.lighting.lights.size() ? &context.lighting.lights[index] : nullptr;
}

/// A light that is off changes nothing that is drawn; glEnable brings all of it up to date.
template <typename T, typename U>
void store(Context& context, const Light& light, T& stored, const U& value) {
  if (context.lighting.enabled && light.enabled)
    assign_lighting(context, stored, value, kDirtyLights);
  else stored = value;
}

}  // namespace

unsigned light_parameter_count(GLenum pname) {
  switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_SPECULAR:
    case GL_POSITION: return 4;
    case GL_SPOT_DIRECTION: return 3;
    case GL_SPOT_EXPONENT:
    case GL_SPOT_CUTOFF:
    case GL_CONSTANT_ATTENUATION:
    case GL_LINEAR_ATTENUATION:
    case GL_QUADRATIC_ATTENUATION: return 1;
    default: return 0;
  }
}

unsigned light_model_parameter_count(GLenum pname) {
  switch (pname) {
    case GL_LIGHT_MODEL_AMBIENT: return 4;
    case GL_LIGHT_MODEL_LOCAL_VIEWER:
    case GL_LIGHT_MODEL_TWO_SIDE:
    case GL_LIGHT_MODEL_COLOR_CONTROL: return 1;
    default: return 0;
  }
}

unsigned material_parameter_count(GLenum pname) {
  switch (pname) {
    case GL_AMBIENT:
    case GL_DIFFUSE:
    case GL_AMBIENT_AND_DIFFUSE:
    case GL_SPECULAR:
    case GL_EMISSION: return 4;
    case GL_COLOR_INDEXES: return 3;
    case GL_SHININESS: return 1;
    default: return 0;
  }
}

void set_light(Context& context, GLenum name, GLenum pname, Floats4 values) {
  if (in_begin_end(context)) return;
  Light* const light = find_light(context, name);
  if (!light) return raise_error(context, GL_INVALID_ENUM);
  const float value = values[0];
  switch (pname) {
    case GL_AMBIENT: store(context, *light, light->ambient, color_of(values)); break;
    case GL_DIFFUSE: store(context, *light, light->diffuse, color_of(values)); break;
    case GL_SPECULAR: store(context, *light, light->specular, color_of(values)); break;
    case GL_POSITION:
      store(context, *light, light->position_eye,
            context.transform.modelview.top().exact * glm::dvec4(color_of(values)));
      break;
    case GL_SPOT_DIRECTION:
      store(context, *light, light->spot_direction_eye,
            glm::dmat3(context.transform.modelview.top().exact) *
                glm::dvec3(values[0], values[1], values[2]));
      break;
    case GL_SPOT_EXPONENT:
      if (!(value >= 0 && value <= 128)) return raise_error(context, GL_INVALID_VALUE);
      store(context, *light, light->spot_exponent, value);
      break;
    case GL_SPOT_CUTOFF:
      if (!((value >= 0 && value <= 90) || value == 180))
        return raise_error(context, GL_INVALID_VALUE);
      store(context, *light, light->spot_cutoff_degrees, value);
      break;
    case GL_CONSTANT_ATTENUATION:
      if (!(value >= 0)) return raise_error(context, GL_INVALID_VALUE);
      store(context, *light, light->constant_attenuation, value);
      break;
    case GL_LINEAR_ATTENUATION:
      if (!(value >= 0)) return raise_error(context, GL_INVALID_VALUE);
      store(context, *light, light->linear_attenuation, value);
      break;
    case GL_QUADRATIC_ATTENUATION:
      if (!(value >= 0)) return raise_error(context, GL_INVALID_VALUE);
      store(context, *light, light->quadratic_attenuation, value);
      break;
    default: raise_error(context, GL_INVALID_ENUM);
  }
}

void set_light_model(Context& context, GLenum pname, Floats4 values) {
  if (in_begin_end(context)) return;
  LightModel& model = context.lighting.model;
  switch (pname) {
    case GL_LIGHT_MODEL_AMBIENT:
      assign_lighting(context, model.ambient, color_of(values), kDirtyMaterial);
      break;
    case GL_LIGHT_MODEL_LOCAL_VIEWER:
      assign_lighting(context, model.local_viewer, values[0] != 0, kDirtyKey | kDirtyTransform);
      break;
    case GL_LIGHT_MODEL_TWO_SIDE:
      assign_lighting(context, model.two_side, values[0] != 0, kDirtyKey | kDirtyMaterial);
      break;
    case GL_LIGHT_MODEL_COLOR_CONTROL: {
      const bool separate = values[0] == static_cast<float>(GL_SEPARATE_SPECULAR_COLOR);
      if (!separate && values[0] != static_cast<float>(GL_SINGLE_COLOR))
        return raise_error(context, GL_INVALID_ENUM);
      assign(context, model.color_control,
             separate ? GLenum{GL_SEPARATE_SPECULAR_COLOR} : GLenum{GL_SINGLE_COLOR}, kDirtyKey);
      break;
    }
    default: raise_error(context, GL_INVALID_ENUM);
  }
}

MaterialMask tracked_materials(const Context& context) {
  const ColorMaterial& tracking = context.lighting.color_material;
  return tracking.enabled ? material_mask(tracking.face, tracking.mode) : MaterialMask{0};
}

namespace {

/// Small objects that differ in their material join one batch, which carries it with the vertices.
bool carry_between_small_draws(Context& context, MaterialMask changes) {
  Recorder& recorder = context.recorder;
  const MaterialMask seen = context.lighting.model.two_side
                                ? MaterialMask{kFrontMaterialMask | kBackMaterialMask}
                                : kFrontMaterialMask;
  const auto missing =
      static_cast<MaterialMask>(changes & seen & ~unsigned{recorder.layout().materials});
  if (missing && (!recorder.small_draw_may_end() || is_unfilled(context.raster.polygon)))
    return false;
  recorder.end_small_draw();
  recorder.carry_materials(context, missing);
  return true;
}

}  // namespace

void set_material(Context& context, GLenum face, GLenum pname, Floats4 values) {
  if (face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK)
    return raise_error(context, GL_INVALID_ENUM);
  if (pname == GL_COLOR_INDEXES) {
    for (unsigned side = 0; side < 2; ++side)
      if (face == GL_FRONT_AND_BACK || (face == GL_BACK) == (side == kBack))
        context.lighting.materials[side].color_indexes = {values[0], values[1], values[2]};
    return;
  }
  MaterialMask mask = material_mask(face, pname);
  if (!mask) return raise_error(context, GL_INVALID_ENUM);
  if (pname == GL_SHININESS && !(values[0] >= 0 && values[0] <= 128))
    return raise_error(context, GL_INVALID_VALUE);
  mask &= static_cast<MaterialMask>(~tracked_materials(context));

  const glm::vec4 value = pname == GL_SHININESS ? glm::vec4(values[0], 0, 0, 0) : color_of(values);
  MaterialMask changes = 0;
  for (unsigned i = 0; i < 2 * kPropertyCount; ++i)
    if (mask & (1u << i) &&
        material_value(context.lighting.materials, i / kPropertyCount, i % kPropertyCount) != value)
      changes |= static_cast<MaterialMask>(1u << i);
  if (!changes) return;
  // Inside Begin/End the change is the vertices' from here on; outside, a batch that carries the
  // property anyway need not end.
  Recorder& recorder = context.recorder;
  if (recorder.is_shaded()) before_lighting_change(context);
  else if (recorder.inside_begin_end()) recorder.carry_materials(context, changes);
  else if (recorder.has_pending() && !shade_pending(context) &&
           !carry_between_small_draws(context, changes))
    flush_pending(context);
  for (unsigned i = 0; i < 2 * kPropertyCount; ++i)
    if (changes & (1u << i))
      store_material_value(context.lighting.materials, i / kPropertyCount, i % kPropertyCount,
                           value);
  mark_dirty(context, kDirtyMaterial);
}

void latch_color_material(Context& context) {
  const MaterialMask tracked = tracked_materials(context);
  for (unsigned i = 0; i < 2 * kPropertyCount; ++i)
    if (tracked & (1u << i) && store_material_value(context.lighting.materials, i / kPropertyCount,
                                                    i % kPropertyCount, context.current.color))
      context.dirty |= kDirtyMaterial;
}

void set_color_material(Context& context, GLenum face, GLenum mode) {
  if (in_begin_end(context)) return;
  if (face != GL_FRONT && face != GL_BACK && face != GL_FRONT_AND_BACK)
    return raise_error(context, GL_INVALID_ENUM);
  if (!material_mask(face, mode) || mode == GL_SHININESS)
    return raise_error(context, GL_INVALID_ENUM);
  ColorMaterial& tracking = context.lighting.color_material;
  if (tracking.face == face && tracking.mode == mode) return;
  flush_pending(context);
  latch_color_material(context);
  tracking.face = face;
  tracking.mode = mode;
  latch_color_material(context);
  mark_dirty(context, kDirtyKey | kDirtyMaterial);
}

void set_shade_model(Context& context, GLenum mode) {
  if (in_begin_end(context)) return;
  if (mode != GL_FLAT && mode != GL_SMOOTH && mode != GL_PHONG_WIN)
    return raise_error(context, GL_INVALID_ENUM);
  assign(context, context.lighting.shade_model, mode, kDirtyKey);
}

void enable_light(Context& context, unsigned index, bool enabled) {
  assign_lighting(context, context.lighting.lights[index].enabled, enabled, kDirtyLights);
}

void enable_lighting(Context& context, bool enabled) {
  assign(context, context.lighting.enabled, enabled,
         kDirtyKey | kDirtyLights | kDirtyMaterial | kDirtyTransform);
}

void enable_color_material(Context& context, bool enabled) {
  ColorMaterial& tracking = context.lighting.color_material;
  if (tracking.enabled == enabled) return;
  flush_pending(context);
  latch_color_material(context);
  tracking.enabled = enabled;
  latch_color_material(context);
  mark_dirty(context, kDirtyKey | kDirtyMaterial);
}

}  // namespace legacy_gl
