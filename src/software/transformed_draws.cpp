// Small objects, each under a modelview matrix of its own, in one batch: their vertices are
// transformed here, since a draw call for each would cost more than that.
#include <array>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "geometry/float4.hpp"
#include "record/current_normal.hpp"
#include "record/pending.hpp"
#include "software/software_fast_path.hpp"
#include "submit/batch.hpp"
#include "submit/prepare.hpp"

namespace legacy_gl {

namespace {

/// Only what is known here may choose the program: whatever else reads object or eye coordinates
/// makes a key that differs, and its objects are drawn one by one.
bool reads_nothing_else(const ProgramKey& key) {
  ProgramKey rest = key;
  rest.lit = rest.flat = rest.secondary_from_vertex = rest.two_side = rest.local_viewer = false;
  rest.separate_specular = rest.angle_error = rest.lighting_position = false;
  rest.w_is_one = rest.parallel = false;
  if (rest.quality == Quality::kFastest) rest.quality = Quality::kDefault;
  rest.space = {};
  rest.normal = {};
  rest.material = {};
  rest.vertex_materials = 0;
  rest.integer_shininess = {};
  rest.lights = {};
  return rest == ProgramKey{};
}

/// Eye coordinates as large as this would cost positional light its digits.
constexpr double kFarFromEye = 1e3;

}  // namespace

bool SoftwareFastPath::can_transform(Context& context) {
  Submission& submission = *context.submission;
  const Recorder& recorder = context.recorder;
  constexpr unsigned kKnownFields = kFieldNormal | kFieldColor | kFieldSecondaryColor |
                                    kFieldTransformed | kFieldLightingPosition;
  if (recorder.layout().fields & ~kKnownFields) return false;
  if (recorder.layout().fields & kFieldTransformed) return true;
  if (!context.paths.cpu_transform || is_stippled(context.raster.line)) return false;
  if (context.raster.point.is_attenuated()) return false;  // by eye coordinates
  if (culls_lights(context)) return false;                 // each object has lights of its own
  update_inputs(context, recorder.layout());
  return reads_nothing_else(submission.inputs.key);
}

namespace {

/// What the modelview and the projection do to a vertex.
struct VertexTransform {
  Columns clip, eye, normal;
};

/// The matrix of normals without the analysis that lighting in object space needs.
glm::dmat3 plain_normal_matrix(const Context& context, const glm::dmat3& m) {
  const glm::dmat3 cofactor(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
  const double determinant = glm::dot(m[0], cofactor[0]);
  constexpr double kSafe = 1e-60;  // nothing under- or overflows
  if (context.transform.normalize_enabled || context.transform.rescale_normal_enabled ||
      !(std::abs(determinant) > kSafe && std::abs(determinant) < 1 / kSafe))
    return normal_matrix(context, analyse(m));
  return cofactor * (1 / determinant);
}

VertexTransform vertex_transform(const Context& context, bool needed, bool normals) {
  VertexTransform t;
  t.normal = columns(glm::mat4(1.0f));
  if (!needed) return t;
  const Matrix& modelview = context.transform.modelview.top();
  t.clip = columns(context.transform.projection.top().single * modelview.single);
  t.eye = columns(glm::mat4(modelview.exact));
  if (normals)
    t.normal =
        columns(glm::mat4(glm::mat3(plain_normal_matrix(context, glm::dmat3(modelview.exact)))));
  return t;
}

void put_eye_position(float* to, const Float4& eye) {
  store(to, eye / Float4{eye[3], eye[3], eye[3], eye[3]});
}

}  // namespace

void SoftwareFastPath::transform_vertices(Context& context) {
  Recorder& recorder = context.recorder;
  const VertexOffsets& offsets = recorder.offsets();
  const std::uint16_t fields = recorder.layout().fields;
  const std::uint32_t first = recorder.first_untransformed(), end = recorder.vertex_count();
  if (first == end) return;
  enlarge_recorded_normals(context, first);
  const VertexTransform t = vertex_transform(context, true, fields & kFieldNormal);
  ClipFlags flags;
  float* vertex = recorder.data() + std::size_t{first} * offsets.stride;
  for (std::uint32_t i = first; i < end; ++i, vertex += offsets.stride) {
    if (fields & kFieldLightingPosition)
      put_eye_position(vertex + offsets.lighting_position,
                       product(t.eye, vertex[0], vertex[1], vertex[2], vertex[3]));
    const Float4 clip = product(t.clip, vertex[0], vertex[1], vertex[2], vertex[3]);
    flags.add(clip);
    store(vertex, clip);
    if (!(fields & kFieldNormal)) continue;
    float* const n = vertex + offsets.normal;
    const Float4 normal = product(t.normal, n[0], n[1], n[2], 0);
    for (int c = 0; c < 3; ++c) n[c] = normal[c];
  }
  recorder.set_all_transformed();
  recorder.end_small_draw(flags.crosses());
}

/// The batch becomes one of transformed objects, if it is not one already.
bool SoftwareFastPath::begin_transformed(Context& context) {
  Submission& submission = *context.submission;
  Recorder& recorder = context.recorder;
  if (!can_transform(context)) return false;
  const Matrix& modelview = context.transform.modelview.top();
  const bool lit_by_position =
      context.lighting.enabled && lighting_reads_position(submission.inputs.key);
  if (!is_affine(modelview.exact)) return false;
  if (lit_by_position)
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(modelview.exact[3][axis]) < kFarFromEye)) return false;
  recorder.add_fields(context,
                      static_cast<std::uint16_t>(kFieldTransformed |
                                                 (lit_by_position ? kFieldLightingPosition : 0)));
  return true;
}

bool SoftwareFastPath::detach_from_matrices(Context& context) {
  Recorder& recorder = context.recorder;
  if (recorder.inside_begin_end()) return true;  // the change is refused
  if (recorder.layout().fields & kFieldTransformed &&
      recorder.first_untransformed() == recorder.vertex_count())
    return true;
  if (!recorder.small_draw_may_end() || !begin_transformed(context)) return false;
  transform_vertices(context);
  return true;
}

bool SoftwareFastPath::append_mesh(Context& context, const ListMesh& mesh) {
  Recorder& recorder = context.recorder;
  constexpr unsigned kCopied = kFieldNormal | kFieldColor | kFieldSecondaryColor;
  if (append_shaded_mesh(context, mesh)) return true;
  if (mesh.layout.fields & ~kCopied || mesh.layout.materials || mesh.layout.texcoords) return false;
  if (mesh.triangles.empty() || !recorder.joins_small_draws(context)) return false;
  const std::uint32_t count = mesh.vertex_count();
  float* const vertices = recorder.append_vertices(context, count, false);
  const std::uint32_t base = recorder.vertex_count() - count;
  const VertexOffsets to = recorder.offsets(), from = offsets_of(mesh.layout);
  const std::uint16_t fields = recorder.layout().fields;
  const bool transform = fields & kFieldTransformed && recorder.first_untransformed() == base;
  const auto both = static_cast<std::uint16_t>(fields & mesh.layout.fields);

  std::array<float, kMaxVertexFloats + Recorder::kSlackFloats> current{};
  recorder.put_template(context, current.data());
  const glm::vec3 normal = normal_to_draw(context);
  if (fields & kFieldNormal) std::memcpy(&current[to.normal], &normal[0], sizeof normal);
  VertexTransform t = vertex_transform(context, transform, fields & kFieldNormal);
  ClipFlags flags;
  // Behind the position comes the normal, then what the current values fill.
  const unsigned rest = to.position_size + (fields & kFieldNormal ? 3 : 0);
  const bool own_normals = both & kFieldNormal;
  const float* p = mesh.vertices.data();
  float* vertex = vertices;
  for (std::uint32_t i = 0; i < count; ++i, p += from.stride, vertex += to.stride) {
    const Float4 position{p[0], p[1], p[2], 1};
    const Float4 clip = transform ? product(t.clip, p[0], p[1], p[2], 1) : position;
    flags.add(clip);
    // Whole fours, in the order of the fields: what is too much is overwritten by the next.
    store(vertex, clip);
    if (fields & kFieldNormal) {
      const float* const n = own_normals ? p + from.normal : &current[to.normal];
      store(vertex + to.normal, t.normal.c[0] * n[0] + t.normal.c[1] * n[1] + t.normal.c[2] * n[2]);
    }
    for (unsigned at = rest; at < to.stride; at += 4) store(vertex + at, load(&current[at]));
    if (both & kFieldColor) std::memcpy(vertex + to.color, p + from.color, 4 * sizeof(float));
    if (both & kFieldSecondaryColor)
      std::memcpy(vertex + to.secondary_color, p + from.secondary_color, 3 * sizeof(float));
    if (transform && fields & kFieldLightingPosition)
      put_eye_position(vertex + to.lighting_position, product(t.eye, p[0], p[1], p[2], 1));
  }
  if (transform && flags.outside()) {
    ++context.statistics.primitives_clipped;
    recorder.drop_vertices(count);
    return true;
  }
  const std::vector<std::uint32_t>& triangles = mesh.triangles;
  std::uint32_t* const elements =
      recorder.append_elements(context, GL_TRIANGLES, static_cast<std::uint32_t>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i) elements[i] = base + triangles[i];
  if (transform) {
    recorder.set_all_transformed();
    recorder.end_small_draw(flags.crosses());
  }
  recorder.flush_if_large(context);
  return true;
}

}  // namespace legacy_gl
