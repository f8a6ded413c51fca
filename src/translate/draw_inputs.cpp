#include "translate/draw_inputs.hpp"

#include <glm/gtc/matrix_access.hpp>
#include <utility>

#include "translate/draw_inputs_parts.hpp"

namespace legacy_gl {

namespace {

bool shininess_comes_with_vertices(const ProgramKey& key) {
  return key.material[kFront][kShininess] == MaterialSource::kVertex ||
         key.material[kBack][kShininess] == MaterialSource::kVertex;
}

/// How long a unit normal is after the normal matrix and GL_RESCALE_NORMAL, under a modelview that
/// keeps angles.
double length_of_unit_normal(const Context& context, const LinearPart& linear) {
  return (context.transform.rescale_normal_enabled ? linear.rescale_factor : 1.0) / linear.scale;
}

/// Whether some vector is made unit length in object space that has to be so in eye coordinates.
/// Only half vectors show it.
bool angles_matter(const ProgramKey& key) {
  if (key.quality == Quality::kFastest) return false;
  if (key.quality == Quality::kDefault && key.normal == NormalMode::kNormalize) return false;
  return computes_half_vectors(key);
}

bool back_faces_visible(const Context& context) {
  const PolygonState& polygon = context.raster.polygon;
  return !(polygon.cull_enabled && polygon.cull_face != GL_FRONT);
}

}  // namespace

glm::dmat3 normal_matrix(const Context& context, const LinearPart& linear) {
  if (context.transform.normalize_enabled) return linear.cofactor * linear.determinant_sign;
  if (context.transform.rescale_normal_enabled)
    return linear.inverse_transpose * linear.rescale_factor;
  return linear.inverse_transpose;
}

void DrawInputs::update(Context& context, const VertexLayout& layout, const DrawFacts& facts) {
  std::uint32_t dirty = context.dirty & ~std::uint32_t{kDirtyRaster};
  const bool transformed = layout.fields & kFieldTransformed;
  if (transformed != transformed_) dirty |= kDirtyTransform;
  transformed_ = transformed;
  const bool layout_changed = layout != layout_;
  if (dirty & kDirtyTransform) update_transform(context);
  if (dirty & kDirtyLights) find_eye_directions(context);
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
    key.lit = context.lighting.enabled && !(layout.fields & kFieldShaded);
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
    key.parallel = key.w_is_one && parallel_;
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

void DrawInputs::fill_lighting(const Context& context, std::uint32_t dirty,
                               const ProgramKey& before, double length_before, bool before_only) {
  const bool lights_changed = !(before == key) || before_only != directions_only_;
  if (dirty & (kDirtyTransform | kDirtyLights) || lights_changed) fill_lights(context);
  if (dirty & (kDirtyLights | kDirtyMaterial) || lights_changed || length_before != normal_length_)
    fill_faces(context);
  if (dirty & (kDirtyTransform | kDirtyLights) || lights_changed) stale[kGeneralBlock] = true;
}

const Matrix& DrawInputs::modelview(const Context& context) const {
  static const Matrix identity;
  return transformed_ ? identity : context.transform.modelview.top();
}

void DrawInputs::update_transform(Context& context) {
  const glm::mat4 clip = context.transform.projection.top().single * modelview(context).single;
  transform.modelview_projection = transformed_ ? glm::mat4(1.0f) : clip;
  parallel_ = glm::row(transform.modelview_projection, 3) == glm::vec4(0, 0, 0, 1);
  const glm::dmat4& matrix = modelview(context).exact;
  affine_ = is_affine(matrix);
  const glm::dmat3 linear(matrix);
  if (linear_known_ && linear == linear_.matrix) return;
  linear_ = analyse(linear);
  linear_known_ = true;
  ++context.statistics.normal_matrix_updates;
}

void DrawInputs::choose_space(const Context& context, const VertexLayout& layout) {
  key.position4 = (layout.fields & kFieldPositionW) != 0;
  directions_only_ = !normalizes_ && !lighting_reads_position(key) &&
                     (linear_.keeps_angles || !is_per_fragment(context));
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

/// Which lights reach the draw; true when that is another set than before.
bool DrawInputs::choose_reached(Context& context, const VertexLayout& layout,
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
bool DrawInputs::choose_normalize(Context& context, bool unit_normals) {
  bool normalizes = context.transform.normalize_enabled;
  if (normalizes && unit_normals && context.lighting.enabled && !transformed_ && affine_ &&
      linear_.keeps_angles && linear_.exact && !is_precise(context) && !is_per_fragment(context)) {
    normalizes = false;
    ++context.statistics.normalizations_skipped;
  }
  return std::exchange(normalizes_, normalizes) != normalizes;
}

void DrawInputs::fill_transform(const Context& context) {
  stale[kTransformBlock] = true;
  const Matrix& matrix = modelview(context);
  const float size = drawn_point_size(context.raster.point);
  const PointState& point = context.raster.point;
  stale[kPointsBlock] = true;
  points = {matrix.single,
            {point.size, point.size_min, point.size_max, point.fade_threshold},
            glm::vec4(point.attenuation, 0)};
  transform.point = {size, std::fmod(size, 2.0f) == 0 ? 0.0f : 0.5f, 0, size + 1};
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
  const glm::dmat3& error = linear_.angle_error;
  transform.angle_error_half = finite(0.5 * glm::dvec3(error[0][0], error[1][1], error[2][2]), 0);
  transform.angle_error_mixed = finite(glm::dvec3(error[2][1], error[2][0], error[1][0]), 0);
}

}  // namespace legacy_gl
