#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <unordered_map>

#include "geometry/list_mesh.hpp"
#include "geometry/vertex_layout.hpp"

namespace legacy_gl {

class DisplayList;

/// Turns the Begin/End pairs of the list being compiled into meshes, each as soon as its glEnd is
/// recorded. A pair that holds more than vertices and their attributes, or whose first vertex takes
/// a current value that only the call of the list will know, stays as it was recorded.
class ListWelder {
 public:
  /// The last command of `list` is glEnd: replaces its primitive by a mesh, joined to the one
  /// before where nothing but attributes came between.
  void weld_last_primitive(DisplayList& list);

 private:
  /// One attribute whose value the list itself has set.
  using Known = std::optional<std::array<float, 4>>;
  enum Attribute : unsigned {
    kNormal,
    kColor,
    kSecondaryColor,
    kFogCoord,
    kTexcoord
  };  // and each unit
  static constexpr unsigned kAttributeKinds = kTexcoord + kMaxTextureUnits;

  struct Primitive {
    GLenum mode = 0;
    VertexLayout layout;
    std::vector<float> vertices;
  };

  static bool has(const VertexLayout& layout, unsigned attribute);
  void take_known(VertexLayout& layout) const;
  bool read_primitive(const DisplayList& list, std::size_t begin, Primitive& primitive);
  void read_between(const DisplayList& list, std::size_t end, std::size_t& begin);
  void append(ListMesh& mesh, const Primitive& primitive);
  std::uint32_t weld(ListMesh& mesh, const float* vertex, unsigned stride);

  std::size_t scanned_ = 0;      ///< commands before it are accounted for
  std::size_t behind_mesh_ = 0;  ///< the command after the open mesh
  std::array<Known, kAttributeKinds> known_;
  std::shared_ptr<ListMesh> open_mesh_;  ///< what the next primitive may join
  std::unordered_multimap<std::size_t, std::uint32_t>
      places_;  ///< vertex hash to index, of the open mesh
};

}  // namespace legacy_gl
