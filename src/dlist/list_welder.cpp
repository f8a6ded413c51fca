#include "dlist/list_welder.hpp"

#include <cstring>
#include <string_view>

#include "dlist/dispatch.hpp"
#include "dlist/display_list.hpp"
#include "execute/attributes.hpp"
#include "execute/begin_end.hpp"
#include "geometry/primitives.hpp"

namespace legacy_gl {

namespace {

constexpr PlayFunction kBegin = &play<execute::begin, GLenum>;
constexpr PlayFunction kEnd = &play<execute::end>;
constexpr PlayFunction kVertex3 = &play<execute::vertex3, float, float, float>;
constexpr PlayFunction kVertex4 = &play<execute::vertex4, float, float, float, float>;
constexpr PlayFunction kNormal3 = &play<execute::normal3, float, float, float>;
constexpr PlayFunction kColor4 = &play<execute::color4, float, float, float, float>;
constexpr PlayFunction kSecondary3 = &play<execute::secondary_color3, float, float, float>;
constexpr PlayFunction kFogCoordinate = &play<execute::fog_coord, float>;
constexpr PlayFunction kTexcoord4 = &play<execute::texcoord4, unsigned, float, float, float, float>;

using Values = std::array<float, 4>;

unsigned texture_unit(const void* payload) {
  return std::get<0>(
      *static_cast<const std::tuple<unsigned, float, float, float, float>*>(payload));
}

Values coordinates(const void* payload) {
  const auto& [unit, s, t, r, q] =
      *static_cast<const std::tuple<unsigned, float, float, float, float>*>(payload);
  return {s, t, r, q};
}

Values three(const void* payload) {
  const auto& [x, y, z] = *static_cast<const std::tuple<float, float, float>*>(payload);
  return {x, y, z, 1};
}

Values one(const void* payload) {
  return {std::get<0>(*static_cast<const std::tuple<float>*>(payload)), 0, 0, 1};
}

Values four(const void* payload) {
  const auto& [x, y, z, w] = *static_cast<const std::tuple<float, float, float, float>*>(payload);
  return {x, y, z, w};
}

/// Where the attributes between `begin` and `end` were set last, each once: they stay as the
/// current values.
std::vector<std::size_t> last_of_each_attribute(const DisplayList& list, std::size_t begin,
                                                std::size_t end) {
  std::vector<std::size_t> last;
  const auto same_attribute = [&](std::size_t a, std::size_t b) {
    const DisplayList::Command x = list.at(a), y = list.at(b);
    if (x.play != y.play) return false;
    return x.play != kTexcoord4 || texture_unit(x.payload) == texture_unit(y.payload);
  };
  for (std::size_t at = begin, next; at < end; at = next) {
    const DisplayList::Command command = list.at(at);
    next = command.next;
    if (command.play == kBegin || command.play == kEnd || command.play == kVertex3 ||
        command.play == kVertex4)
      continue;
    std::erase_if(last, [&](std::size_t earlier) { return same_attribute(earlier, at); });
    last.push_back(at);
  }
  return last;
}

unsigned attribute_size(const VertexLayout& layout, unsigned attribute) {
  static constexpr unsigned kSizes[] = {3, 4, 3, 1};
  constexpr unsigned kTexcoords = std::size(kSizes);
  return attribute < kTexcoords ? kSizes[attribute] : texcoord_size(layout, attribute - kTexcoords);
}

/// Two floats do not say all of it.
bool is_wide(const Values& coordinates) { return coordinates[2] != 0 || coordinates[3] != 1; }

bool keeps_own_order(GLenum mode) { return mode != GL_TRIANGLES && draws_without_indices(mode); }

}  // namespace

/// Walks over what came between the last primitive and the next Begin, and finds that.
void ListWelder::read_between(const DisplayList& list, std::size_t end, std::size_t& begin) {
  for (std::size_t at = scanned_; at < end;) {
    const DisplayList::Command command = list.at(at);
    if (command.play == kBegin) {
      begin = at;
      return;
    }
    if (command.play == kNormal3) known_[kNormal] = three(command.payload);
    else if (command.play == kColor4) known_[kColor] = four(command.payload);
    else if (command.play == kSecondary3) known_[kSecondaryColor] = three(command.payload);
    else if (command.play == kFogCoordinate) known_[kFogCoord] = one(command.payload);
    else if (command.play == kTexcoord4)
      known_[kTexcoord + texture_unit(command.payload)] = coordinates(command.payload);
    else {
      // Another list, an attribute group or an array may change current values; anything may change
      // the state.
      known_ = {};
      open_mesh_ = nullptr;
    }
    at = command.next;
  }
  begin = end;
}

bool ListWelder::has(const VertexLayout& layout, unsigned attribute) {
  switch (attribute) {
    case kNormal: return layout.fields & kFieldNormal;
    case kColor: return layout.fields & kFieldColor;
    case kSecondaryColor: return layout.fields & kFieldSecondaryColor;
    case kFogCoord: return layout.fields & kFieldFogCoord;
    default: return layout.texcoords & 1u << (attribute - kTexcoord);
  }
}

/// The attributes whose values the first vertex finds known.
void ListWelder::take_known(VertexLayout& layout) const {
  if (known_[kNormal]) layout.fields |= kFieldNormal;
  if (known_[kColor]) layout.fields |= kFieldColor;
  if (known_[kSecondaryColor]) layout.fields |= kFieldSecondaryColor;
  if (known_[kFogCoord]) layout.fields |= kFieldFogCoord;
  for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit) {
    const Known& known = known_[kTexcoord + unit];
    if (!known) continue;
    layout.texcoords |= static_cast<std::uint8_t>(1u << unit);
    if (is_wide(*known)) layout.wide_texcoords |= static_cast<std::uint8_t>(1u << unit);
  }
}

bool ListWelder::read_primitive(const DisplayList& list, std::size_t begin, Primitive& primitive) {
  DisplayList::Command command = list.at(begin);
  primitive.mode = std::get<0>(*static_cast<const std::tuple<GLenum>*>(command.payload));
  if (primitive.mode > GL_POLYGON) return false;
  bool has_vertices = false;
  for (std::size_t at = command.next; at < list.size(); at = command.next) {
    command = list.at(at);
    if (command.play == kEnd) return true;
    const auto set = [&](unsigned attribute, const Values& values) {
      // A value that the vertices before it do not share, and the call alone will know.
      if (has_vertices && !has(primitive.layout, attribute)) return false;
      if (attribute >= kTexcoord && is_wide(values)) {
        const auto unit = static_cast<std::uint8_t>(1u << (attribute - kTexcoord));
        if (has_vertices && !(primitive.layout.wide_texcoords & unit)) return false;
      }
      known_[attribute] = values;
      return true;
    };
    if (command.play == kVertex3 || command.play == kVertex4) {
      const Values position =
          command.play == kVertex3 ? three(command.payload) : four(command.payload);
      if (position[3] != 1) return false;
      if (!has_vertices) take_known(primitive.layout);
      has_vertices = true;
      std::vector<float>& out = primitive.vertices;
      out.insert(out.end(), position.begin(), position.begin() + 3);
      for (unsigned i = 0; i < kAttributeKinds; ++i)
        if (has(primitive.layout, i))
          out.insert(out.end(), known_[i]->begin(),
                     known_[i]->begin() + attribute_size(primitive.layout, i));
    } else if (command.play == kNormal3) {
      if (!set(kNormal, three(command.payload))) return false;
    } else if (command.play == kColor4) {
      if (!set(kColor, four(command.payload))) return false;
    } else if (command.play == kSecondary3) {
      if (!set(kSecondaryColor, three(command.payload))) return false;
    } else if (command.play == kFogCoordinate) {
      if (!set(kFogCoord, one(command.payload))) return false;
    } else if (command.play == kTexcoord4) {
      if (!set(kTexcoord + texture_unit(command.payload), coordinates(command.payload)))
        return false;
    } else {
      return false;
    }
  }
  return false;
}

std::uint32_t ListWelder::weld(ListMesh& mesh, const float* vertex, unsigned stride) {
  const std::size_t bytes = stride * sizeof(float);
  const std::size_t hash =
      std::hash<std::string_view>{}({reinterpret_cast<const char*>(vertex), bytes});
  const auto [first, last] = places_.equal_range(hash);
  for (auto at = first; at != last; ++at)
    if (std::memcmp(&mesh.vertices[std::size_t{at->second} * stride], vertex, bytes) == 0) {
      ++mesh.welded;
      return at->second;
    }
  const auto index = static_cast<std::uint32_t>(mesh.vertices.size() / stride);
  mesh.vertices.insert(mesh.vertices.end(), vertex, vertex + stride);
  places_.emplace(hash, index);
  return index;
}

void ListWelder::append(ListMesh& mesh, const Primitive& primitive) {
  const unsigned stride = offsets_of(mesh.layout).stride;
  const std::uint32_t count = whole_primitives(
      primitive.mode, static_cast<std::uint32_t>(primitive.vertices.size() / stride));
  if (count == 0) return;
  const GLenum mode = core_mode(primitive.mode);
  const bool indexed = !keeps_own_order(primitive.mode);
  if (mesh.draws.empty() || mesh.draws.back().mode != mode || mesh.draws.back().indexed != indexed)
    mesh.draws.push_back(
        {mode, indexed,
         static_cast<std::uint32_t>(indexed ? mesh.indices.size() : mesh.firsts.size()), 0});
  ListMesh::Draw& draw = mesh.draws.back();
  if (!indexed) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size() / stride);
    mesh.vertices.insert(
        mesh.vertices.end(), primitive.vertices.begin(),
        primitive.vertices.begin() + static_cast<std::ptrdiff_t>(std::size_t{count} * stride));
    mesh.firsts.push_back(static_cast<GLint>(first));
    mesh.counts.push_back(static_cast<GLsizei>(count));
    mesh.runs.push_back({primitive.mode, first, count, false});
    ++draw.count;
    return;
  }
  const PrimitiveRun run{primitive.mode, static_cast<std::uint32_t>(mesh.elements.size()), count,
                         true};
  for (std::uint32_t i = 0; i < count; ++i)
    mesh.elements.push_back(weld(mesh, &primitive.vertices[std::size_t{i} * stride], stride));
  append_indices(run, mesh.elements, 0, true, mesh.indices);
  mesh.runs.push_back(run);
  draw.count = static_cast<std::uint32_t>(mesh.indices.size()) - draw.first;
}

void ListWelder::weld_last_primitive(DisplayList& list) {
  const std::size_t end = list.size();
  std::size_t begin = end;
  read_between(list, end, begin);
  Primitive primitive;
  if (begin == end || !read_primitive(list, begin, primitive)) {
    known_ = {};
    open_mesh_ = nullptr;
    scanned_ = end;
    return;
  }
  const bool joins = open_mesh_ && open_mesh_->layout == primitive.layout;
  const std::size_t replaced = joins ? behind_mesh_ : begin;
  const std::vector<std::size_t> last = last_of_each_attribute(list, replaced, end);
  if (!joins) {
    open_mesh_ = std::make_shared<ListMesh>();
    open_mesh_->layout = primitive.layout;
    places_.clear();
    list.append_mesh(open_mesh_);
    behind_mesh_ = replaced + (list.size() - end);
  }
  append(*open_mesh_, primitive);
  for (const std::size_t at : last) list.append_copy(at);
  list.erase(replaced, end);
  scanned_ = list.size();
}

}  // namespace legacy_gl
