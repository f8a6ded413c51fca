#include <algorithm>
#include <vector>

#include "shadergen/attributes.hpp"
#include "shadergen/emit.hpp"

namespace legacy_gl {

namespace {

enum Property : unsigned { kAmbient, kDiffuse, kSpecular, kEmission, kShininess };

constexpr const char* kSide[2] = {"front", "back"};

unsigned face_count(const ProgramKey& key) { return key.two_side ? 2 : 1; }

/// What is multiplied by a material that comes with the vertex is summed apart, and multiplied
/// once.
std::string sum_of(const ProgramKey& key, unsigned face, unsigned property) {
  const std::string side = kSide[face];
  if (property == kSpecular && key.separate_specular) return side + "_specular_sum";
  const std::string material = material_expression(key, face, property);
  return material.empty() ? side + "_sum" : side + "_sum_of_" + material;
}

/// The terms of lights, or of the scene, that go into one sum.
struct Sums {
  struct Sum {
    std::string name, terms;
  };
  std::vector<Sum> sums;

  void add(const std::string& name, const std::string& term) {
    for (Sum& sum : sums)
      if (sum.name == name) {
        sum.terms += " + " + term;
        return;
      }
    sums.push_back({name, term});
  }
};

bool has_term(const ProgramKey& key, unsigned property) {
  constexpr std::uint8_t kBits[] = {kLightAmbient, kLightDiffuse, kLightSpecular};
  return std::any_of(key.lights.begin(), key.lights.end(),
                     [&](const LightRun& run) { return run.count && run.kind & kBits[property]; });
}

constexpr unsigned kReflecting[] = {kAmbient, kDiffuse, kSpecular};

void emit_scene(Writer& w, const ProgramKey& key, unsigned face) {
  const std::string side = kSide[face];
  Sums scene;
  scene.add(side + "_sum", side + "_scene.rgb");
  if (const auto emission = material_expression(key, face, kEmission); !emission.empty())
    scene.add(side + "_sum", emission + ".rgb");
  if (!material_expression(key, face, kAmbient).empty())
    scene.add(sum_of(key, face, kAmbient), side + "_ambient_light.rgb");
  for (const unsigned property : kReflecting) {
    const std::string sum = sum_of(key, face, property);
    const bool begun = std::any_of(scene.sums.begin(), scene.sums.end(),
                                   [&](const Sums::Sum& other) { return other.name == sum; });
    if (!begun && has_term(key, property)) scene.add(sum, "vec3(0.0)");
  }
  for (const Sums::Sum& sum : scene.sums) w.line("vec3 " + sum.name + " = " + sum.terms + ";");
}

/// The sums times their materials.
void emit_reflection(Writer& w, const ProgramKey& key, unsigned face) {
  const std::string side = kSide[face];
  std::vector<std::string> done;
  for (const unsigned property : kReflecting) {
    const std::string material = material_expression(key, face, property);
    const std::string sum = sum_of(key, face, property);
    if (material.empty() || std::find(done.begin(), done.end(), sum) != done.end()) continue;
    if (property != kAmbient && !has_term(key, property)) continue;
    done.push_back(sum);
    if (property == kSpecular && key.separate_specular) w.line(sum + " *= " + material + ".rgb;");
    else w.line(side + "_sum += " + sum + " * " + material + ".rgb;");
  }
}

/// GL 2.1 spec 2.14.1: the vector to the light, attenuation and spot factor.
void emit_to_light(Writer& w, const ProgramKey& key, std::uint8_t kind, const std::string& light) {
  const std::string finite = key.space == LightingSpace::kEyeHomogeneous ? " * finite" : "";
  w.line("vec3 delta = " + light + ".position.xyz" + finite + " - vertex;");
  w.line("vec3 to_light = unit_of_any(delta);");
  if (kind & kLightAttenuated) emit_distance(w, key, light, "dot(delta, to_light)");
  // The chord form keeps its digits where the cosine, near 1, loses them.
  if (kind & kLightSpot) w.line("vec3 chord = to_light + " + light + ".spot_direction.xyz;");
}

void emit_strength(Writer& w, const ProgramKey& key, std::uint8_t kind, const std::string& light) {
  if (kind & kLightAttenuated) {
    w.line("vec3 k = " + light + ".attenuation.xyz;");
    w.line("float strength = 1.0 / max(k.x + distance * (k.y + distance * k.z), 1e-37);");
  }
  if (kind & kLightSpot) {
    const std::string target = kind & kLightAttenuated ? "strength *= " : "float strength = ";
    w.line("float one_minus_cosine = 0.5 * dot(chord, chord);");
    const std::string inside =
        kind & kLightSpotExponent
            ? (key.quality == Quality::kPrecise
                   ? "power_of(1.0 - one_minus_cosine, one_minus_cosine, " + light +
                         ".attenuation.w)"
                   : "exp2(" + light + ".attenuation.w * " +
                         (key.quality == Quality::kFastest
                              ? "log2(1.0 - one_minus_cosine))"
                              : "log2_of(1.0 - one_minus_cosine, one_minus_cosine))"))
            : "1.0";
    w.line(target + "one_minus_cosine <= " + light + ".spot_direction.w ? " + inside + " : 0.0;");
  }
}

bool normal_has_low(const ProgramKey& key) {
  return key.quality == Quality::kPrecise && key.normal != NormalMode::kAsIs;
}

void emit_half_vector(Writer& w, const ProgramKey& key, std::uint8_t kind,
                      const std::string& light) {
  const std::string half_vector =
      corrects_half_vector(key, kind) ? "half_vector_of_units(to_light, " : "unit(to_light + ";
  const bool computed = key.local_viewer || kind & kLightPoint;
  if (computed && key.quality == Quality::kPrecise) emit_precise_half_vector(w, key);
  else if (key.local_viewer) w.line("vec3 h = " + half_vector + "to_viewer);");
  else if (kind & kLightPoint) w.line("vec3 h = " + half_vector + "viewer.xyz);");
  else if (!splits_half_vectors(key) || key.normal == NormalMode::kNormalize)
    w.line("vec3 h = " + light + ".half_vector.xyz;");
  else {
    w.line("float n_dot_h = dot(n_coarse, " + light + ".half_vector.xyz);");
    w.line("float n_dot_h_rest = dot(n_rest, " + light + ".half_vector.xyz) + dot(n, " + light +
           ".attenuation.xyz);");
  }
}

/// The half vector is the light's own, known to double precision.
bool half_vector_is_uniform(const ProgramKey& key, std::uint8_t kind) {
  return !(kind & kLightPoint) && !key.local_viewer;
}

/// 1 - dot(n, h) of a face; dot(n, h) in the fastest quality.
std::string complement(const ProgramKey& key, std::uint8_t kind, unsigned face,
                       const std::string& light) {
  const std::string n = face ? "-n" : "n";
  if (key.quality == Quality::kFastest) return "dot(" + n + ", h)";
  const bool unit_normal = key.normal == NormalMode::kNormalize;
  const bool split = half_vector_is_uniform(key, kind) && splits_half_vectors(key);
  if (split && !unit_normal)
    return face ? "min((1.0 + n_dot_h) + n_dot_h_rest, 1.0)"
                : "min((1.0 - n_dot_h) - n_dot_h_rest, 1.0)";
  std::string e = n + " - h";
  if (normal_has_low(key)) e = "(" + e + (face ? ") - n_low" : ") + n_low");
  if (split) e = "(" + e + ") - " + light + ".attenuation.xyz";
  if (unit_normal) return "complement_of_units(" + e + ")";
  return "complement(" + e + ", " + n + ", h, half_excess)";
}

/// A colour that leaves float32's range may be met by a power that does: its square root does not.
bool takes_roots(const ProgramKey& key, unsigned face) {
  return key.scaled_sums && key.integer_shininess[face] == kGeneralShininess;
}

std::string shine(const ProgramKey& key, std::uint8_t kind, unsigned face,
                  const std::string& light) {
  const std::string q = complement(key, kind, face, light);
  if (key.integer_shininess[face] != kGeneralShininess)
    return std::string(kSide[face]) + "_shine(" + q + ")";
  std::string arguments = q;
  const char* function = "power_of_complement(";
  if (key.quality == Quality::kFastest) {
    function = "power(";
  } else if (half_vector_is_uniform(key, kind) && splits_half_vectors(key) &&
             key.normal != NormalMode::kNormalize) {
    function = "power_of(";
    arguments = std::string(face ? "-" : "") + "(n_dot_h + n_dot_h_rest), " + q;
  }
  return function + arguments + ", " + (takes_roots(key, face) ? "0.5 * " : "") +
         (key.material[face][kShininess] == MaterialSource::kVertex
              ? material_expression(key, face, kShininess)
              : std::string(kSide[face]) + "_ambient_light.w") +
         ")";
}

void emit_terms(Writer& w, const ProgramKey& key, std::uint8_t kind, unsigned face,
                const std::string& index) {
  const std::string side = kSide[face];
  const bool scaled = (kind & (kLightAttenuated | kLightSpot)) != 0;
  const std::string n_dot_l = face ? "-n_dot_l" : "n_dot_l";
  const std::string facing = face ? "n_dot_l < 0.0" : "n_dot_l > 0.0";
  const std::string products = side + "_products[" + index + "].";
  // First what is small.
  if (key.quality == Quality::kPrecise && kind & kLightDiffuse && !scaled)
    w.line(sum_of(key, face, kDiffuse) + " += max(" + n_dot_l + ", 0.0) * " + products +
           "ambient.rgb;");
  Sums light;
  if (kind & kLightAmbient) light.add(sum_of(key, face, kAmbient), products + "ambient.rgb");
  if (kind & kLightDiffuse)
    light.add(sum_of(key, face, kDiffuse),
              "max(" + n_dot_l + ", 0.0) * " + products + "diffuse.rgb");
  if (kind & kLightSpecular) {
    std::string shining =
        "(" + facing + " ? " + shine(key, kind, face, "lights[" + index + "]") + " : 0.0)";
    if (takes_roots(key, face)) {
      w.line("float " + side + "_root = " + shining + ";");
      shining = side + "_root * (" + side + "_root * ";
    }
    const std::string color = products + "specular.rgb";
    light.add(sum_of(key, face, kSpecular),
              takes_roots(key, face) ? shining + color + ")" : shining + " * " + color);
  }
  for (const Sums::Sum& sum : light.sums)
    w.line(sum.name + " += " + (scaled ? "strength * (" + sum.terms + ")" : sum.terms) + ";");
}

/// The normal as a multiple of 1/2048 and the rest: the dot product of two such multiples is exact.
/// From them also (|n|^2 - 1) / 2.
void emit_normal_split(Writer& w, const ProgramKey& key) {
  const bool unit_normal = key.normal == NormalMode::kNormalize;
  bool split = false;
  for (const LightRun& run : key.lights) {
    if (!run.count) continue;
    const bool specular = run.kind & kLightSpecular;
    if (specular && !unit_normal) split = true;
    if (key.quality == Quality::kPrecise && !(run.kind & kLightPoint) &&
        run.kind & (kLightDiffuse | kLightSpecular))
      split = true;
  }
  if (!split) return;
  // Through integers, which stay in range where the normal is huge.
  w.line("vec3 n_coarse = vec3(ivec3(n * 2048.0)) * (1.0 / 2048.0);");
  w.line(normal_has_low(key) ? "vec3 n_rest = (n - n_coarse) + n_low;"
                             : "vec3 n_rest = n - n_coarse;");
  if (!computes_half_vectors(key) || unit_normal) return;
  w.line(
      "float half_excess = 0.5 * ((dot(n_coarse, n_coarse) - 1.0) + dot(n_rest, n_coarse + n));");
  if (key.angle_error) {
    w.line("half_excess += n.x * dot(vec3(angle_error_half.x, angle_error_mixed.zy), n);");
    w.line("half_excess += n.y * dot(vec2(angle_error_half.y, angle_error_mixed.x), n.yz);");
    w.line("half_excess += n.z * (angle_error_half.z * n.z);");
  }
}

void emit_light(Writer& w, const ProgramKey& key, std::uint8_t kind, const std::string& index) {
  const std::string light = "lights[" + index + "]";
  const bool precise = key.quality == Quality::kPrecise;
  if (precise) emit_precise_to_light(w, key, kind, index);
  else if (kind & kLightPoint) emit_to_light(w, key, kind, light);
  else w.line("vec3 to_light = " + light + ".position.xyz;");
  if (kind & kLightPoint) emit_strength(w, key, kind, light);
  if (!precise && kind & (kLightDiffuse | kLightSpecular))
    w.line("float n_dot_l = dot(n, to_light);");
  if (kind & kLightSpecular) emit_half_vector(w, key, kind, light);
  for (unsigned face = 0; face < face_count(key); ++face) emit_terms(w, key, kind, face, index);
}

}  // namespace

void emit_distance(Writer& w, const ProgramKey& key, const std::string& light,
                   const std::string& expression) {
  const std::string distance = expression + " * " + light + ".half_vector.w";
  // From a vertex at infinity to a light that is not.
  if (key.space == LightingSpace::kEyeHomogeneous)
    w.line("float distance = finite == 0.0 ? 1e30 : " + distance + ";");
  else w.line("float distance = " + distance + ";");
}

bool corrects_half_vector(const ProgramKey& key, std::uint8_t kind) {
  return key.quality == Quality::kDefault &&
         (kind & kLightAttenuated || (key.local_viewer && key.light_count() > 1));
}

std::string material_expression(const ProgramKey& key, unsigned face, unsigned property) {
  switch (key.material[face][property]) {
    case MaterialSource::kUniform: return "";
    case MaterialSource::kColor: return std::string("color") + (key.per_fragment ? "_at" : "");
    case MaterialSource::kVertex:
      return std::string(kMaterialAttributeNames[face][property]) + (key.per_fragment ? "_at" : "");
  }
  return "";
}

void emit_lighting_space(Writer& w, const ProgramKey& key) {
  if (key.quality == Quality::kPrecise) return emit_precise_space(w, key);
  emit_lighting_position(w, key);
  emit_lighting_normal(w, key);
}

void emit_lighting_position(Writer& w, const ProgramKey& key) {
  const std::string position = key.lighting_position ? "lighting_position" : "position";
  if (lighting_reads_position(key)) switch (key.space) {
      case LightingSpace::kObject: w.line("vec3 vertex = " + position + ".xyz;"); break;
      case LightingSpace::kEyeAxes:
        w.line("vec3 vertex = mat3(modelview) * " + position + ".xyz;");
        break;
      case LightingSpace::kEyeHomogeneous:
        w.line("vec4 position_eye = modelview * " + position + ";");
        w.line("float finite = position_eye.w == 0.0 ? 0.0 : 1.0;  // of a vertex at infinity");
        w.line("vec3 vertex = position_eye.xyz / (position_eye.w == 0.0 ? 1.0 : position_eye.w);");
        break;
    }
}

void emit_lighting_normal(Writer& w, const ProgramKey& key) {
  const std::string normal =
      key.space == LightingSpace::kObject ? "normal" : "normal_matrix * normal";
  switch (key.normal) {
    case NormalMode::kAsIs: w.line("vec3 n = normal;"); break;
    case NormalMode::kScaled: w.line("vec3 n = viewer.w * normal;"); break;
    case NormalMode::kMatrix: w.line("vec3 n = normal_matrix * normal;"); break;
    case NormalMode::kNormalize: w.line("vec3 n = unit_of_any(" + normal + ");"); break;
  }
}

void emit_lights(Writer& w, const ProgramKey& key) {
  for (unsigned face = 0; face < face_count(key); ++face) emit_scene(w, key, face);
  if (key.quality != Quality::kFastest) emit_normal_split(w, key);
  if (key.quality == Quality::kPrecise) emit_precise_viewer(w, key);
  else if (key.local_viewer)
    w.line(key.space == LightingSpace::kEyeHomogeneous
               ? "vec3 to_viewer = unit_of_any(viewer.xyz * finite - vertex);"
               : "vec3 to_viewer = unit_of_any(viewer.xyz - vertex);");

  // Eight lights unroll; more loop, a kind at a time.
  const bool unroll = key.light_count() <= 8;
  unsigned first = 0;
  for (const LightRun& run : key.lights) {
    if (run.count == 0) break;
    const unsigned end = first + run.count;
    if (unroll) {
      for (unsigned i = first; i < end; ++i) {
        w.open("{");
        emit_light(w, key, run.kind, std::to_string(i));
        w.close();
      }
    } else {
      w.open("for (int i = " + std::to_string(first) + "; i < " + std::to_string(end) + "; ++i) {");
      emit_light(w, key, run.kind, "i");
      w.close();
    }
    first = end;
  }

  for (unsigned face = 0; face < face_count(key); ++face) {
    const std::string side = kSide[face];
    emit_reflection(w, key, face);
    const std::string diffuse = material_expression(key, face, kDiffuse);
    const std::string alpha =
        diffuse.empty() ? side + "_scene.a" : "clamp(" + diffuse + ".a, 0.0, 1.0)";
    if (key.scaled_sums) {
      w.line(side + "_sum *= " + side + "_products[0].diffuse.w;");
      if (key.separate_specular)
        w.line(side + "_specular_sum *= " + side + "_products[0].diffuse.w;");
    }
    // GL 2.1 spec 2.14.6: colours are clamped before they are interpolated.
    w.line("vec4 " + side + "_lit = vec4(clamp(" + side + "_sum, 0.0, 1.0), " + alpha + ");");
    if (key.separate_specular)
      w.line("vec3 " + side + "_specular = clamp(" + side + "_specular_sum, 0.0, 1.0);");
  }
}

}  // namespace legacy_gl
