#include "backend/derive.hpp"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <numbers>
#include <utility>

namespace legacy_gl {

namespace {

/// NaN becomes 0 and infinity the largest float: one bad parameter stays one bad parameter.
float finite(double value) {
  if (std::isnan(value)) return 0;
  return static_cast<float>(std::clamp(value, -double{FLT_MAX}, double{FLT_MAX}));
}

glm::vec4 finite(const glm::dvec3& v, double w) {
  return {finite(v.x), finite(v.y), finite(v.z), finite(w)};
}

/// What `part` lacks of a value; 0 of a value that is not finite.
glm::vec4 rest_of(const glm::dvec4& value, const glm::vec4& part) {
  const glm::dvec4 rest = value - glm::dvec4(part);
  return std::isfinite(rest.x + rest.y + rest.z + rest.w) ? glm::vec4(rest) : glm::vec4(0);
}

/// What float32 rounds off.
glm::vec4 low(const glm::dvec3& v, double w) { return rest_of(glm::dvec4(v, w), finite(v, w)); }

glm::dvec3 unit(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return glm::dvec3(0);
  const glm::dvec3 scaled = v / largest;
  return scaled / glm::length(scaled);
}

glm::dvec3 rgb(const glm::vec4& color) { return {color.r, color.g, color.b}; }

bool is_black(const glm::dvec3& color) { return color.r == 0 && color.g == 0 && color.b == 0; }

bool is_directional(const Light& light) { return light.position_eye.w == 0; }

bool is_spot(const Light& light) { return light.spot_cutoff_degrees != 180; }

/// GL 2.1 spec 2.14.1, "spot" for a light whose direction is the same everywhere.
double directional_spot_factor(const Light& light) {
  const double cosine =
      glm::dot(-unit(glm::dvec3(light.position_eye)), unit(light.spot_direction_eye));
  const double limit =
      std::cos(static_cast<double>(light.spot_cutoff_degrees) * std::numbers::pi / 180);
  if (std::max(cosine, 0.0) < limit) return 0;
  return std::pow(std::max(cosine, 0.0), static_cast<double>(light.spot_exponent));
}

/// The material as one of GL's colours, or white where it comes with the vertex.
glm::dvec3 uniform_material(const Context& context, const ProgramKey& key, unsigned face,
                            unsigned property) {
  if (key.material[face][property] != MaterialSource::kUniform) return glm::dvec3(1);
  return rgb(material_value(context.lighting.materials, face, property));
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

bool folds_into_scene(std::uint8_t kind) { return !(kind & (kLightAttenuated | kLightSpot)); }

bool shininess_comes_with_vertices(const ProgramKey& key) {
  return key.material[kFront][kShininess] == MaterialSource::kVertex ||
         key.material[kBack][kShininess] == MaterialSource::kVertex;
}

/// GL_WIN_phong_shading: the equation in every fragment.
bool is_per_fragment(const Context& context) {
  const GLenum shade_model = context.lighting.shade_model;
  return shade_model == GL_PHONG_WIN ||
         (shade_model == GL_SMOOTH && context.options.quality == LEGACY_GL_QUALITY_PER_FRAGMENT);
}

/// Interpolation leaves nothing of a second float.
bool is_precise(const Context& context) {
  return context.options.quality == LEGACY_GL_QUALITY_PRECISE && !is_per_fragment(context);
}

Quality quality_of(const Context& context) {
  switch (context.options.quality) {
    case LEGACY_GL_QUALITY_FASTEST: return Quality::kFastest;
    case LEGACY_GL_QUALITY_PRECISE:
      return is_precise(context) ? Quality::kPrecise : Quality::kDefault;
    case LEGACY_GL_QUALITY_DEFAULT:
    case LEGACY_GL_QUALITY_PER_FRAGMENT: break;
  }
  return Quality::kDefault;
}

/// How long a unit normal is after the normal matrix and GL_RESCALE_NORMAL, under a modelview that
/// keeps angles.
double length_of_unit_normal(const Context& context, const LinearPart& linear) {
  return (context.transform.rescale_normal_enabled ? linear.rescale_factor : 1.0) / linear.scale;
}

bool has_light(const ProgramKey& key, std::uint8_t bits) {
  return std::any_of(key.lights.begin(), key.lights.end(),
                     [=](const LightRun& run) { return run.count && run.kind & bits; });
}

/// The lights' directions, or the viewer's, depend on the vertex.
bool reads_position(const ProgramKey& key) {
  return has_light(key, kLightPoint) || key.local_viewer;
}

/// Whether some vector is made unit length in object space that has to be so in eye coordinates.
/// Only half vectors show it.
bool angles_matter(const ProgramKey& key) {
  if (key.quality == Quality::kFastest) return false;
  if (key.quality == Quality::kDefault && key.normal == NormalMode::kNormalize) return false;
  return computes_half_vectors(key);
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

double largest_component(const glm::dvec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// A unit of distance in which the coefficients of attenuation are within float32's range: a power
/// of two, and 1 where they are so anyhow.
double attenuation_unit(double k1, double k2) {
  const auto ordinary = [](double k) { return k == 0 || (k > 1e-30 && k < 1e30); };
  if (ordinary(k1) && ordinary(k2)) return 1;
  const double size = k2 > 0 ? 1 / std::sqrt(k2) : 1 / k1;
  return std::exp2(std::clamp(std::round(std::log2(size)), -120.0, 120.0));
}

/// In multiples of 1/2048, where such steps are not lost on so long a vector.
glm::dvec3 coarse(const glm::dvec3& v) {
  return glm::all(glm::lessThan(glm::abs(v), glm::dvec3(4))) ? glm::floor(v * 2048.0) / 2048.0
                                                             : glm::dvec3(finite(v, 0));
}

constexpr double kBelowOne = 1 - 0x1p-24;  // the largest float below 1

unsigned face_count(const ProgramKey& key) { return key.two_side ? 2 : 1; }

bool back_faces_visible(const Context& context) {
  const PolygonState& polygon = context.raster.polygon;
  return !(polygon.cull_enabled && polygon.cull_face != GL_FRONT);
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

}  // namespace

glm::dmat3 normal_matrix(const Context& context, const LinearPart& linear) {
  if (context.transform.normalize_enabled) return linear.cofactor * linear.determinant_sign;
  if (context.transform.rescale_normal_enabled)
    return linear.inverse_transpose * linear.rescale_factor;
  return linear.inverse_transpose;
}

void Derived::update(Context& context, const VertexLayout& layout, Dialect,
                     const DrawFacts& facts) {
  std::uint32_t dirty = context.dirty & ~std::uint32_t{kDirtyRaster};
  const bool transformed = layout.fields & kFieldTransformed;
  if (transformed != transformed_) dirty |= kDirtyTransform;
  transformed_ = transformed;
  const bool layout_changed = layout != layout_;
  if (dirty & kDirtyTransform) update_transform(context);
  if (choose_reached(context, layout, facts.bounds)) dirty |= kDirtyLights;
  if (choose_normalize(context, facts.unit_normals)) dirty |= kDirtyTransform;
  if (dirty == 0 && !layout_changed) return;
  layout_ = layout;
  context.dirty &= std::uint32_t{kDirtyRaster};

  const ProgramKey before = key;
  const double length_before = normal_length_;
  const bool before_only = directions_only_;
  if (dirty & kDirtyKey || layout_changed) {
    key = ProgramKey{};
    key.textures = before.textures;
    key.lit = context.lighting.enabled;
    key.flat = context.lighting.shade_model == GL_FLAT;
    key.lighting_position = transformed && layout.fields & kFieldLightingPosition;
    key.secondary_from_vertex = (layout.fields & kFieldSecondaryColor) != 0;
    choose_fragments(context, layout);
    if (key.lit) {
      key.two_side = context.lighting.model.two_side && back_faces_visible(context);
      if (context.lighting.model.two_side && !key.two_side) ++context.statistics.back_faces_skipped;
      choose_materials(context, layout);
    }
  }
  if (key.lit) {
    if (dirty & (kDirtyLights | kDirtyMaterial | kDirtyKey) || layout_changed)
      choose_lights(context);
    choose_space(context, layout);
    key.w_is_one = !(layout.fields & (kFieldPositionW | kFieldTransformed));
    key.quality = key.light_count() ? quality_of(context) : Quality::kDefault;
    key.per_fragment = key.light_count() && is_per_fragment(context);
    key.angle_error = key.space == LightingSpace::kObject && !linear_.exact && angles_matter(key);
  }
  const bool space_changed = before.space != key.space || before.normal != key.normal ||
                             before.angle_error != key.angle_error ||
                             before.quality != key.quality || before_only != directions_only_;
  if (dirty & kDirtyTransform || space_changed) fill_transform(context);
  if (dirty & (kDirtyTransform | kDirtyFragments | kDirtyKey)) fill_fragments(context);
  if (key.lit) fill_lighting(context, dirty, before, length_before, before_only);
  update_textures(context, dirty, layout_changed);
}

void Derived::fill_lighting(const Context& context, std::uint32_t dirty, const ProgramKey& before,
                            double length_before, bool before_only) {
  const bool lights_changed = !(before == key) || before_only != directions_only_;
  if (dirty & (kDirtyTransform | kDirtyLights) || lights_changed) fill_lights(context);
  if (dirty & (kDirtyLights | kDirtyMaterial) || lights_changed || length_before != normal_length_)
    fill_faces(context);
  if (dirty & (kDirtyTransform | kDirtyLights) || lights_changed) fill_general(context);
}

void Derived::choose_fragments(const Context& context, const VertexLayout& layout) {
  key.fragments.clip_planes = context.transform.clip.enabled;
  const ColorBufferState& colors = context.raster.color_buffer;
  if (colors.alpha_test_enabled && colors.alpha_function != GL_ALWAYS)
    key.fragments.alpha = static_cast<AlphaFunction>(colors.alpha_function - GL_NEVER +
                                                     static_cast<GLenum>(AlphaFunction::kNever));
  if (!context.fog.enabled) return;
  switch (context.fog.mode) {
    case GL_LINEAR: key.fragments.fog = FogMode::kLinear; break;
    case GL_EXP: key.fragments.fog = FogMode::kExp; break;
    default: key.fragments.fog = FogMode::kExp2;
  }
  key.fragments.fog_coordinate = (layout.fields & kFieldFogCoord) != 0;
}

void Derived::fill_fragments(const Context& context) {
  if (key.fragments.has_fog() || key.fragments.has_alpha_test()) {
    stale[kFragmentsBlock] = true;
    const FogState& fog = context.fog;
    const glm::mat4& modelview = context.transform.modelview.top().single;
    fragments.eye_depth = {modelview[0][2], modelview[1][2], modelview[2][2], modelview[3][2]};
    fragments.fog_color = glm::clamp(fog.color, 0.0f, 1.0f);
    const double range = static_cast<double>(fog.end) - static_cast<double>(fog.start);
    const double density = static_cast<double>(fog.density);
    double x = 0, y = 0;
    switch (key.fragments.fog) {
      case FogMode::kNone: break;
      case FogMode::kLinear:  // where start is end, what the reference takes
        x = range == 0 ? -1 : 1 / range;
        y = static_cast<double>(fog.end) * x;
        break;
      case FogMode::kExp: x = density * std::numbers::log2e; break;
      case FogMode::kExp2: x = density * std::sqrt(std::numbers::log2e); break;
    }
    fragments.fog_parameters = {finite(x), finite(y), 0,
                                context.raster.color_buffer.alpha_reference};
  }
  if (key.fragments.clip_planes) {
    stale[kClipPlanesBlock] = true;
    const glm::dmat4 to_eye = glm::inverse(glm::dmat4(context.transform.projection.top().exact));
    for (unsigned i = 0; i < kMaxClipPlanes; ++i) {
      const glm::dvec4 plane = context.transform.clip.planes_eye[i] * to_eye;
      clip_planes.planes[i] = finite(glm::dvec3(plane), plane.w);
    }
  }
}

const Matrix& Derived::modelview(const Context& context) const {
  static const Matrix identity;
  return transformed_ ? identity : context.transform.modelview.top();
}

void Derived::update_transform(Context& context) {
  const glm::dmat4& matrix = modelview(context).exact;
  affine_ = is_affine(matrix);
  const glm::dmat3 linear(matrix);
  if (linear_known_ && linear == linear_.matrix) return;
  linear_ = analyse(linear);
  linear_known_ = true;
  ++context.statistics.normal_matrix_updates;
}

void Derived::choose_space(const Context& context, const VertexLayout& layout) {
  key.position4 = (layout.fields & kFieldPositionW) != 0;
  directions_only_ =
      !normalizes_ && !reads_position(key) && (linear_.keeps_angles || !is_per_fragment(context));
  // What lights only normals as they are given is a row of object space under any modelview:
  // (normal × inverse) · l = normal · (inverse × l).
  if (directions_only_) {
    key.space = LightingSpace::kObject;
    key.normal = NormalMode::kAsIs;
    normal_length_ = 1;
    return;
  }
  if (!affine_ || key.position4) key.space = LightingSpace::kEyeHomogeneous;
  else key.space = linear_.keeps_angles ? LightingSpace::kObject : LightingSpace::kEyeAxes;

  const bool in_object_space = key.space == LightingSpace::kObject;
  normal_length_ = 1;
  key.normal = NormalMode::kMatrix;
  if (normalizes_) {
    key.normal = NormalMode::kNormalize;
  } else if (context.transform.normalize_enabled) {
    key.normal = NormalMode::kAsIs;  // unit normals, and a modelview that keeps angles
  } else if (in_object_space) {
    // Near 1 the products take the length, and its power for the specular term; farther off that
    // power would leave the range, and the normal is scaled.
    const double length = length_of_unit_normal(context, linear_);
    const bool products_take_it =
        length > 0.8 && length < 1.25 && !shininess_comes_with_vertices(key);
    key.normal = products_take_it ? NormalMode::kAsIs : NormalMode::kScaled;
    if (products_take_it) normal_length_ = length;
  }
}

void Derived::choose_materials(const Context& context, const VertexLayout& layout) {
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

void Derived::choose_lights(Context& context) {
  active_.clear();
  double largest = 0, largest_specular = 0;
  const LightingState& lighting = context.lighting;
  for (unsigned i = 0; i < lighting.lights.size(); ++i) {
    const Light& light = lighting.lights[i];
    if (!light.enabled || !reached_[i]) continue;
    ActiveLight active{i, 0, 1};
    if (is_directional(light)) {
      if (is_spot(light)) active.strength = directional_spot_factor(light);
    } else {
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
    }
    bool ambient = false, diffuse = false, specular = false;
    for (unsigned face = 0; face < face_count(key); ++face) {
      const auto adds = [&](unsigned property, const glm::vec4& color) {
        const glm::dvec3 product =
            rgb(color) * uniform_material(context, key, face, property) * active.strength;
        const double size = largest_component(product);
        largest = std::max(largest, size);
        if (property == kSpecular) largest_specular = std::max(largest_specular, size);
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
      continue;
    }
    active_.push_back(active);
    count_skipped(context.statistics, light, ambient + diffuse + specular);
  }
  std::sort(active_.begin(), active_.end(), by_kind);

  constexpr std::uint8_t kTerms = kLightAmbient | kLightDiffuse | kLightSpecular;
  const auto build_runs = [&] {
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
  };
  if (!build_runs()) {
    for (ActiveLight& light : active_) light.kind = widest_kind(light.kind);
    std::sort(active_.begin(), active_.end(), by_kind);
    build_runs();
  }

  if (!reached_.all()) fill_up_runs();

  for (unsigned face = 0; face < face_count(key); ++face) {
    const Material& material = lighting.materials[face];
    largest = std::max({largest, largest_component(rgb(material.emission)),
                        largest_component(rgb(material.ambient) * rgb(lighting.model.ambient))});
  }
  sum_scale_ = 1;
  if (key.light_count() && largest > kLargestProduct && std::isfinite(largest))
    sum_scale_ = std::exp2(std::ceil(std::log2(largest / kLargestProduct)));
  key.scaled_sums = sum_scale_ != 1;

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

/// Which lights reach the draw; true when that is another set than before.
bool Derived::choose_reached(Context& context, const VertexLayout& layout,
                             const DrawBounds* bounds) {
  LightMask reached = LightMask().set();
  if (bounds && affine_ && !transformed_) {
    reached = reached_lights(context, modelview(context).exact, linear_, layout, *bounds);
    for (std::size_t i = 0; i < context.lighting.lights.size(); ++i)
      if (context.lighting.lights[i].enabled && !reached[i]) ++context.statistics.lights_culled;
  }
  if (reached == reached_) return false;
  reached_ = reached;
  return true;
}

/// Whether normals are made unit length; true when that is another answer than before.
bool Derived::choose_normalize(Context& context, bool unit_normals) {
  bool normalizes = context.transform.normalize_enabled;
  if (normalizes && unit_normals && context.lighting.enabled && !transformed_ && affine_ &&
      linear_.keeps_angles && linear_.exact && !is_precise(context) && !is_per_fragment(context)) {
    normalizes = false;
    ++context.statistics.normalizations_skipped;
  }
  return std::exchange(normalizes_, normalizes) != normalizes;
}

/// Black lights bring the number of each kind to a power of two: how many lights reach a draw
/// chooses among few programs.
void Derived::fill_up_runs() {
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
bool Derived::bakes(unsigned shininess) {
  if (!baked_shininess_.test(shininess) && baked_shininess_.count() < kMostBakedShininesses)
    baked_shininess_.set(shininess);
  return baked_shininess_.test(shininess);
}

void Derived::fill_transform(const Context& context) {
  stale[kTransformBlock] = true;
  const Matrix& matrix = modelview(context);
  transform.modelview_projection =
      transformed_ ? glm::mat4(1.0f) : context.transform.projection.top().single * matrix.single;
  const float size = whole_point_size(context.raster.point);
  transform.point = {size, std::fmod(size, 2.0f) == 0 ? 0.0f : 0.5f, 0, 0};
  const std::array<GLint, 4>& box = context.raster.viewport.box;
  const glm::vec2 half_size(static_cast<float>(box[2]) / 2, static_cast<float>(box[3]) / 2);
  transform.viewport = {
      half_size, glm::vec2(static_cast<float>(box[0]), static_cast<float>(box[1])) + half_size};
  if (!key.lit) return;
  transform.modelview = glm::mat4(matrix.exact);
  const glm::dmat3 normals = normal_matrix(context, linear_);
  for (int column = 0; column < 3; ++column)
    transform.normal_matrix[static_cast<unsigned>(column)] = finite(normals[column], 0);

  glm::dvec3 viewer(0, 0, 1);  // the direction to an infinite viewer
  const glm::dvec3 translation(matrix.exact[3]);
  const bool local = context.lighting.model.local_viewer;
  switch (key.space) {
    case LightingSpace::kObject:
      viewer = local ? linear_.inverse * -translation : linear_.inverse * viewer * linear_.scale;
      break;
    case LightingSpace::kEyeAxes:
      if (local) viewer = -translation;
      break;
    case LightingSpace::kEyeHomogeneous:
      if (local) viewer = glm::dvec3(0);
      break;
  }
  const double normal_scale = length_of_unit_normal(context, linear_);
  transform.viewer = finite(viewer, normal_scale);
  if (key.quality == Quality::kPrecise) {
    stale[kPreciseBlock] = true;
    for (int column = 0; column < 4; ++column)
      precise.modelview[column] = low(glm::dvec3(matrix.exact[column]), matrix.exact[column].w);
    for (int column = 0; column < 3; ++column)
      precise.normal_matrix[static_cast<unsigned>(column)] = low(normals[column], 0);
    precise.viewer = low(viewer, normal_scale);
  }
  for (int column = 0; column < 3; ++column)
    transform.angle_error[static_cast<unsigned>(column)] = finite(linear_.angle_error[column], 0);
}

void Derived::fill_lights(const Context& context) {
  stale[kLightsBlock] = true;
  stale[kPreciseBlock] = true;
  lights.clear();
  lights_low.clear();
  const glm::dvec3 translation(modelview(context).exact[3]);
  const bool in_object_space = key.space == LightingSpace::kObject;
  const double scale = in_object_space ? linear_.scale : 1;
  const glm::dmat3 rotation = in_object_space ? linear_.inverse * linear_.scale : glm::dmat3(1.0);
  // Vectors that meet the normal as it is given.
  double factor = context.transform.rescale_normal_enabled ? linear_.rescale_factor : 1.0;
  if (context.transform.normalize_enabled) factor = linear_.scale;
  const glm::dmat3 covariant = directions_only_ ? linear_.inverse * factor : rotation;
  const glm::dvec3 origin =
      key.space == LightingSpace::kEyeHomogeneous ? glm::dvec3(0) : translation;

  for (const ActiveLight& active : active_) {
    if (!(active.kind & (kLightAmbient | kLightDiffuse | kLightSpecular))) continue;
    const Light& light = context.lighting.lights[active.index];
    LightUniforms uniforms;
    LightLow uniforms_low;
    const glm::dvec3 position(light.position_eye);
    if (is_directional(light)) {
      const glm::dvec3 to_light = unit(position);
      const glm::dvec3 direction = covariant * to_light;
      const bool split = key.quality == Quality::kPrecise;
      uniforms.position = finite(split ? coarse(direction) : direction, 0);
      uniforms_low.position = rest_of(glm::dvec4(direction, 0), uniforms.position);
      // A normal made unit length in object space meets a half vector that is so too.
      glm::dvec3 half_vector = covariant * unit(to_light + glm::dvec3(0, 0, 1));
      if (key.normal == NormalMode::kNormalize ||
          (key.quality == Quality::kDefault && !splits_half_vectors(key)))
        half_vector = unit(half_vector);
      uniforms.half_vector =
          finite(splits_half_vectors(key) ? coarse(half_vector) : half_vector, 0);
      uniforms.attenuation = finite(half_vector - glm::dvec3(uniforms.half_vector), 0);
    } else {
      const glm::dvec3 point = rotation * (position / light.position_eye.w - origin) / scale;
      uniforms.position = finite(point, 1);
      uniforms_low.position = low(point, 1);
      const double k0 = static_cast<double>(light.constant_attenuation);
      const double k1 = static_cast<double>(light.linear_attenuation) * scale;
      const double k2 = static_cast<double>(light.quadratic_attenuation) * scale * scale;
      const double unit_of_distance = attenuation_unit(k1, k2);
      uniforms.half_vector.w = static_cast<float>(1 / unit_of_distance);
      uniforms.attenuation =
          finite(glm::dvec3(k0, k1 * unit_of_distance, k2 * unit_of_distance * unit_of_distance),
                 static_cast<double>(light.spot_exponent));
      // A light whose constant attenuation is folded meets the widest kind with attenuation 1.
      if (k1 == 0 && k2 == 0) uniforms.attenuation = {1, 0, 0, light.spot_exponent};
      if (is_spot(light)) {
        const double half_cutoff =
            static_cast<double>(light.spot_cutoff_degrees) * (std::numbers::pi / 360);
        // Vertices on the cone are lit: the bound leaves room for the rounding of the chord, and
        // for that of two unit vectors that are opposite.
        double limit =
            std::max(2 * std::sin(half_cutoff) * std::sin(half_cutoff) * (1 + 3e-7), 1e-13);
        // Where the cosine is 0 its power is too, and has no logarithm.
        if (light.spot_exponent > 0) limit = std::min(limit, kBelowOne);
        const glm::dvec3 axis = rotation * unit(light.spot_direction_eye);
        uniforms.spot_direction = finite(axis, limit);
        uniforms_low.spot_direction = low(axis, limit);
      } else {
        uniforms.spot_direction = {0, 0, 0, 4};
        uniforms.attenuation.w = 0;
      }
    }
    lights.push_back(uniforms);
    if (key.quality == Quality::kPrecise) lights_low.push_back(uniforms_low);
  }
}

void Derived::fill_faces(const Context& context) {
  for (unsigned face = 0; face < face_count(key); ++face) {
    stale[kFrontBlock + face] = true;
    FaceUniforms& uniforms = faces[face];
    uniforms.products.clear();
    glm::dvec3 ambient_light = rgb(context.lighting.model.ambient);
    for (const ActiveLight& active : active_) {
      const Light& light = context.lighting.lights[active.index];
      if (active.black) {
        uniforms.products.emplace_back();
        uniforms.products.back().diffuse.w = static_cast<float>(sum_scale_);
        continue;
      }
      if (folds_into_scene(active.kind)) ambient_light += rgb(light.ambient) * active.strength;
      if (!(active.kind & (kLightAmbient | kLightDiffuse | kLightSpecular))) continue;
      const auto product = [&](unsigned property, const glm::vec4& color, double factor) {
        return rgb(color) * uniform_material(context, key, face, property) * active.strength *
               (factor / sum_scale_);
      };
      const double shine_of_length =
          std::pow(normal_length_, static_cast<double>(context.lighting.materials[face].shininess));
      const glm::dvec3 diffuse = product(kDiffuse, light.diffuse, normal_length_);
      glm::vec4 ambient(0);
      if (active.kind & kLightAmbient) ambient = finite(product(kAmbient, light.ambient, 1), 0);
      else if (key.quality == Quality::kPrecise) ambient = low(diffuse, 0);
      uniforms.products.push_back({ambient, finite(diffuse, sum_scale_),
                                   finite(product(kSpecular, light.specular, shine_of_length), 0)});
    }
    const Material& material = context.lighting.materials[face];
    glm::dvec3 scene(0);
    if (key.material[face][kAmbient] == MaterialSource::kUniform)
      scene += ambient_light * rgb(material.ambient);
    if (key.material[face][kEmission] == MaterialSource::kUniform) scene += rgb(material.emission);
    uniforms.head.scene =
        finite(scene / sum_scale_, std::clamp(static_cast<double>(material.diffuse.a), 0.0, 1.0));
    uniforms.head.ambient_light = finite(ambient_light, static_cast<double>(material.shininess));
  }
}

/// From the values of the other blocks, which are filled.
void Derived::fill_general(const Context& context) {
  stale[kGeneralBlock] = true;
  general = {};
  if (key.space != LightingSpace::kObject) general.lighting_matrix = transform.modelview;
  if (key.space == LightingSpace::kEyeAxes) general.lighting_matrix[3] = {0, 0, 0, 1};
  const bool by_matrix =
      key.normal == NormalMode::kMatrix ||
      (key.normal == NormalMode::kNormalize && key.space != LightingSpace::kObject);
  const float scale = key.normal == NormalMode::kScaled ? transform.viewer.w : 1.0f;
  for (unsigned i = 0; i < 3; ++i) {
    general.normal_matrix[i][static_cast<int>(i)] = scale;
    if (by_matrix) general.normal_matrix[i] = transform.normal_matrix[i];
  }
  for (const ActiveLight& active : active_) {
    if (!(active.kind & (kLightAmbient | kLightDiffuse | kLightSpecular))) continue;
    ++general.light_ends.z;
    if (!(active.kind & kLightPoint)) ++general.light_ends.x;
    if (!(active.kind & kLightSpot)) ++general.light_ends.y;
  }
  general.modes = {key.normal == NormalMode::kNormalize, context.lighting.model.local_viewer, 0, 0};
}

}  // namespace legacy_gl
