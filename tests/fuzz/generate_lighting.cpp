// Lights, materials, the light model, colour material, fog.
#include "fuzz/generators.hpp"

namespace legacy_gl::fuzz {

namespace {

void place_light(Builder& b, const char* light) {
  auto& random = b.random;
  const bool point = random.chance(50);
  // M8: no light at a vertex. M2: no narrow cone.
  const double distance = point ? 3 : 1;
  b.call("Lightfv", light, "GL_POSITION",
         floats({distance * random.real(-0.8, 0.8), distance * random.real(-0.8, 0.8), distance,
                 point ? 1.0 : 0.0}));
  if (b.traits.spots && point) {
    b.call("Lightfv", light, "GL_SPOT_DIRECTION",
           floats({random.real(-0.2, 0.2), random.real(-0.2, 0.2), -1}));
    b.call("Lightf", light, "GL_SPOT_EXPONENT", random.between(0, 20));
    b.call("Lightf", light, "GL_SPOT_CUTOFF", random.chance(30) ? 180 : random.between(20, 80));
  }
  if (b.traits.spots) {
    b.call("Lightf", light, "GL_CONSTANT_ATTENUATION", random.real(0.5, 1.5));
    b.call("Lightf", light, "GL_LINEAR_ATTENUATION", random.chance(50) ? 0 : random.real(0, 0.4));
    b.call("Lightf", light, "GL_QUADRATIC_ATTENUATION",
           random.chance(50) ? 0 : random.real(0, 0.2));
  }
}

void change_light_model(Builder& b) {
  switch (b.random.below(4)) {
    case 0:
      return b.call("LightModelfv", "GL_LIGHT_MODEL_AMBIENT", floats(b.random.reals(4, 0, 0.5)));
    case 1: return b.call("LightModeli", "GL_LIGHT_MODEL_LOCAL_VIEWER", b.random.below(2));
    case 2:
      return b.call("LightModeli", "GL_LIGHT_MODEL_TWO_SIDE",
                    b.traits.two_sided && b.random.chance(70) ? 1 : 0);
    default:
      // Mesa does not clamp the sum before fog.
      if (!b.traits.fog && !b.traits.pixels)
        b.call("LightModeli", "GL_LIGHT_MODEL_COLOR_CONTROL",
               b.random.pick({"GL_SINGLE_COLOR", "GL_SEPARATE_SPECULAR_COLOR"}));
  }
}

// M5, M6: tracking begins with a colour that follows, and of both faces.
void change_color_material(Builder& b) {
  if (b.in_list || b.in_stack) return;
  b.call("ColorMaterial", "GL_FRONT_AND_BACK",
         b.random.pick({"GL_AMBIENT", "GL_DIFFUSE", "GL_SPECULAR", "GL_AMBIENT_AND_DIFFUSE"}));
  b.call("Enable", "GL_COLOR_MATERIAL");
  const auto color = b.color();
  b.call("Color4f", color[0], color[1], color[2], color[3]);
}

}  // namespace

void change_lighting(Builder& b) {
  auto& random = b.random;
  const char* light = random.pick({"GL_LIGHT0", "GL_LIGHT1", "GL_LIGHT2", "GL_LIGHT7"});
  switch (random.below(8)) {
    case 0:
    case 1:
      // M16: glPopAttrib does not take lights' enables back.
      if (!b.in_stack) b.enable(light, random.chance(75));
      return;
    case 2:
    case 3: return place_light(b, light);
    case 4:
      return b.call("Lightfv", light, random.pick({"GL_AMBIENT", "GL_DIFFUSE", "GL_SPECULAR"}),
                    floats(b.color()));
    case 5: return change_light_model(b);
    case 6: return b.enable(random.pick({"GL_NORMALIZE", "GL_RESCALE_NORMAL"}), random.chance(60));
    default:
      if (b.traits.color_material) return change_color_material(b);
      return b.enable("GL_LIGHTING", random.chance(80));
  }
}

void change_material(Builder& b) {
  auto& random = b.random;
  // M9: materials do not come back with lights.
  if (b.in_stack || b.traits.color_material) return;
  const char* face = random.pick({"GL_FRONT", "GL_BACK", "GL_FRONT_AND_BACK", "GL_FRONT_AND_BACK"});
  if (random.chance(25)) return b.call("Materialf", face, "GL_SHININESS", random.between(1, 128));
  b.call("Materialfv", face,
         random.pick(
             {"GL_AMBIENT", "GL_DIFFUSE", "GL_SPECULAR", "GL_EMISSION", "GL_AMBIENT_AND_DIFFUSE"}),
         floats(b.color()));
}

void change_fog(Builder& b) {
  auto& random = b.random;
  switch (random.below(6)) {
    case 0:
    case 1: return b.enable("GL_FOG", random.chance(80));
    case 2: return b.call("Fogi", "GL_FOG_MODE", random.pick({"GL_LINEAR", "GL_EXP", "GL_EXP2"}));
    case 3: return b.call("Fogfv", "GL_FOG_COLOR", floats(b.color()));
    case 4:
      if (b.traits.fog_coordinates)
        return b.call("Fogi", "GL_FOG_COORDINATE_SOURCE",
                      random.pick({"GL_FOG_COORDINATE", "GL_FRAGMENT_DEPTH"}));
      return b.call("Fogf", "GL_FOG_START", random.real(0, 2));
    default:
      return b.call("Fogf", random.pick({"GL_FOG_DENSITY", "GL_FOG_END"}), random.real(0.2, 2.5));
  }
}

}  // namespace legacy_gl::fuzz
