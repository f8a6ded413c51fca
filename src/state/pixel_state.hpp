#pragma once
#include <array>
#include <vector>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// GL 2.1 spec table 3.2: what glPixelTransfer sets. The group of GL_PIXEL_MODE_BIT.
struct PixelTransfer {
  bool map_color = false, map_stencil = false;
  GLint index_shift = 0, index_offset = 0;
  std::array<float, 4> scale{1, 1, 1, 1}, bias{};  ///< of red, green, blue, alpha
  float depth_scale = 1, depth_bias = 0;
  float zoom_x = 1, zoom_y = 1;  ///< glPixelZoom
  bool operator==(const PixelTransfer&) const = default;
};

/// GL 2.1 spec table 3.3, in the order of GL_PIXEL_MAP_I_TO_I and its followers.
enum PixelMapIndex : unsigned {
  kMapIToI,
  kMapSToS,
  kMapIToR,
  kMapIToG,
  kMapIToB,
  kMapIToA,
  kMapRToR,
  kMapGToG,
  kMapBToB,
  kMapAToA,
  kPixelMapCount
};
inline constexpr GLsizei kMaxPixelMapTable = 256;

/// No attribute group holds the maps (GL 2.1 spec table 6.26).
using PixelMaps = std::array<std::vector<float>, kPixelMapCount>;

struct PixelState {
  PixelState() { maps.fill({0.0f}); }

  PixelTransfer transfer;
  PixelMaps maps;

  bool changes_colors() const {
    constexpr std::array<float, 4> kOnes{1, 1, 1, 1};
    return transfer.map_color || transfer.scale != kOnes || transfer.bias != std::array<float, 4>{};
  }
  bool changes_depths() const { return transfer.depth_scale != 1 || transfer.depth_bias != 0; }
  bool changes_stencil() const {
    return transfer.map_stencil || transfer.index_shift != 0 || transfer.index_offset != 0;
  }
};

}  // namespace legacy_gl
