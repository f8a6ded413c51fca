#pragma once
// glLight, glLightModel, glMaterial, glColorMaterial and their like: validate, store, mark (GL 2.1
// spec 2.14).
#include <array>
#include <span>

#include "context/context.hpp"

namespace legacy_gl {

using Floats4 = std::array<float, 4>;

/// How many values a pname takes; 0 for one that the call does not take.
unsigned light_parameter_count(GLenum pname);
unsigned light_model_parameter_count(GLenum pname);
unsigned material_parameter_count(GLenum pname);

void set_light(Context& context, GLenum light, GLenum pname, Floats4 values);
void set_light_model(Context& context, GLenum pname, Floats4 values);
void set_material(Context& context, GLenum face, GLenum pname, Floats4 values);
void set_color_material(Context& context, GLenum face, GLenum mode);
void set_shade_model(Context& context, GLenum mode);

void enable_light(Context& context, unsigned index, bool enabled);
void enable_lighting(Context& context, bool enabled);
void enable_color_material(Context& context, bool enabled);

/// The tracked properties take the current colour: what glGetMaterial shows, and what stays when
/// tracking ends.
void latch_color_material(Context& context);

/// The faces' properties that follow the current colour now.
MaterialMask tracked_materials(const Context& context);

}  // namespace legacy_gl
