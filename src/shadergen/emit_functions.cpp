#include "shadergen/emit.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

namespace {

/// x to the power n by repeated squaring: exact to a few roundings, and cheaper than exp2 and log2.
void emit_integer_power(Writer& w, const std::string& name, unsigned exponent) {
  w.open("float " + name + "(float x) {");
  if (exponent == 0) {
    w.line("return 1.0;  // 0^0 is 1 (GL 2.1 spec 2.14.1)");
  } else {
    w.line("x = max(x, 0.0);");
    std::string product;
    std::string power = "x";
    for (unsigned bit = 1;; bit <<= 1) {
      if (exponent & bit) product = product.empty() ? power : product + " * " + power;
      if (bit > exponent / 2) break;
      const std::string squared = "x" + std::to_string(bit * 2);
      w.line("float " + squared + " = " + power + " * " + power + ";");
      power = squared;
    }
    w.line("return " + product + ";");
  }
  w.close();
  w.blank();
}

constexpr const char* kUnit = R"(vec3 unit(vec3 v) {
  return v * inversesqrt(max(dot(v, v), 1e-37));
}

)";

constexpr const char* kPower = R"(// x to the power s for x in [0, 1]; 0^0 is 1 (GL 2.1 spec 2.14.1)
float power(float x, float s) {
  return x > 0.0 ? exp2(s * log2(x)) : (s == 0.0 ? 1.0 : 0.0);
}

)";

bool any_light(const ProgramKey& key, std::uint8_t bits) {
  for (const LightRun& run : key.lights)
    if (run.count && (run.kind & bits)) return true;
  return false;
}

}  // namespace

void emit_lighting_functions(Writer& w, const ProgramKey& key) {
  const bool specular = any_light(key, kLightSpecular);
  const bool general_shininess =
      specular && (key.integer_shininess[0] == kGeneralShininess ||
                   (key.two_side && key.integer_shininess[1] == kGeneralShininess));
  if (key.normal == NormalMode::kNormalize || specular || any_light(key, kLightPoint)) w.raw(kUnit);
  if (general_shininess || any_light(key, kLightSpotExponent)) w.raw(kPower);
  if (!specular) return;
  if (key.integer_shininess[0] != kGeneralShininess)
    emit_integer_power(w, "front_shine", key.integer_shininess[0]);
  if (key.two_side && key.integer_shininess[1] != kGeneralShininess)
    emit_integer_power(w, "back_shine", key.integer_shininess[1]);
}

void emit_lighting_blocks(Writer& w, const ProgramKey& key) {
  const unsigned count = key.light_count();
  const std::string size = "[" + std::to_string(count) + "]";
  if (count) {
    w.raw(kLightStructText);
    w.line("layout(std140) uniform Lights {");
    w.line("  Light lights" + size + ";");
    w.line("};");
    w.blank();
    w.raw(kProductsStructText);
  }
  for (unsigned face = 0; face < (key.two_side ? 2u : 1u); ++face) {
    const std::string side = face ? "back" : "front";
    w.line(std::string("layout(std140) uniform ") + kUniformBlockNames[kFrontBlock + face] + " {");
    w.line("  vec4 " + side + "_scene;          // rgb: light from no direction, a: alpha");
    w.line("  vec4 " + side + "_ambient_light;  // rgb: for a per-vertex ambient material, w: shininess");
    if (count) w.line("  Products " + side + "_products" + size + ";");
    w.line("};");
  }
  w.blank();
}

}  // namespace legacy_gl
