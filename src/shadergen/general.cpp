// One lit program for every set of lights: every light is computed as a spot light would be, and
// selects leave out what it is not. The forms are the shortest that agree with the specialised
// programs within half a step of 8 bits: this program is there to be ready soon.
#include "shadergen/general.hpp"

#include <algorithm>

#include "shadergen/attributes.hpp"
#include "shadergen/emit.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

namespace {

enum Property : unsigned { kAmbient, kDiffuse, kSpecular, kEmission, kShininess };

constexpr const char* kSide[2] = {"front", "back"};

unsigned face_count(const ProgramKey& key) { return key.two_side ? 2 : 1; }

std::string times_material(const ProgramKey& key, unsigned face, unsigned property,
                           const char* term) {
  std::string text = std::string(kSide[face]) + "_products[i]." + term + ".rgb";
  if (const std::string material = material_expression(key, face, property); !material.empty())
    text += " * " + material + ".rgb";
  return text;
}

/// GL 2.1 spec 2.14.1, from directional to spot lights.
constexpr const char* kLightGeometry = R"(    vec3 to_light = lights[i].position.xyz;
    bool point = i >= light_ends.x;
    vec3 delta = to_light - vertex;
    vec3 to_point = unit_of_any(delta);
    float distance = dot(delta, to_point) * lights[i].half_vector.w;
    to_light = point ? to_point : to_light;
    vec3 k = lights[i].attenuation.xyz;
    float strength = point ? 1.0 / max(k.x + distance * (k.y + distance * k.z), 1e-37) : 1.0;
    vec3 chord = to_light + lights[i].spot_direction.xyz;
    float one_minus_cosine = 0.5 * dot(chord, chord);
    float cone = one_minus_cosine <= lights[i].spot_direction.w
                      ? power_of(1.0 - one_minus_cosine, one_minus_cosine, lights[i].attenuation.w)
                      : 0.0;
    strength = i >= light_ends.y ? strength * cone : strength;
    bool own = i >= computed_half_vectors;
    vec3 h = own ? unit_of_any(to_light + to_viewer) : lights[i].half_vector.xyz + lights[i].attenuation.xyz;
    float n_dot_l = dot(n, to_light);
    float n_dot_h = dot(n, h);
)";

void emit_face(Writer& w, const ProgramKey& key, unsigned face) {
  const std::string side = kSide[face];
  const std::string shininess = key.material[face][kShininess] == MaterialSource::kVertex
                                    ? std::string(kMaterialAttributeNames[face][kShininess])
                                    : side + "_ambient_light.w";
  const std::string facing = face ? "n_dot_l < 0.0" : "n_dot_l > 0.0";
  const std::string n_dot_h = face ? "-n_dot_h" : "n_dot_h";
  const std::string specular = "(" + facing + " ? power_of(" + n_dot_h +
                               (face ? ", 1.0 + n_dot_h, " : ", 1.0 - n_dot_h, ") + shininess +
                               ") : 0.0) * " + times_material(key, face, kSpecular, "specular");
  std::string sum = times_material(key, face, kAmbient, "ambient") + " + max(" +
                    (face ? "-n_dot_l" : "n_dot_l") + ", 0.0) * " +
                    times_material(key, face, kDiffuse, "diffuse");
  if (key.separate_specular) w.line(side + "_specular_sum += strength * (" + specular + ");");
  else sum += " + " + specular;
  w.line(side + "_sum += strength * (" + sum + ");");
}

}  // namespace

ProgramKey generalise(const ProgramKey& key) {
  if (!key.lit || key.per_fragment || key.quality != Quality::kDefault || key.scaled_sums ||
      key.general_lights)
    return key;
  ProgramKey general = key;
  general.general_lights = kGeneralLights;
  while (general.general_lights < key.light_count()) general.general_lights *= 2;
  general.position4 = general.w_is_one = general.parallel = false;
  general.local_viewer = general.angle_error = false;
  general.space = LightingSpace::kObject;
  general.normal = NormalMode::kAsIs;
  general.integer_shininess = {};
  general.lights = {};
  return general;
}

void emit_general_blocks(Writer& w, const ProgramKey& key) {
  const std::string size = "[" + std::to_string(key.general_lights) + "]";
  w.raw(kGeneralBlockText);
  w.blank();
  w.raw(kLightStructText);
  w.line("layout(std140) uniform Lights {");
  w.line("  Light lights" + size + ";");
  w.line("};");
  w.blank();
  w.raw(kProductsStructText);
  for (unsigned face = 0; face < face_count(key); ++face) {
    const std::string side = kSide[face];
    w.line(std::string("layout(std140) uniform ") + kUniformBlockNames[kFrontBlock + face] + " {");
    w.line("  vec4 " + side + "_scene;          // rgb: light from no direction, a: alpha");
    w.line("  vec4 " + side +
           "_ambient_light;  // rgb: for a per-vertex ambient material, w: shininess");
    w.line("  Products " + side + "_products" + size + ";");
    w.line("};");
  }
  w.blank();
}

void emit_general_functions(Writer& w) {
  emit_unit_of_any(w);
  emit_power_of(w);
}

void emit_general_space(Writer& w, const ProgramKey& key) {
  const std::string position = key.lighting_position ? "lighting_position" : "position";
  w.line("vec4 lit_position = lighting_matrix * " + position + ";");
  w.line("vec3 vertex = lit_position.xyz / lit_position.w;");
  w.line("vec3 n = lighting_normal_matrix * normal;");
  w.line("n = modes.x != 0.0 ? unit_of_any(n) : n;");
}

void emit_general_lights(Writer& w, const ProgramKey& key) {
  w.line("bool local_viewer = modes.y != 0.0;");
  w.line("vec3 to_viewer = local_viewer ? unit_of_any(viewer.xyz - vertex) : viewer.xyz;");
  w.line("int computed_half_vectors = local_viewer ? 0 : light_ends.x;");
  for (unsigned face = 0; face < face_count(key); ++face) {
    const std::string side = kSide[face];
    std::string sum = side + "_scene.rgb";
    if (const auto ambient = material_expression(key, face, kAmbient); !ambient.empty())
      sum += " + " + side + "_ambient_light.rgb * " + ambient + ".rgb";
    if (const auto emission = material_expression(key, face, kEmission); !emission.empty())
      sum += " + " + emission + ".rgb";
    w.line("vec3 " + side + "_sum = " + sum + ";");
    if (key.separate_specular) w.line("vec3 " + side + "_specular_sum = vec3(0.0);");
  }
  w.open("for (int i = 0; i < light_ends.z; ++i) {");
  w.raw(kLightGeometry);
  for (unsigned face = 0; face < face_count(key); ++face) emit_face(w, key, face);
  w.close();
  for (unsigned face = 0; face < face_count(key); ++face) {
    const std::string side = kSide[face];
    const std::string diffuse = material_expression(key, face, kDiffuse);
    const std::string alpha = diffuse.empty() ? side + "_scene.a" : diffuse + ".a";
    // GL 2.1 spec 2.14.6: colours are clamped before they are interpolated.
    w.line("vec4 " + side + "_lit = clamp(vec4(" + side + "_sum, " + alpha + "), 0.0, 1.0);");
    if (key.separate_specular)
      w.line("vec3 " + side + "_specular = clamp(" + side + "_specular_sum, 0.0, 1.0);");
  }
}

}  // namespace legacy_gl
