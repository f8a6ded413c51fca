#include "software/vertex_lighting.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/float4.hpp"
#include "translate/draw_inputs_parts.hpp"

namespace legacy_gl {

namespace {

// The forms are those of shadergen/emit_lighting.cpp and emit_functions.cpp, which say why.

struct Vector {
  Float4 x, y, z;
};

Vector vector_of(const glm::vec4& v) { return {splat(v.x), splat(v.y), splat(v.z)}; }
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator-(const Vector& a) { return {-a.x, -a.y, -a.z}; }
Vector operator*(const Vector& a, const Float4& s) { return {a.x * s, a.y * s, a.z * s}; }
Float4 dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vector product(const std::array<glm::vec4, 3>& m, const Vector& v) {
  return {m[0].x * v.x + m[1].x * v.y + m[2].x * v.z, m[0].y * v.x + m[1].y * v.y + m[2].y * v.z,
          m[0].z * v.x + m[1].z * v.y + m[2].z * v.z};
}

Int4 bits_of(const Float4& v) { return std::bit_cast<Int4>(v); }
Float4 float_of(const Int4& v) { return std::bit_cast<Float4>(v); }
Float4 magnitude(const Float4& v) { return float_of(bits_of(v) & 0x7fffffff); }

/// By Newton's way, from a first guess of its bits: three steps have all of float32.
Float4 inverse_sqrt(const Float4& x) {
  Float4 y = float_of(0x5f3759df - (bits_of(x) >> 1));
  const Float4 half = 0.5f * x;
  for (int step = 0; step < 3; ++step) y *= 1.5f - half * y * y;
  return y;
}

Vector unit(const Vector& v) { return v * inverse_sqrt(greatest(dot(v, v), splat(1e-37f))); }

Vector unit_of_any(const Vector& v) {
  const Float4 size = greatest(greatest(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
  const Int4 exponent = bits_of(size) & 0x7f800000;
  const Int4 opposite = 0x7f000000 - exponent;
  const Int4 largest = Int4{} + 0x7e800000;
  return unit(v * float_of(opposite < largest ? opposite : largest));
}

Vector half_vector_of_units(const Vector& a, const Vector& b) {
  const Vector sum = a + b;
  return unit(sum + b * (0.5f * dot(sum, a - b)));
}

Float4 log2_of(Float4 x, const Float4& q) {
  x = greatest(x, splat(1e-37f));
  const Int4 bits = bits_of(x);
  const Int4 exponent = (bits - 0x3f3504f3) >> 23;
  const Float4 d = exponent == 0 ? -q : float_of(bits - (exponent << 23)) - 1.0f;
  const Float4 f = d / (2.0f + d);
  const Float4 g = f * f;
  return __builtin_convertvector(exponent, Float4) +
         f * (2.88539008f +
              g * (0.961796694f + g * (0.577078016f + g * (0.412198583f + g * 0.320598898f))));
}

Float4 exp2_of(Float4 t) {
  t = least(greatest(t, splat(-126)), splat(100));
  const Int4 whole = __builtin_convertvector(t + 127.5f, Int4) - 127;  // t + 127.5 is positive
  const Float4 f = t - __builtin_convertvector(whole, Float4);
  const Float4 power =
      1.0f +
      f * (0.693147181f +
           f * (0.240226507f +
                f * (0.0555041087f +
                     f * (0.00961812911f +
                          f * (0.00133335581f + f * (0.000154035304f + f * 0.0000152527338f))))));
  return power * float_of((whole + 127) << 23);
}

/// (1 - q)^exponent; `amplify` as emit_integer_shine says.
Float4 whole_power(const Float4& q, unsigned exponent, unsigned amplify) {
  if (exponent == 0) return splat(1);
  unsigned last = 1;
  while (last < amplify && last * 8 <= exponent) last *= 2;
  Float4 y = q;
  unsigned bit = std::bit_floor(exponent);
  for (bit >>= 1; bit >= last && bit; bit >>= 1) {
    y = y * (2.0f - y);
    if (exponent & bit) y = y + q * (1.0f - y);
  }
  Float4 x = 1.0f - y;
  for (; bit; bit >>= 1) {
    x *= x;
    if (exponent & bit) x *= 1.0f - q;
  }
  return least(greatest(x, splat(0)), splat(1e30f));
}

/// (1 - q)^exponent, to float32's digits however small it is.
Float4 power_by_logarithm(const Float4& q, float exponent) {
  const Float4 x = 1.0f - q;
  return x > 0 ? exp2_of(exponent * log2_of(x, q)) : Float4{};
}

/// (1 - q)^exponent; 0^0 is 1.
Float4 power_of_complement(const Float4& q, float exponent, unsigned amplify) {
  if (exponent == std::floor(exponent) && exponent >= 0 && exponent <= 128)
    return whole_power(q, static_cast<unsigned>(exponent), amplify);
  return power_by_logarithm(q, exponent);
}

class Lighter {
 public:
  Lighter(const DrawInputs& derived, unsigned face, LightingBlock& block)
      : key_(derived.key),
        transform_(derived.transform),
        uniforms_(derived.faces[face]),
        back_(face != 0),
        amplify_(derived.key.normal == NormalMode::kNormalize ? 1 : 8),
        position_{load(block.position[0]), load(block.position[1]), load(block.position[2])},
        normal_{load(block.normal[0]), load(block.normal[1]), load(block.normal[2])} {}

  void light(const DrawInputs& derived, LightingBlock& block) {
    choose_space();
    Vector sum = vector_of(uniforms_.head.scene);
    std::size_t at = 0;
    for (const LightRun& run : key_.lights)
      for (unsigned i = 0; i < run.count; ++i, ++at)
        sum = sum + contribution(run.kind, derived.lights[at], uniforms_.products[at]);
    const auto clamped = [](const Float4& v) { return least(greatest(v, splat(0)), splat(1)); };
    store(block.color[0], clamped(sum.x));
    store(block.color[1], clamped(sum.y));
    store(block.color[2], clamped(sum.z));
    store(block.color[3], splat(uniforms_.head.scene.a));
  }

 private:
  void choose_space() {
    const glm::mat4& m = transform_.modelview;
    if (key_.space == LightingSpace::kEyeAxes) position_ = product({m[0], m[1], m[2]}, position_);
    Vector n =
        key_.space == LightingSpace::kObject ? normal_ : product(transform_.normal_matrix, normal_);
    if (key_.normal == NormalMode::kScaled) n = n * splat(transform_.viewer.w);
    if (key_.normal == NormalMode::kNormalize) n = unit_of_any(n);
    normal_ = n;
    to_viewer_ = vector_of(transform_.viewer);
    if (key_.local_viewer) to_viewer_ = unit_of_any(to_viewer_ - position_);
    if (key_.normal != NormalMode::kNormalize && has_light(key_, kLightSpecular)) split_normal();
  }

  void split_normal() {
    const auto coarse = [](const Float4& v) {
      const Float4 steps = least(greatest(v * 2048.0f, splat(-1e9f)), splat(1e9f));
      return __builtin_convertvector(__builtin_convertvector(steps, Int4), Float4) *
             (1.0f / 2048.0f);
    };
    coarse_ = {coarse(normal_.x), coarse(normal_.y), coarse(normal_.z)};
    rest_ = normal_ - coarse_;
    half_excess_ = 0.5f * ((dot(coarse_, coarse_) - 1.0f) + dot(rest_, coarse_ + normal_));
    if (!key_.angle_error) return;
    const Vector n = normal_;
    const glm::vec4 &half = transform_.angle_error_half, &mixed = transform_.angle_error_mixed;
    half_excess_ += n.x * (half.x * n.x + mixed.z * n.y + mixed.y * n.z) +
                    n.y * (half.y * n.y + mixed.x * n.z) + n.z * (half.z * n.z);
  }

  Vector contribution(std::uint8_t kind, const LightUniforms& light,
                      const LightProducts& products) const {
    Vector to_light = vector_of(light.position);
    Float4 strength = splat(1);
    if (kind & kLightPoint) {
      const Vector delta = to_light - position_;
      to_light = unit_of_any(delta);
      strength = strength_of(kind, light, delta, to_light);
    }
    const Float4 n_dot_l = back_ ? -dot(normal_, to_light) : dot(normal_, to_light);
    Vector sum{};
    if (kind & kLightAmbient) sum = vector_of(products.ambient);
    if (kind & kLightDiffuse) sum = sum + vector_of(products.diffuse) * greatest(n_dot_l, splat(0));
    if (kind & kLightSpecular) {
      const Float4 shine = power_of_complement(complement(kind, light, to_light),
                                               uniforms_.head.ambient_light.w, amplify_);
      sum = sum + vector_of(products.specular) * (n_dot_l > 0 ? shine : Float4{});
    }
    return kind & (kLightAttenuated | kLightSpot) ? sum * strength : sum;
  }

  Float4 strength_of(std::uint8_t kind, const LightUniforms& light, const Vector& delta,
                     const Vector& to_light) const {
    Float4 strength = splat(1);
    if (kind & kLightAttenuated) {
      const Float4 distance = dot(delta, to_light) * light.half_vector.w;
      const glm::vec4& k = light.attenuation;
      strength = 1.0f / greatest(k.x + distance * (k.y + distance * k.z), splat(1e-37f));
    }
    if (kind & kLightSpot) {
      const Vector chord = to_light + vector_of(light.spot_direction);
      const Float4 one_minus_cosine = 0.5f * dot(chord, chord);
      if (kind & kLightSpotExponent)
        strength *= power_by_logarithm(one_minus_cosine, light.attenuation.w);
      strength = one_minus_cosine <= light.spot_direction.w ? strength : Float4{};
    }
    return strength;
  }

  /// 1 - dot(n, h) of the face.
  Float4 complement(std::uint8_t kind, const LightUniforms& light, const Vector& to_light) const {
    const Vector n = back_ ? -normal_ : normal_;
    const bool unit_normal = key_.normal == NormalMode::kNormalize;
    Vector h = vector_of(light.half_vector);
    if (key_.local_viewer || kind & kLightPoint) {
      const bool corrects =
          kind & kLightAttenuated || (key_.local_viewer && key_.light_count() > 1);
      h = corrects ? half_vector_of_units(to_light, to_viewer_) : unit(to_light + to_viewer_);
    } else if (splits_half_vectors(key_)) {
      const Vector low = vector_of(light.attenuation);
      if (unit_normal) return complement_of_units((n - h) - low);
      const Float4 n_dot_h = dot(coarse_, h);
      const Float4 n_dot_h_rest = dot(rest_, h) + dot(normal_, low);
      return least(back_ ? (1.0f + n_dot_h) + n_dot_h_rest : (1.0f - n_dot_h) - n_dot_h_rest,
                   splat(1));
    }
    const Vector e = n - h;
    if (unit_normal) return complement_of_units(e);
    return least(half_excess_ < 0.5f ? 0.5f * dot(e, e) - half_excess_ : 1.0f - dot(n, h),
                 splat(1));
  }

  static Float4 complement_of_units(const Vector& e) { return least(0.5f * dot(e, e), splat(1)); }

  const ProgramKey& key_;
  const TransformUniforms& transform_;
  const FaceUniforms& uniforms_;
  bool back_;
  unsigned amplify_;
  Vector position_, normal_;
  Vector to_viewer_{}, coarse_{}, rest_{};
  Float4 half_excess_{};
};

}  // namespace

bool lights_blocks(const ProgramKey& key) {
  ProgramKey rest = key;
  rest.flat = rest.two_side = rest.local_viewer = rest.angle_error = false;
  rest.w_is_one = rest.parallel = false;
  rest.space = {};
  rest.normal = {};
  rest.integer_shininess = {};
  rest.lights = {};
  ProgramKey lit;
  lit.lit = true;
  return key.space != LightingSpace::kEyeHomogeneous && rest == lit;
}

void light_block(const DrawInputs& derived, unsigned face, LightingBlock& block) {
  Lighter(derived, face, block).light(derived, block);
}

}  // namespace legacy_gl
