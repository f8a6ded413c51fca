#include "geometry/surface.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "geometry/primitives.hpp"

namespace legacy_gl {

namespace {

constexpr std::uint32_t kNone = ~0u;

/// In parts of the surface's size: places nearer than this are one that was rounded in two ways.
constexpr double kRounding = 1.0 / (1 << 20);
/// The planes of a closed part's triangles are at least so far from its middle. Where a surface is
/// thinner, its two sides may meet in one depth value.
constexpr double kThinnest = 1.0 / 256;

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
  hash = (hash + value) * 0x9e3779b97f4a7c15u;
  return hash ^ hash >> 32;
}

/// An open-addressing table of the numbers 0, 1, 2, … by what they stand for.
class Numbers {
 public:
  explicit Numbers(std::size_t most) : slots_(std::bit_ceil(2 * most + 1), kNone) {}

  /// The number that `equals` finds under the hash, else `fresh`, which is stored.
  template <typename Equals>
  std::uint32_t find_or_insert(std::uint64_t hash, std::uint32_t fresh, Equals equals) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = hash & mask;; at = (at + 1) & mask) {
      if (slots_[at] == kNone) return slots_[at] = fresh;
      if (equals(slots_[at])) return slots_[at];
    }
  }

 private:
  std::vector<std::uint32_t> slots_;
};

/// Sets that are joined; each is known by one of its members.
class Groups {
 public:
  explicit Groups(std::size_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { parents_[find(b)] = find(a); }

 private:
  std::vector<std::uint32_t> parents_;
};

/// How often an edge is walked from its lower place to the other, less how often it is walked back.
struct Edge {
  std::uint32_t low, high;
  std::int32_t balance;
};

class SurfaceFinder {
 public:
  explicit SurfaceFinder(const ListMesh& mesh)
      : mesh_(mesh), stride_(offsets_of(mesh.layout).stride) {}

  Surface find() {
    for (const PrimitiveRun& run : mesh_.runs)
      if (!append_triangles(run, mesh_.elements, triangles_)) return {};
    number_places();
    if (triangles_.empty() || !measure() || !close_edges()) return std::move(surface_);
    surface_.winding = find_winding();
    surface_.smooth = surface_.winding != Surface::Winding::kOpen && is_smooth();
    return std::move(surface_);
  }

 private:
  const float* vertex(std::uint32_t i) const {
    return mesh_.vertices.data() + std::size_t{i} * stride_;
  }

  void number_places() {
    const std::uint32_t count = mesh_.vertex_count();
    Numbers alike(count), places(count);
    std::vector<std::uint32_t> first(count), place(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      std::uint64_t hash = 0;
      for (unsigned k = 0; k < stride_; ++k) {
        hash = mix(hash, std::bit_cast<std::uint32_t>(vertex(i)[k]));
        if (k == 2) position_hash_ = hash;
      }
      first[i] = alike.find_or_insert(hash, i, [&](std::uint32_t j) {
        return std::memcmp(vertex(i), vertex(j), stride_ * sizeof(float)) == 0;
      });
      if (first[i] != i) {
        place[i] = place[first[i]];
        continue;
      }
      const auto fresh = static_cast<std::uint32_t>(surface_.places.size());
      place[i] = places.find_or_insert(position_hash_, fresh, [&](std::uint32_t j) {
        const glm::vec3& other = surface_.places[j];
        return vertex(i)[0] == other.x && vertex(i)[1] == other.y && vertex(i)[2] == other.z;
      });
      if (place[i] == fresh) surface_.places.emplace_back(vertex(i)[0], vertex(i)[1], vertex(i)[2]);
    }
    surface_.corners.reserve(triangles_.size());
    for (const std::uint32_t i : triangles_) surface_.corners.push_back({place[i], first[i]});
  }

  /// False when a position is no number that one can reckon with.
  bool measure() {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const glm::vec3& place : surface_.places) {
      low = glm::min(low, glm::dvec3(place));
      high = glm::max(high, glm::dvec3(place));
      if (!(std::abs(place.x) + std::abs(place.y) + std::abs(place.z) < 1e18f)) return false;
    }
    size_ = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
    return size_ > 1e-18;
  }

  void add_edge(std::vector<Edge>& edges, Numbers& numbers, std::uint32_t a, std::uint32_t b,
                std::int32_t balance) const {
    if (a == b) return;
    if (a > b) {
      std::swap(a, b);
      balance = -balance;
    }
    const auto fresh = static_cast<std::uint32_t>(edges.size());
    const std::uint32_t number = numbers.find_or_insert(
        mix(mix(0, a), b), fresh,
        [&](std::uint32_t j) { return edges[j].low == a && edges[j].high == b; });
    if (number == fresh) edges.push_back({a, b, 0});
    edges[number].balance += balance;
  }

  /// Every edge is walked as often one way as the other, if need be after places that only rounding
  /// keeps apart are made one.
  bool close_edges() {
    const std::vector<Surface::Corner>& corners = surface_.corners;
    std::vector<Edge> edges;
    edges.reserve(corners.size() / 2 + 1);
    Numbers numbers(corners.size());
    for (std::size_t t = 0; t < corners.size(); t += 3)
      for (std::size_t k = 0; k < 3; ++k)
        add_edge(edges, numbers, corners[t + k].place, corners[t + (k + 1) % 3].place, 1);
    std::erase_if(edges, [](const Edge& edge) { return edge.balance == 0; });
    if (edges.empty()) return true;

    Groups same(surface_.places.size());
    if (!join_near_places(edges, same)) return false;
    std::vector<Edge> joined;
    Numbers joined_numbers(edges.size());
    for (const Edge& edge : edges)
      add_edge(joined, joined_numbers, same.find(edge.low), same.find(edge.high), edge.balance);
    if (std::any_of(joined.begin(), joined.end(), [](const Edge& e) { return e.balance != 0; }))
      return false;
    for (Surface::Corner& corner : surface_.corners) corner.place = same.find(corner.place);
    return true;
  }

  /// The ends of open edges. False when there are too many of them in one spot.
  bool join_near_places(const std::vector<Edge>& edges, Groups& same) const {
    const std::vector<glm::vec3>& places = surface_.places;
    std::vector<std::uint32_t> ends;
    for (const Edge& edge : edges) ends.insert(ends.end(), {edge.low, edge.high});
    std::sort(ends.begin(), ends.end(), [&](std::uint32_t a, std::uint32_t b) {
      return places[a].x < places[b].x || (places[a].x == places[b].x && a < b);
    });
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    const double reach = kRounding * size_;
    std::size_t looks = 0;
    constexpr std::size_t kMostLooks = 16'000'000;
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = i + 1; j < ends.size(); ++j) {
        const glm::dvec3 a(places[ends[i]]), b(places[ends[j]]);
        if (b.x - a.x > reach) break;
        if (++looks > kMostLooks) return false;
        if (std::abs(b.y - a.y) <= reach && std::abs(b.z - a.z) <= reach)
          same.join(ends[i], ends[j]);
      }
    return true;
  }

  /// Looks at each part of the surface from the middle of its box.
  Surface::Winding find_winding() {
    const std::vector<glm::vec3>& places = surface_.places;
    const std::vector<Surface::Corner>& corners = surface_.corners;
    Groups parts(places.size());
    for (std::size_t t = 0; t < corners.size(); t += 3) {
      parts.join(corners[t].place, corners[t + 1].place);
      parts.join(corners[t].place, corners[t + 2].place);
    }
    struct Box {
      glm::dvec3 low{std::numeric_limits<double>::infinity()};
      glm::dvec3 high{-std::numeric_limits<double>::infinity()};
    };
    std::vector<Box> boxes(places.size());
    for (const Surface::Corner& corner : corners) {
      Box& box = boxes[parts.find(corner.place)];
      box.low = glm::min(box.low, glm::dvec3(places[corner.place]));
      box.high = glm::max(box.high, glm::dvec3(places[corner.place]));
    }
    bool all_out = true, all_in = true;
    double thickness = 1;
    for (std::size_t t = 0; t < corners.size(); t += 3) {
      const glm::dvec3 a(places[corners[t].place]), b(places[corners[t + 1].place]),
          c(places[corners[t + 2].place]);
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      const double length = glm::length(normal);
      const double longest =
          std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
      if (length <= kRounding * size_ * longest) continue;  // rounding alone gives it an area
      const Box& box = boxes[parts.find(corners[t].place)];
      const glm::dvec3 extent = box.high - box.low;
      const double distance = glm::dot(normal, a - (box.low + box.high) * 0.5) / length;
      const double size = std::max({extent.x, extent.y, extent.z});
      all_out = all_out && distance > kThinnest * size;
      all_in = all_in && distance < -kThinnest * size;
      thickness = std::min(thickness, std::abs(distance) / size);
      if (!all_out && !all_in) return Surface::Winding::kOpen;
    }
    if (all_out == all_in) return Surface::Winding::kOpen;  // nothing has an area
    surface_.thickness = static_cast<float>(thickness);
    return all_out ? Surface::Winding::kCounterclockwise : Surface::Winding::kClockwise;
  }

  bool is_smooth() const {
    std::vector<std::uint32_t> first(surface_.places.size(), kNone);
    constexpr float kAlike = 1e-5f;
    for (const Surface::Corner& corner : surface_.corners) {
      std::uint32_t& other = first[corner.place];
      if (other == kNone) other = corner.vertex;
      if (other == corner.vertex) continue;
      for (unsigned k = 3; k < stride_; ++k)
        if (!(std::abs(vertex(other)[k] - vertex(corner.vertex)[k]) <= kAlike)) return false;
    }
    return true;
  }

  const ListMesh& mesh_;
  const unsigned stride_;
  std::uint64_t position_hash_ = 0;
  double size_ = 0;
  std::vector<std::uint32_t> triangles_;
  Surface surface_;
};

}  // namespace

Surface find_surface(const ListMesh& mesh) {
  if (mesh.vertices.empty() || mesh.layout.fields & (kFieldPositionW | kFieldTransformed))
    return {};
  return SurfaceFinder(mesh).find();
}

}  // namespace legacy_gl
