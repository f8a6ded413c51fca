#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "context/context.hpp"
#include "driver/framebuffer_facts.hpp"
#include "geometry/list_mesh.hpp"

namespace legacy_gl {

/// What decides how a small object is lit and which of its sides are seen, besides its matrix and
/// its material.
struct ObjectSurroundings {
  std::vector<Light> lights;
  LightModel light_model;
  GLenum shade_model = GL_SMOOTH;
  bool normalize = false, rescale_normal = false;
  bool clip_planes = false, query_active = false;
  glm::mat4 projection{1};
  RasterState raster;
  FramebufferFacts framebuffer;
};

/// Gives each surroundings a number, the same when they return.
class SurroundingsNumbers {
 public:
  /// `changed`: dirty bits that were raised since the last call.
  std::uint32_t number_of(const Context& context, const FramebufferFacts& framebuffer,
                          std::uint32_t changed);

 private:
  static constexpr std::size_t kMost = 32;  ///< then the one that was met first gives way
  struct Entry {
    std::uint32_t number = 0;
    ObjectSurroundings surroundings;
  };
  std::vector<Entry> entries_;
  std::size_t current_ = 0;
  std::uint32_t last_number_ = 0;
};

/// What small objects came to when they were lit, for when they come again: the same mesh with the
/// same matrix and material in the same surroundings. What is met once is not kept.
class KeptObjects {
 public:
  struct Key {
    const ListMesh& mesh;
    std::uint32_t surroundings;
    PendingMatrix modelview;
    const Materials& materials;
  };
  struct Facts {
    std::size_t unseen_triangles = 0;
    bool apart = false;    ///< as PrimitiveRun says
    bool outside = false;  ///< of the view: it was clipped
  };
  /// A part of a lit batch.
  struct Object {
    Facts facts;
    std::vector<float> vertices;
    std::vector<std::uint16_t> elements;  ///< of the vertices, three for each triangle
  };

  /// An object where it is kept. There may be another in its place later, of another number.
  struct Entry {
    std::uint64_t number = 0;  ///< 0: not kept yet
    const ListMesh* address = nullptr;
    std::weak_ptr<const ListMesh> mesh;  ///< nothing else is at its address until it is gone
    std::uint32_t surroundings = 0;
    Matrix modelview_base;
    std::array<MatrixOperation, MatrixStack::kMaxPending> operations;
    std::size_t operation_count = 0;
    Materials materials;
    Object object;

    bool equals(const Key& key) const;
    void set_key(const Key& key);
    std::size_t floats() const { return object.vertices.capacity(); }
  };

  /// nullptr when the object is not kept. It may be the expected one. Nothing that the key refers
  /// to is needed afterwards.
  const Entry* find(const Key& key, const Entry* expected);
  /// What was not found last was met before: it is worth keeping.
  bool wants() const { return wanted_ != nullptr; }
  /// Keeps what was not found last. `elements` count from `base`.
  void keep(const Facts& facts, std::span<const float> vertices = {},
            std::span<const std::uint32_t> elements = {}, std::uint32_t base = 0);

 private:
  static constexpr unsigned kHashBits = 11;
  static constexpr std::size_t kSlotsOfAHash = 16;
  /// After so many objects in a row of which none was met before so many are not looked for.
  static constexpr unsigned kMissedInVain = kSlotsOfAHash << kHashBits, kPause = 4 * kMissedInVain;
  static constexpr std::size_t kMostFloats = std::size_t{4} << 20;  ///< of all objects together

  struct Slot {
    std::uint64_t hash = 0;       ///< of what was looked for here
    std::uint64_t last_used = 0;  ///< the least recently used of a hash's slots is taken
    std::unique_ptr<Entry> entry;
  };

  void make_room();

  std::vector<Slot> slots_;  ///< by the first bits of the hash; none until the first object
  Entry* wanted_ = nullptr;
  std::uint64_t last_number_ = 0, clock_ = 0;
  unsigned missed_ = 0, pause_ = 0;
  std::size_t floats_ = 0;
};

}  // namespace legacy_gl
