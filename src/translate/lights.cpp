// Which lights and material terms there are: their part of the key.
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "translate/draw_inputs_parts.hpp"

namespace legacy_gl {

namespace {

bool is_black(const glm::dvec3& color) { return color.r == 0 && color.g == 0 && color.b == 0; }

/// GL 2.1 spec 2.14.1, "spot" for a light whose direction is the same everywhere.
double directional_spot_factor(const Light& light) {
  const double cosine =
      glm::dot(-unit(glm::dvec3(light.position_eye)), unit(light.spot_direction_eye));
  const double limit =
      std::cos(static_cast<double>(light.spot_cutoff_degrees) * std::numbers::pi / 180);
  if (std::max(cosine, 0.0) < limit) return 0;
  return std::pow(std::max(cosine, 0.0), static_cast<double>(light.spot_exponent));
}

/// What an active light leaves out of its equation.
void count_skipped(legacy_gl_statistics& statistics, const Light& light, int terms) {
  statistics.light_terms_skipped += static_cast<std::uint64_t>(3 - terms);
  if (is_directional(light)) return;
  if (light.linear_attenuation == 0 && light.quadratic_attenuation == 0 &&
      light.constant_attenuation != 1)
    ++statistics.attenuations_folded;
  if (is_spot(light) && light.spot_exponent == 0) ++statistics.spot_exponents_skipped;
}

/// Larger products of light and material are scaled, so that sums of them stay in float32's range.
constexpr double kLargestProduct = 1e36;

/// Repeated squaring of the complement has 1e-7 of the largest power: too little for a specular
/// colour that makes a power of 1e-7 visible.
constexpr double kSquaringIsPlenty = 1e3;

/// Integer shininesses that may become part of programs' text, of each context.
constexpr std::size_t kMostBakedShininesses = 16;

/// Where the last squarings are of the power itself and make it small, its digits are kept
/// (emit_functions.cpp).
bool squaring_serves_any_color(const Context& context, float shininess) {
  return quality_of(context) == Quality::kFastest ||
         (quality_of(context) == Quality::kDefault && !context.transform.normalize_enabled &&
          shininess >= 32);
}

/// When more kinds meet than a key holds, they become the three that serve all.
std::uint8_t widest_kind(std::uint8_t kind) {
  constexpr std::uint8_t kTerms = kLightDiffuse | kLightSpecular;
  if (!(kind & kLightPoint)) return kTerms;
  if (!(kind & kLightSpot)) return kLightPoint | kLightAttenuated | kLightAmbient | kTerms;
  return kLightPoint | kLightAttenuated | kLightSpot | kLightSpotExponent | kLightAmbient | kTerms;
}

/// Directional lights, then point lights, then spots: a general program treats each class in turn.
/// Within a class equal kinds are neighbours, and within a kind lights keep their order.
bool by_kind(const ActiveLight& a, const ActiveLight& b) {
  const unsigned class_a = a.kind & (kLightPoint | kLightSpot);
  const unsigned class_b = b.kind & (kLightPoint | kLightSpot);
  if (class_a != class_b) return class_a < class_b;
  return a.kind != b.kind ? a.kind > b.kind : a.index < b.index;
}

/// How the light enters, but for its terms.
ActiveLight classify(const Light& light, unsigned index) {
  ActiveLight active{index, 0, 1};
  if (is_directional(light)) {
    if (is_spot(light)) active.strength = directional_spot_factor(light);
    return active;
  }
  active.kind |= kLightPoint;
  if (light.linear_attenuation != 0 || light.quadratic_attenuation != 0)
    active.kind |= kLightAttenuated;
  else if (light.constant_attenuation != 1)
    active.strength = light.constant_attenuation == 0
                          ? double{FLT_MAX}
                          : 1 / static_cast<double>(light.constant_attenuation);
  if (is_spot(light)) {
    active.kind |= kLightSpot;
    if (light.spot_exponent != 0) active.kind |= kLightSpotExponent;
  }
  return active;
}

}  // namespace

void DrawInputs::choose_materials(const Context& context, const VertexLayout& layout) {
  const ColorMaterial& tracking = context.lighting.color_material;
  const MaterialMask tracked =
      tracking.enabled ? material_mask(tracking.face, tracking.mode) : MaterialMask{0};
  for (unsigned face = 0; face < face_count(key); ++face)
    for (unsigned property = 0; property < kPropertyCount; ++property) {
      const MaterialMask bit = material_bit(face, property);
      MaterialSource source = MaterialSource::kUniform;
      if (layout.materials & bit) source = MaterialSource::kVertex;
      if (tracked & bit) source = MaterialSource::kColor;
      key.material[face][property] = source;
      if (source == MaterialSource::kVertex) key.vertex_materials = layout.materials;
    }
}

/// Appends the light to active_ with those of its terms that are not black.
void DrawInputs::choose_terms(Context& context, const Light& light, ActiveLight active,
                              LargestProducts& largest) {
  bool ambient = false, diffuse = false, specular = false;
  for (unsigned face = 0; face < face_count(key); ++face) {
    const auto adds = [&](unsigned property, const glm::vec4& color) {
      const glm::dvec3 product =
          rgb(color) * uniform_material(context, key, face, property) * active.strength;
      const double size = largest_component(product);
      largest.any = std::max(largest.any, size);
      if (property == kSpecular) largest.specular = std::max(largest.specular, size);
      return !is_black(product);
    };
    ambient |= adds(kAmbient, light.ambient);
    diffuse |= adds(kDiffuse, light.diffuse);
    specular |= adds(kSpecular, light.specular);
  }
  if (diffuse) active.kind |= kLightDiffuse;
  if (specular) active.kind |= kLightSpecular;
  if (ambient && !folds_into_scene(active.kind)) active.kind |= kLightAmbient;
  // A light whose ambient term is folded stays in the list with no term of its own until the sums
  // are made.
  if (!ambient && !diffuse && !specular) {
    ++context.statistics.lights_skipped;
    return;
  }
  active_.push_back(active);
  count_skipped(context.statistics, light, ambient + diffuse + specular);
}

/// Neighbours of one kind are a run. False when there are too many runs.
bool DrawInputs::build_light_runs() {
  constexpr std::uint8_t kTerms = kLightAmbient | kLightDiffuse | kLightSpecular;
  key.lights = {};
  unsigned runs = 0;
  for (const ActiveLight& light : active_) {
    if (!(light.kind & kTerms)) continue;
    if (runs && key.lights[runs - 1].kind == light.kind) {
      ++key.lights[runs - 1].count;
      continue;
    }
    if (runs == kMaxLightRuns) return false;
    key.lights[runs++] = {light.kind, 1};
  }
  return true;
}

/// Products beyond what float32 can sum are divided by a power of two.
void DrawInputs::choose_sum_scale(const LightingState& lighting, double largest) {
  for (unsigned face = 0; face < face_count(key); ++face) {
    const Material& material = lighting.materials[face];
    largest = std::max({largest, largest_component(rgb(material.emission)),
                        largest_component(rgb(material.ambient) * rgb(lighting.model.ambient))});
  }
  sum_scale_ = 1;
  if (key.light_count() && largest > kLargestProduct && std::isfinite(largest))
    sum_scale_ = std::exp2(std::ceil(std::log2(largest / kLargestProduct)));
  key.scaled_sums = sum_scale_ != 1;
}

void DrawInputs::choose_specular(const Context& context, double largest_specular) {
  const LightingState& lighting = context.lighting;
  const bool specular = has_light(key, kLightSpecular);
  key.local_viewer = specular && lighting.model.local_viewer;
  key.separate_specular = specular && lighting.model.color_control == GL_SEPARATE_SPECULAR_COLOR;
  key.integer_shininess = {};
  for (unsigned face = 0; specular && face < face_count(key); ++face) {
    const float shininess = lighting.materials[face].shininess;
    const bool whole = shininess == std::floor(shininess) && shininess >= 0 && shininess <= 128 &&
                       key.material[face][kShininess] == MaterialSource::kUniform;
    const bool small = key.material[face][kSpecular] == MaterialSource::kColor
                           ? squaring_serves_any_color(context, shininess)
                           : largest_specular < kSquaringIsPlenty;
    key.integer_shininess[face] = whole && small && bakes(static_cast<unsigned>(shininess))
                                      ? static_cast<std::uint8_t>(shininess)
                                      : kGeneralShininess;
  }
}

void DrawInputs::choose_lights(Context& context) {
  active_.clear();
  LargestProducts largest;
  const LightingState& lighting = context.lighting;
  for (unsigned i = 0; i < lighting.lights.size(); ++i) {
    const Light& light = lighting.lights[i];
    if (light.enabled && reached_[i]) choose_terms(context, light, classify(light, i), largest);
  }
  std::sort(active_.begin(), active_.end(), by_kind);
  if (!build_light_runs()) {
    for (ActiveLight& light : active_) light.kind = widest_kind(light.kind);
    std::sort(active_.begin(), active_.end(), by_kind);
    build_light_runs();
  }
  if (!reached_.all()) fill_up_runs();
  choose_sum_scale(lighting, largest.any);
  choose_specular(context, largest.specular);
}

/// Black lights bring the number of each kind to a power of two: how many lights reach a draw
/// chooses among few programs.
void DrawInputs::fill_up_runs() {
  constexpr std::uint8_t kTerms = kLightAmbient | kLightDiffuse | kLightSpecular;
  filled_up_.clear();
  unsigned total = key.light_count();
  LightRun* run = key.lights.data();
  unsigned in_run = 0;
  for (const ActiveLight& light : active_) {
    filled_up_.push_back(light);
    if (!(light.kind & kTerms) || ++in_run < run->count) continue;
    const unsigned wanted = std::bit_ceil(in_run);
    for (; in_run < wanted && total < kMaxLights; ++in_run, ++total) {
      filled_up_.push_back(light);
      filled_up_.back().black = true;
    }
    run->count = static_cast<std::uint16_t>(in_run);
    ++run;
    in_run = 0;
  }
  std::swap(active_, filled_up_);
}

/// A program that animates the shininess would compile at every value: past a few, no new ones
/// become part of the text.
bool DrawInputs::bakes(unsigned shininess) {
  if (!baked_shininess_.test(shininess) && baked_shininess_.count() < kMostBakedShininesses)
    baked_shininess_.set(shininess);
  return baked_shininess_.test(shininess);
}

}  // namespace legacy_gl
