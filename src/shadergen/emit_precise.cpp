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

Two two_sum(vec3 a, vec3 b) {
  vec3 s = a + b;
  vec3 c = s - a;
  return Two(s, (a - (s - c)) + (b - c));
}

Two add(Two a, Two b) {
  Two s = two_sum(a.hi, b.hi);
  return two_sum(s.hi, s.lo + (a.lo + b.lo));
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

// A multiple of 1/2048. Dot products of two such that are no longer than 1 are exact.
vec3 coarse(vec3 a) {
  return floor(clamp(a, -2.0, 2.0) * 2048.0) * (1.0 / 2048.0);
}

float two_dot(Two a, Two b) {
  vec3 a_coarse = coarse(a.hi);
  vec3 b_coarse = coarse(b.hi);
  return dot(a_coarse, b_coarse) + (dot(a.hi, b.hi - b_coarse) + dot(a.hi - a_coarse, b_coarse) +
                                    dot(a.hi, b.lo) + dot(a.lo, b.hi));
}

// (|v|^2 - 1) / 2
float excess(Two v) {
  vec3 v_coarse = coarse(v.hi);
  return 0.5 * ((dot(v_coarse, v_coarse) - 1.0) + dot(v.hi - v_coarse, v_coarse + v.hi)) +
         dot(v.hi, v.lo);
}

)";

constexpr const char* kUnit =
    R"(// An exact power of two that brings the largest of the components near 1.
float power_of_two_for(vec3 v) {
  vec3 a = abs(v);
  uint exponent = floatBitsToUint(max(max(a.x, a.y), a.z)) & 0x7f800000u;
  return uintBitsToFloat(clamp(0x7f000000u - exponent, 0x00800000u, 0x7e800000u));
}

Two two_unit(Two v) {
  float power = power_of_two_for(v.hi);
  v = Two(v.hi * power, v.lo * power);
  Two w = scaled(v, inversesqrt(max(dot(v.hi, v.hi), 1e-37)));
  return Two(w.hi, w.lo - excess(w) * w.hi);
}

)";

// In object space, of a vector that has unit length in eye coordinates.
constexpr const char* kBentUnit =
    R"(// A direction (bend -1) or a normal (bend 1) of unit length under a modelview that keeps angles only
// nearly.
Two bent_unit(Two v, float bend) {
  Two w = two_unit(v);
  return Two(w.hi, w.lo - (0.5 * bend * dot(w.hi, angle_error * w.hi)) * w.hi);
}

)";

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
  return two_sum(quotient, rest / w.hi);
}

)";

constexpr const char* kComplement = R"(// 1 - dot(n, h)
float complement(Two n, Two h) {
  vec3 n_coarse = coarse(n.hi);
  vec3 h_coarse = coarse(h.hi);
  return min((1.0 - dot(n_coarse, h_coarse)) -
             (dot(n.hi, h.hi - h_coarse) + dot(n.hi - n_coarse, h_coarse) + dot(n.hi, h.lo) +
              dot(n.lo, h.hi)), 1.0);
}

)";

std::string direction_unit(const ProgramKey& key, const std::string& v) {
  return key.angle_error ? "bent_unit(" + v + ", -1.0)" : "two_unit(" + v + ")";
}

std::string normal_unit(const ProgramKey& key, const std::string& v) {
  return key.angle_error ? "bent_unit(" + v + ", 1.0)" : "two_unit(" + v + ")";
}

bool transforms(const ProgramKey& key) {
  return key.space != LightingSpace::kObject || key.normal == NormalMode::kMatrix;
}

}  // namespace

void emit_precise_functions(Writer& w, const ProgramKey& key) {
  w.raw(kTwo);
  w.raw(kUnit);
  if (key.angle_error) w.raw(kBentUnit);
  if (transforms(key)) w.raw(kLinear);
  if (key.space == LightingSpace::kEyeHomogeneous) w.raw(kHomogeneous);
  for (const LightRun& run : key.lights)
    if (run.count && run.kind & kLightSpecular) return w.raw(kComplement);
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
    case NormalMode::kAsIs: w.line("Two n = Two(normal, vec3(0.0));"); break;
    case NormalMode::kScaled:
      w.line("Two n = scaled(Two(normal, vec3(0.0)), viewer.w);");
      w.line("n.lo += viewer_low.w * normal;");
      break;
    case NormalMode::kMatrix:
      w.line("Two n = linear(normal_matrix, normal_matrix_low, normal);");
      break;
    case NormalMode::kNormalize:
      if (key.space == LightingSpace::kObject)
        w.line("Two n = " + normal_unit(key, "Two(normal, vec3(0.0))") + ";");
      else
        w.line(
            "Two n = two_unit(linear(normal_matrix, normal_matrix_low, normal * "
            "power_of_two_for(normal)));");
      break;
  }
}

void emit_precise_viewer(Writer& w, const ProgramKey& key) {
  if (!key.local_viewer) return;
  const std::string finite = key.space == LightingSpace::kEyeHomogeneous ? " * finite" : "";
  w.line("Two to_viewer = " +
         direction_unit(key, "add(Two(viewer.xyz" + finite + ", viewer_low.xyz" + finite +
                                 "), Two(-vertex.hi, -vertex.lo))") +
         ";");
}

void emit_precise_to_light(Writer& w, const ProgramKey& key, std::uint8_t kind,
                           const std::string& index) {
  const std::string light = "lights[" + index + "]";
  const std::string rest = "lights_low[" + index + "]";
  if (!(kind & kLightPoint)) {
    w.line("Two to_light = Two(" + light + ".position.xyz, " + rest + ".position.xyz);");
    return;
  }
  const std::string finite = key.space == LightingSpace::kEyeHomogeneous ? " * finite" : "";
  w.line("Two delta = add(Two(" + light + ".position.xyz" + finite + ", " + rest + ".position.xyz" +
         finite + "), Two(-vertex.hi, -vertex.lo));");
  w.line("Two to_light = " + direction_unit(key, "delta") + ";");
  if (kind & kLightAttenuated) emit_distance(w, key, light, "dot(delta.hi, to_light.hi)");
  if (kind & kLightSpot)
    w.line("vec3 chord = (to_light.hi + " + light + ".spot_direction.xyz) + (to_light.lo + " +
           rest + ".spot_direction.xyz);");
}

void emit_precise_half_vector(Writer& w, const ProgramKey& key, std::uint8_t kind,
                              const std::string& index) {
  const std::string light = "lights[" + index + "]";
  if (key.local_viewer) w.line("Two h = " + direction_unit(key, "add(to_light, to_viewer)") + ";");
  else if (kind & kLightPoint)
    w.line("Two h = " + direction_unit(key, "add(to_light, Two(viewer.xyz, viewer_low.xyz))") +
           ";");
  else w.line("Two h = Two(" + light + ".half_vector.xyz, " + light + ".attenuation.xyz);");
}

}  // namespace legacy_gl
