#include "dlist/list_arrays.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <optional>
#include <vector>

#include "dlist/list_state.hpp"
#include "geometry/list_mesh.hpp"
#include "geometry/primitives.hpp"
#include "record/array_gather.hpp"
#include "record/pending.hpp"

namespace legacy_gl {

namespace {

/// The head of a list command; floats of `vertex_count` vertices follow, then `element_count`
/// indices.
struct RecordedArrays {
  GLenum mode;
  std::uint32_t vertex_count;
  std::uint32_t element_count;                  ///< 0: the vertices as they come
  std::uint32_t stride;                         ///< in floats
  std::array<std::uint8_t, kArrayCount> sizes;  ///< in floats; 0: the array was not enabled
};

std::size_t vertex_bytes(const RecordedArrays& head) {
  return std::size_t{head.vertex_count} * head.stride * sizeof(float);
}

void play_arrays(Context& context, const void* payload) {
  if (context.recorder.inside_begin_end()) return raise_error(context, GL_INVALID_OPERATION);
  RecordedArrays head;
  std::memcpy(&head, payload, sizeof head);
  const std::byte* const vertices = static_cast<const std::byte*>(payload) + sizeof head;
  ArrayViews views;
  std::size_t offset = 0;
  for (unsigned i = 0; i < kArrayCount; ++i) {
    if (!head.sizes[i]) continue;
    views[i].data = vertices + offset;
    views[i].stride = head.stride * sizeof(float);
    views[i].size = head.sizes[i];
    offset += head.sizes[i] * sizeof(float);
  }
  if (head.element_count)
    submit_elements(context, views, head.mode,
                    {vertices + vertex_bytes(head), GL_UNSIGNED_INT, head.element_count});
  else submit_arrays(context, views, head.mode, 0, head.vertex_count);
}

RecordedArrays make_head(const ArrayViews& views, GLenum mode, std::uint32_t vertex_count,
                         std::uint32_t element_count) {
  RecordedArrays head{mode, vertex_count, element_count, 0, {}};
  for (unsigned i = 0; i < kArrayCount; ++i) {
    if (!views[i].data) continue;
    head.sizes[i] = static_cast<std::uint8_t>(views[i].size);
    head.stride += views[i].size;
  }
  return head;
}

/// Appends the command with room for its data, which the caller fills.
std::byte* append(Context& context, const RecordedArrays& head) {
  void* const payload = context.lists.append(
      &play_arrays, sizeof head + vertex_bytes(head) + head.element_count * sizeof(std::uint32_t));
  std::memcpy(payload, &head, sizeof head);
  return static_cast<std::byte*>(payload) + sizeof head;
}

void copy_vertices(const ArrayViews& views, const RecordedArrays& head, std::uint32_t first,
                   std::uint32_t count, float* to) {
  for (unsigned i = 0; i < kArrayCount; ++i) {
    if (!head.sizes[i]) continue;
    const ArrayView& view = views[i];
    view.read(find_reader(view.type, is_normalised(i), view.size, view.size), first, count, to,
              head.stride, view.size);
    to += view.size;
  }
}

/// Fewer vertices are played into the recorder, where neighbouring draws of one state join.
constexpr std::uint32_t kMeshVertices = 32;

/// The fields of a mesh that holds all that the arrays say; nothing when a mesh cannot.
std::optional<VertexLayout> mesh_layout(const ArrayViews& views, const ElementRange& range) {
  if (range.highest - range.lowest < kMeshVertices) return {};
  if (has_other_w(views[kVertexArray], range.lowest, range.highest - range.lowest + 1)) return {};
  VertexLayout layout;
  for (unsigned i = 0; i < kArrayCount; ++i) {
    if (!views[i].data) continue;
    switch (i) {
      case kVertexArray: break;
      case kNormalArray: layout.fields |= kFieldNormal; break;
      case kColorArray: layout.fields |= kFieldColor; break;
      case kSecondaryColorArray: layout.fields |= kFieldSecondaryColor; break;
      case kFogCoordArray: layout.fields |= kFieldFogCoord; break;
      default:
        if (i < kTexCoordArray) return {};
        layout.texcoords |= static_cast<std::uint8_t>(1u << (i - kTexCoordArray));
    }
  }
  layout.wide_texcoords = wide_texcoord_arrays(views);
  return layout;
}

/// A mesh of the vertices of `range`, drawn as they come, or those that `elements` names of them.
void record_mesh(Context& context, const ArrayViews& views, const VertexLayout& layout, GLenum mode,
                 const ElementRange& range, std::vector<std::uint32_t> elements) {
  const auto mesh = std::make_shared<ListMesh>();
  mesh->layout = layout;
  const std::uint32_t vertex_count = range.highest - range.lowest + 1;
  mesh->vertices.resize(std::size_t{vertex_count} * offsets_of(layout).stride);
  ArrayGather(context, views, layout)(range.lowest, vertex_count, mesh->vertices.data());
  const bool indexed = !elements.empty() || !draws_without_indices(mode);
  const std::uint32_t count =
      elements.empty() ? vertex_count : static_cast<std::uint32_t>(elements.size());
  if (indexed && elements.empty()) {
    elements.resize(count);
    std::iota(elements.begin(), elements.end(), 0u);
  }
  mesh->elements = std::move(elements);
  mesh->runs.push_back({mode, 0, count, indexed});
  if (indexed) {
    append_indices(mesh->runs[0], mesh->elements, 0, true, mesh->indices);
    mesh->draws.push_back(
        {core_mode(mode), true, 0, static_cast<std::uint32_t>(mesh->indices.size())});
  } else {
    mesh->firsts.push_back(0);
    mesh->counts.push_back(static_cast<GLsizei>(count));
    mesh->draws.push_back({mode, false, 0, 1});
  }
  context.lists.compiling_list->append_mesh(mesh);
}

}  // namespace

void record_arrays(Context& context, const ArrayViews& views, GLenum mode, std::uint32_t first,
                   std::uint32_t count) {
  if (context.lists.failed) return;
  const ArrayView& positions = views[kVertexArray];
  if (!positions.data || first >= positions.readable) return;
  count = whole_primitives(mode, std::min(count, positions.readable - first));
  if (count == 0) return;
  const ElementRange range{first, first + count - 1};
  if (const auto layout = mesh_layout(views, range))
    return record_mesh(context, views, *layout, mode, range, {});
  const RecordedArrays head = make_head(views, mode, count, 0);
  copy_vertices(views, head, first, count, reinterpret_cast<float*>(append(context, head)));
}

void record_elements(Context& context, const ArrayViews& views, GLenum mode,
                     const ElementView& elements) {
  if (context.lists.failed) return;
  const std::uint32_t count = whole_primitives(mode, elements.count);
  if (count == 0 || !views[kVertexArray].data) return;
  std::vector<std::uint32_t> indices;
  read_elements({elements.data, elements.type, count}, indices);
  const ElementRange range = element_range({elements.data, elements.type, count});
  const bool shared = worth_indexing(range, count) && range.highest < views[kVertexArray].readable;
  if (shared) {
    for (std::uint32_t& index : indices) index -= range.lowest;
    if (const auto layout = mesh_layout(views, range))
      return record_mesh(context, views, *layout, mode, range, std::move(indices));
  }
  const std::uint32_t vertex_count = shared ? range.highest - range.lowest + 1 : count;
  const RecordedArrays head = make_head(views, mode, vertex_count, shared ? count : 0);
  std::byte* const data = append(context, head);
  float* const vertices = reinterpret_cast<float*>(data);
  if (!shared) {
    for (std::uint32_t i = 0; i < count; ++i)
      copy_vertices(views, head, indices[i], 1, vertices + std::size_t{i} * head.stride);
    return;
  }
  copy_vertices(views, head, range.lowest, vertex_count, vertices);
  std::memcpy(data + vertex_bytes(head), indices.data(), count * sizeof(std::uint32_t));
}

}  // namespace legacy_gl
