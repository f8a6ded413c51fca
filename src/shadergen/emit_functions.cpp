#include <algorithm>

#include "shadergen/emit.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

namespace {

// Powers end at about 1e30: where a normal is longer than 1 they grow, and infinity times a colour
// of 0 would be no number.

/// (1 - q) to the power n by repeated squaring of the complement y = 1 - (1 - q)^k: squaring is y(2
/// - y), one factor more is y + q(1 - y). No step forms a number near 1, so nothing is rounded away
/// and amplified n times. The last squarings amplify little: there 1 - y itself is squared, at half
/// the cost.
/// `amplify`: how far they may.
void emit_integer_shine(Writer& w, const std::string& name, unsigned exponent, unsigned amplify) {
  w.line("// (1 - q)^" + std::to_string(exponent));
  w.open("float " + name + "(float q) {");
  if (exponent == 0) {
    w.line("return 1.0;  // 0^0 is 1 (GL 2.1 spec 2.14.1)");
  } else {
    unsigned last = 1;  // what the squarings of 1 - y raise it to
    while (last < amplify && last * 8 <= exponent) last *= 2;
    w.line("float y = q;");
    unsigned bit = 1;
    while (bit <= exponent / 2) bit <<= 1;
    for (bit >>= 1; bit >= last; bit >>= 1) {
      w.line("y = y * (2.0 - y);");
      if (exponent & bit) w.line("y = y + q * (1.0 - y);");
    }
    if (last == 1) {
      w.line("return clamp(1.0 - y, 0.0, 1e30);");
    } else {
      w.line("float x = 1.0 - y;");
      for (; bit; bit >>= 1) {
        w.line("x *= x;");
        if (exponent & bit) w.line("x *= 1.0 - q;");
      }
      w.line("return min(x, 1e30);");
    }
  }
  w.close();
  w.blank();
}

/// The fastest quality: x to the power n by repeated squaring.
void emit_fast_integer_shine(Writer& w, const std::string& name, unsigned exponent, unsigned) {
  w.line("// x^" + std::to_string(exponent));
  w.open("float " + name + "(float x) {");
  if (exponent == 0) {
    w.line("return 1.0;  // 0^0 is 1 (GL 2.1 spec 2.14.1)");
  } else {
    w.line("x = max(x, 0.0);");
    w.line("float y = x;");
    unsigned bit = 1;
    while (bit <= exponent / 2) bit <<= 1;
    for (bit >>= 1; bit; bit >>= 1) {
      w.line("y *= y;");
      if (exponent & bit) w.line("y *= x;");
    }
    w.line("return min(y, 1e30);");
  }
  w.close();
  w.blank();
}

constexpr const char* kUnit = R"(vec3 unit(vec3 v) {
  return v * inversesqrt(max(dot(v, v), 1e-37));
}

)";

constexpr const char* kHalfVectorOfUnits =
    R"(// |a|^2 - |b|^2 is what rounding left of their lengths: where they are nearly opposite, it would turn
// the sum.
vec3 half_vector_of_units(vec3 a, vec3 b) {
  vec3 sum = a + b;
  return unit(sum + 0.5 * dot(sum, a - b) * b);
}

)";

constexpr const char* kUnitOfAny =
    R"(// Of a vector whose square may leave the range: an exact power of two brings its largest component
// to between 2 and 4 first.
vec3 unit_of_any(vec3 v) {
  vec3 a = abs(v);
  int exponent = floatBitsToInt(max(max(a.x, a.y), a.z)) & 0x7f800000;
  v *= intBitsToFloat(min(0x7f800000 - exponent, 0x7e800000));
  return v * inversesqrt(max(dot(v, v), 1e-37));
}

)";

constexpr const char* kFastUnitOfAny = R"(vec3 unit_of_any(vec3 v) {
  return v * inversesqrt(max(dot(v, v), 1e-37));
}

)";

constexpr const char* kPower = R"(// x^s; 0^0 is 1
float power(float x, float s) {
  return x > 0.0 ? exp2(min(s * log2(x), 100.0)) : (s == 0.0 ? 1.0 : 0.0);
}

)";

constexpr const char* kLog2Of =
    R"(// log2(x), where q is 1 - x. Near 1 the series takes its argument from q, which x has rounded.
float log2_of(float x, float q) {
  x = max(x, 1e-37);
  int bits = floatBitsToInt(x);
  int exponent = (bits - 0x3f3504f3) >> 23;
  float d = exponent == 0 ? -q : intBitsToFloat(bits - (exponent << 23)) - 1.0;
  float f = d / (2.0 + d);
  float g = f * f;
  float log2_mantissa =
      f * (2.88539008 + g * (0.961796694 + g * (0.577078016 + g * (0.412198583 + g * 0.320598898))));
  return float(exponent) + log2_mantissa;
}

)";

constexpr const char* kPowerOf = R"(// x^s, where q is 1 - x; 0^0 is 1
float power_of(float x, float q, float s) {
  float power = exp2(min(s * log2_of(x, q), 100.0));
  return x > 0.0 ? power : (s == 0.0 ? 1.0 : 0.0);
}

)";

constexpr const char* kPrecisePowerOf =
    R"(// x^s, where q is 1 - x; 0^0 is 1. Drivers' exp2 may have no more than 20 bits, this series has all.
float power_of(float x, float q, float s) {
  float t = clamp(s * log2_of(x, q), -126.0, 100.0);
  float whole = floor(t + 0.5);
  float f = t - whole;
  float power = 1.0 + f * (0.693147181 + f * (0.240226507 + f * (0.0555041087 + f * (0.00961812911 +
                f * (0.00133335581 + f * (0.000154035304 + f * 0.0000152527338))))));
  power *= intBitsToFloat((int(whole) + 127) << 23);
  return x > 0.0 ? power : (s == 0.0 ? 1.0 : 0.0);
}

)";

constexpr const char* kPowerOfComplement = R"(// (1 - q)^s
float power_of_complement(float q, float s) {
  return power_of(1.0 - q, q, s);
}

)";

constexpr const char* kComplementOfUnits =
    R"(// 1 - dot(n, h) of unit vectors, exact where the two nearly meet: e is n - h
float complement_of_units(vec3 e) {
  return min(0.5 * dot(e, e), 1.0);
}

)";

constexpr const char* kComplement =
    R"(// 1 - dot(n, h) for a unit vector h, exact where the two nearly meet: e is n - h, half_excess
// (|n|^2 - 1) / 2
float complement(vec3 e, vec3 n, vec3 h, float half_excess) {
  return min(half_excess < 0.5 ? 0.5 * dot(e, e) - half_excess : 1.0 - dot(n, h), 1.0);
}

)";

bool any_light(const ProgramKey& key, std::uint8_t bits) {
  for (const LightRun& run : key.lights)
    if (run.count && (run.kind & bits)) return true;
  return false;
}

}  // namespace

void emit_unit_of_any(Writer& w) { w.raw(kUnitOfAny); }

void emit_power_of(Writer& w) {
  w.raw(kLog2Of);
  w.raw(kPowerOf);
}

void emit_lighting_functions(Writer& w, const ProgramKey& key) {
  const bool specular = any_light(key, kLightSpecular);
  const bool general_shininess =
      specular && (key.integer_shininess[0] == kGeneralShininess ||
                   (key.two_side && key.integer_shininess[1] == kGeneralShininess));
  const bool half_vectors = computes_half_vectors(key);
  const bool precise = key.quality == Quality::kPrecise;
  const bool fastest = key.quality == Quality::kFastest;
  const bool any_length =
      key.normal == NormalMode::kNormalize || key.per_fragment || lighting_reads_position(key);
  if (precise) emit_precise_functions(w, key);
  else if (any_length) w.raw(fastest ? kFastUnitOfAny : kUnitOfAny);
  if (half_vectors) w.raw(kUnit);
  if (half_vectors && precise) emit_precise_half_vector_function(w, key);
  else if (half_vectors &&
           std::any_of(key.lights.begin(), key.lights.end(), [&](const LightRun& run) {
             return run.count && run.kind & kLightSpecular && corrects_half_vector(key, run.kind);
           }))
    w.raw(kHalfVectorOfUnits);
  const bool spot_powers = any_light(key, kLightSpotExponent);
  if (!fastest && (general_shininess || spot_powers)) w.raw(kLog2Of);
  if (precise && (general_shininess || spot_powers)) w.raw(kPrecisePowerOf);
  else if (general_shininess) w.raw(fastest ? kPower : kPowerOf);
  const bool complements = half_vectors || key.normal == NormalMode::kNormalize;
  if (!fastest && general_shininess && complements) w.raw(kPowerOfComplement);
  if (!specular) return;
  if (!fastest) {
    if (key.normal == NormalMode::kNormalize) w.raw(kComplementOfUnits);
    else if (half_vectors) w.raw(kComplement);
  }
  const auto emit_shine = fastest ? emit_fast_integer_shine : emit_integer_shine;
  const unsigned amplify = precise || key.normal == NormalMode::kNormalize ? 1 : 8;
  if (key.integer_shininess[0] != kGeneralShininess)
    emit_shine(w, "front_shine", key.integer_shininess[0], amplify);
  if (key.two_side && key.integer_shininess[1] != kGeneralShininess)
    emit_shine(w, "back_shine", key.integer_shininess[1], amplify);
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
  if (key.quality == Quality::kPrecise) {
    w.raw(kLightLowStructText);
    w.line("layout(std140) uniform Precise {");
    w.raw(kPreciseBlockHeadText);
    w.line("  LightLow lights_low" + size + ";");
    w.line("};");
    w.blank();
  }
  for (unsigned face = 0; face < (key.two_side ? 2u : 1u); ++face) {
    const std::string side = face ? "back" : "front";
    w.line(std::string("layout(std140) uniform ") + kUniformBlockNames[kFrontBlock + face] + " {");
    w.line("  vec4 " + side + "_scene;          // rgb: light from no direction, a: alpha");
    w.line("  vec4 " + side +
           "_ambient_light;  // rgb: for a per-vertex ambient material, w: shininess");
    if (count) w.line("  Products " + side + "_products" + size + ";");
    w.line("};");
  }
  w.blank();
}

}  // namespace legacy_gl
