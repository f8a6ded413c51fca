// The precise quality: vectors are pairs of floats wherever float32 rounds away what lighting
// amplifies.
#include "shadergen/emit.hpp"

namespace legacy_gl {

namespace {

// What the driver must not simplify: the outputs that come from it are declared invariant.
constexpr const char* kTwo =
    R"(// A vector that is the sum of a float vector and what its rounding lost.
struct Two {
  vec3 hi;
  vec3 lo;
};

Two joined(vec3 hi, vec3 lo) {
  vec3 s = hi + lo;
  return Two(s, lo - (s - hi));
}

Two add(Two a, Two b) {
  vec3 s = a.hi + b.hi;
  vec3 c = s - a.hi;
  return joined(s, ((a.hi - (s - c)) + (b.hi - c)) + (a.lo + b.lo));
}

// The first 12 bits: products of two such are exact.
vec3 upper(vec3 a) {
  return uintBitsToFloat(floatBitsToUint(a) & 0xfffff000u);
}

Two two_product(vec3 a, vec3 b) {
  vec3 p = a * b;
  vec3 a_upper = upper(a);
  vec3 b_upper = upper(b);
  vec3 a_rest = a - a_upper;
  vec3 b_rest = b - b_upper;
  return Two(p, ((a_upper * b_upper - p) + a_upper * b_rest + a_rest * b_upper) + a_rest * b_rest);
}

Two scaled(Two v, float s) {
  Two product = two_product(v.hi, vec3(s));
  return Two(product.hi, product.lo + v.lo * s);
}

)";

constexpr const char* kNearlyUnit =
    R"(// An exact power of two that brings the largest of the components near 1.
float power_of_two_for(vec3 v) {
  vec3 a = abs(v);
  uint exponent = floatBitsToUint(max(max(a.x, a.y), a.z)) & 0x7f800000u;
  return uintBitsToFloat(clamp(0x7f000000u - exponent, 0x00800000u, 0x7e800000u));
}

// A direction of many digits, of unit length to float32's.
Two nearly_unit(Two v) {
  float power = power_of_two_for(v.hi);
  v = Two(v.hi * power, v.lo * power);
  return scaled(v, inversesqrt(max(dot(v.hi, v.hi), 1e-37)));
}

)";

constexpr const char* kTwoUnit = R"(Two two_unit(Two v) {
  Two w = nearly_unit(v);
  vec3 w_coarse = floor(clamp(w.hi, -2.0, 2.0) * 2048.0) * (1.0 / 2048.0);
  vec3 w_rest = (w.hi - w_coarse) + w.lo;
  float half_excess = 0.5 * ((dot(w_coarse, w_coarse) - 1.0) + dot(w_rest, w_coarse + w.hi));
  return Two(w.hi, w.lo - half_excess * w.hi);
}

)";

/// `difference`: a - b, in eye coordinates' measure of length.
std::string half_vector_text(bool angle_error) {
  return std::string(
             "// Of nearly unit vectors. What their lengths differ by would turn the sum where "
             "they "
             "are nearly\n// opposite.\n"
             "vec3 half_vector(Two a, Two b) {\n"
             "  Two sum = add(a, b);\n"
             "  vec3 difference = a.hi - b.hi;\n") +
         (angle_error ? "  vec3 half_lack = angle_error_half.xyz * difference;\n"
                        "  vec3 mixed_lack = angle_error_mixed.zxy * difference.yzx +\n"
                        "                    angle_error_mixed.yzx * difference.zxy;\n"
                        "  difference -= (half_lack + half_lack) + mixed_lack;\n"
                      : "") +
         "  return unit(sum.hi + (sum.lo + 0.5 * dot(sum.hi, difference) * b.hi));\n"
         "}\n\n";
}

constexpr const char* kLinear = R"(Two linear(mat3 m, mat3 m_low, vec3 v) {
  Two x = two_product(m[0], v.xxx);
  Two y = two_product(m[1], v.yyy);
  Two z = two_product(m[2], v.zzz);
  x.lo += m_low * v;
  return add(add(x, y), z);
}

)";

// A scalar here is a Two of three equal components.
constexpr const char* kHomogeneous = R"(Two component(Two v, int i) {
  return Two(vec3(v.hi[i]), vec3(v.lo[i]));
}

// The quotient of V and w; of a vertex at infinity the direction.
Two homogeneous(mat4 m, mat4 m_low, vec4 v) {
  Two moved = two_product(m[3].xyz, v.www);
  moved.lo += m_low[3].xyz * v.w;
  Two point = add(linear(mat3(m), mat3(m_low), v.xyz), moved);
  vec4 row = vec4(m[0].w, m[1].w, m[2].w, m[3].w);
  Two products = two_product(row.xyz, v.xyz);
  Two w = add(add(component(products, 0), component(products, 1)), component(products, 2));
  Two last = two_product(row.www, v.www);
  last.lo += m_low[0].w * v.x + m_low[1].w * v.y + m_low[2].w * v.z + m_low[3].w * v.w;
  w = add(w, last);
  if (w.hi.x == 0.0) return point;
  vec3 quotient = point.hi / w.hi;
  Two back = two_product(quotient, w.hi);
  vec3 rest = ((point.hi - back.hi) - back.lo) + (point.lo - quotient * w.lo);
  return joined(quotient, rest / w.hi);
}

)";

bool transforms(const ProgramKey& key) {
  return key.space != LightingSpace::kObject || key.normal == NormalMode::kMatrix;
}

}  // namespace

void emit_precise_functions(Writer& w, const ProgramKey& key) {
  const bool normalize = key.normal == NormalMode::kNormalize;
  if (!lighting_reads_position(key) && key.normal == NormalMode::kAsIs) return;
  w.raw(kTwo);
  if (lighting_reads_position(key) || normalize) w.raw(kNearlyUnit);
  if (normalize) w.raw(kTwoUnit);
  if (transforms(key)) w.raw(kLinear);
  if (key.space == LightingSpace::kEyeHomogeneous) w.raw(kHomogeneous);
}

void emit_precise_half_vector_function(Writer& w, const ProgramKey& key) {
  w.raw(half_vector_text(key.angle_error));
}

void emit_precise_space(Writer& w, const ProgramKey& key) {
  const std::string position = key.lighting_position ? "lighting_position" : "position";
  if (lighting_reads_position(key)) switch (key.space) {
      case LightingSpace::kObject:
        w.line("Two vertex = Two(" + position + ".xyz, vec3(0.0));");
        break;
      case LightingSpace::kEyeAxes:
        w.line("Two vertex = linear(mat3(modelview), mat3(modelview_low), " + position + ".xyz);");
        break;
      case LightingSpace::kEyeHomogeneous:
        w.line("Two vertex = homogeneous(modelview, modelview_low, " + position + ");");
        w.line(
            "float finite = dot(vec4(modelview[0].w, modelview[1].w, modelview[2].w, "
            "modelview[3].w), " +
            position + ") == 0.0 ? 0.0 : 1.0;");
        break;
    }
  switch (key.normal) {
    case NormalMode::kAsIs: w.line("vec3 n = normal;"); return;
    case NormalMode::kScaled:
      w.line("Two two_n = scaled(Two(normal, vec3(0.0)), viewer.w);");
      w.line("two_n.lo += viewer_low.w * normal;");
      break;
    case NormalMode::kMatrix:
      w.line("Two two_n = linear(normal_matrix, normal_matrix_low, normal);");
      break;
    case NormalMode::kNormalize:
      if (key.space == LightingSpace::kObject)
        w.line("Two two_n = two_unit(Two(normal, vec3(0.0)));");
      else
        w.line(
            "Two two_n = two_unit(linear(normal_matrix, normal_matrix_low, normal * "
            "power_of_two_for(normal)));");
      break;
  }
  w.line("vec3 n = two_n.hi;");
  w.line("vec3 n_low = two_n.lo;");
}

void emit_precise_viewer(Writer& w, const ProgramKey& key) {
  if (!key.local_viewer) return;
  const std::string finite = key.space == LightingSpace::kEyeHomogeneous ? " * finite" : "";
  w.line("Two to_viewer = nearly_unit(add(Two(viewer.xyz" + finite + ", viewer_low.xyz" + finite +
         "), Two(-vertex.hi, -vertex.lo)));");
}

void emit_precise_to_light(Writer& w, const ProgramKey& key, std::uint8_t kind,
                           const std::string& index) {
  const std::string light = "lights[" + index + "]";
  const std::string rest = "lights_low[" + index + "]";
  if (!(kind & kLightPoint)) {
    if (key.local_viewer && kind & kLightSpecular)
      w.line("Two to_light = joined(" + light + ".position.xyz, " + rest + ".position.xyz);");
    if (kind & (kLightDiffuse | kLightSpecular))
      w.line("float n_dot_l = dot(n_coarse, " + light + ".position.xyz) + (dot(n_rest, " + light +
             ".position.xyz) + dot(n, " + rest + ".position.xyz));");
    return;
  }
  const std::string finite = key.space == LightingSpace::kEyeHomogeneous ? " * finite" : "";
  w.line("Two delta = add(Two(" + light + ".position.xyz" + finite + ", " + rest + ".position.xyz" +
         finite + "), Two(-vertex.hi, -vertex.lo));");
  w.line("Two to_light = nearly_unit(delta);");
  if (kind & kLightAttenuated) emit_distance(w, key, light, "dot(delta.hi, to_light.hi)");
  if (kind & kLightSpot)
    w.line("vec3 chord = (to_light.hi + " + light + ".spot_direction.xyz) + (to_light.lo + " +
           rest + ".spot_direction.xyz);");
  if (kind & (kLightDiffuse | kLightSpecular)) w.line("float n_dot_l = dot(n, to_light.hi);");
}

void emit_precise_half_vector(Writer& w, const ProgramKey& key) {
  w.line(std::string("vec3 h = half_vector(to_light, ") +
         (key.local_viewer ? "to_viewer" : "Two(viewer.xyz, viewer_low.xyz)") + ");");
}

}  // namespace legacy_gl
