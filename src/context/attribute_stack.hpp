#pragma once
#include <cstdint>
#include <vector>

#include "evaluator/evaluator.hpp"
#include "lighting/lighting_state.hpp"
#include "state/accumulation.hpp"
#include "state/client_arrays.hpp"
#include "state/clip_planes.hpp"
#include "state/current.hpp"
#include "state/fog.hpp"
#include "state/gl_types.hpp"
#include "state/pixel_state.hpp"
#include "state/raster.hpp"
#include "texture/texture_state.hpp"

namespace legacy_gl {

/// What GL_TRANSFORM_BIT saves; the matrices have stacks of their own.
struct TransformGroup {
  GLenum matrix_mode = GL_MODELVIEW;
  bool normalize_enabled = false;
  bool rescale_normal_enabled = false;
  ClipPlanes clip;
};

/// What GL_TEXTURE_BIT saves: the units, and the parameters of what they have bound.
struct TextureGroup {
  unsigned active_texture = 0;
  std::array<TextureUnit, kMaxTextureUnits> units;
  std::array<std::array<TextureParameters, kTextureTargetCount>, kMaxTextureUnits> parameters;
};

/// One level of the attribute stack: the groups that `mask` names (GL 2.1 spec 6.1.14, tables 6.6
/// to 6.33).
struct SavedAttributes {
  GLbitfield mask = 0;
  CurrentValues current;
  LightingState lighting;
  TransformGroup transform;
  RasterState raster;
  FogState fog;
  AccumulationState accumulation;
  HintState hints;
  GLuint list_base = 0;
  TextureGroup texture;
  bool color_sum_enabled = false;
  GLenum read_buffer = GL_NONE;
  PixelTransfer pixel_transfer;
  EvaluatorModes evaluators;
  std::vector<std::uint8_t> enables;  ///< in the order of enable_group()
};

struct SavedClientAttributes {
  GLbitfield mask = 0;
  PixelStore pack, unpack;
  ClientArrays arrays;
  unsigned client_active_texture = 0;
};

/// Levels keep their storage when they are popped: a frame that pushes and pops allocates once in
/// its life.
template <typename Level>
class LevelStack {
 public:
  static constexpr unsigned kMaxDepth = 16;

  unsigned depth() const { return depth_; }
  bool can_push() const { return depth_ < kMaxDepth; }
  bool can_pop() const { return depth_ > 0; }
  /// What the next push() makes a level: filled before, so that a lack of memory leaves none that
  /// is half filled.
  Level& next() {
    if (levels_.size() == depth_) {
      levels_.reserve(kMaxDepth);
      levels_.emplace_back();
    }
    return levels_[depth_];
  }
  void push() { ++depth_; }
  const Level& pop() { return levels_[--depth_]; }

 private:
  std::vector<Level> levels_;
  unsigned depth_ = 0;
};

struct AttributeStacks {
  LevelStack<SavedAttributes> server;
  LevelStack<SavedClientAttributes> client;
};

}  // namespace legacy_gl
