#pragma once
#include <cstdint>

#include "lighting/material.hpp"
#include "state/current.hpp"

namespace legacy_gl {

/// What a recorded vertex holds beside its position, in this order. The position has three floats,
/// or four where a w other than 1 was given.
enum VertexField : std::uint16_t {
  kFieldPositionW = 1,
  kFieldNormal = 2,          ///< 3 floats
  kFieldColor = 4,           ///< 4 floats
  kFieldSecondaryColor = 8,  ///< 3 floats
  kFieldEdgeFlag = 16,  ///< 1 float, 0 or 1; recorded while polygons are drawn as lines or points
  kFieldLightingPosition = 32,  ///< as many floats as the position: where the vertex is lit
  kFieldDepthOffset = 64,       ///< 1 float: polygon offset in normalised device coordinates
  kFieldFogCoord = 128,         ///< 1 float
  /// Objects with matrices of their own in one batch: the position is in clip coordinates (4
  /// floats), normal and lighting position are in eye coordinates.
  kFieldTransformed = 256,
  /// 3 floats: offsets in normalised device coordinates, of one of the lines that make a wide one
  /// (x, y) and of the polygon (z).
  kFieldLineOffset = 512,
  /// Beside kFieldTransformed, alone: lit here. 4 floats, first the normal, in the end the colour.
  kFieldShaded = 1024,
};

struct VertexLayout {
  std::uint16_t fields = 0;
  std::uint8_t texcoords = 0;       ///< texture units whose coordinates it holds: s and t,
  std::uint8_t wide_texcoords = 0;  ///< or of these units s, t, r, q
  MaterialMask materials = 0;  ///< properties that the vertices carry: material_size floats each
  bool operator==(const VertexLayout&) const = default;
};

/// Offset in floats of each field, and of the material properties that are present.
struct VertexOffsets {
  unsigned position_size = 3;
  unsigned normal = 0, color = 0, secondary_color = 0, fog_coord = 0, edge_flag = 0;
  unsigned lighting_position = 0, depth_offset = 0, line_offset = 0;
  unsigned texcoords[kMaxTextureUnits] = {};
  unsigned materials[2 * kPropertyCount] = {};
  unsigned materials_begin = 0, materials_end = 0;
  unsigned stride = 0;  ///< in floats
};

/// Of a colour only the diffuse alpha counts.
constexpr unsigned material_size(unsigned property) {
  return property == kShininess ? 1 : property == kDiffuse ? 4 : 3;
}

/// A stride is never larger.
inline constexpr unsigned kMaxVertexFloats = 96;

constexpr unsigned texcoord_size(const VertexLayout& layout, unsigned unit) {
  return layout.wide_texcoords & 1u << unit ? 4 : 2;
}

inline VertexOffsets offsets_of(const VertexLayout& layout) {
  VertexOffsets offsets;
  offsets.position_size = layout.fields & (kFieldPositionW | kFieldTransformed) ? 4 : 3;
  unsigned at = offsets.position_size;
  const auto take = [&at](unsigned& offset, unsigned size) {
    offset = at;
    at += size;
  };
  if (layout.fields & kFieldShaded) {
    take(offsets.normal, 4);
    offsets.color = offsets.normal;
  }
  if (layout.fields & kFieldNormal) take(offsets.normal, 3);
  if (layout.fields & kFieldColor) take(offsets.color, 4);
  if (layout.fields & kFieldSecondaryColor) take(offsets.secondary_color, 3);
  if (layout.fields & kFieldFogCoord) take(offsets.fog_coord, 1);
  if (layout.texcoords)
    for (unsigned unit = 0; unit < kMaxTextureUnits; ++unit)
      if (layout.texcoords & 1u << unit) take(offsets.texcoords[unit], texcoord_size(layout, unit));
  offsets.materials_begin = at;
  for (unsigned i = 0; i < 2 * kPropertyCount; ++i)
    if (layout.materials & (1u << i)) take(offsets.materials[i], material_size(i % kPropertyCount));
  offsets.materials_end = at;
  if (layout.fields & kFieldEdgeFlag) take(offsets.edge_flag, 1);
  if (layout.fields & kFieldLightingPosition)
    take(offsets.lighting_position, offsets.position_size);
  if (layout.fields & kFieldDepthOffset) take(offsets.depth_offset, 1);
  if (layout.fields & kFieldLineOffset) take(offsets.line_offset, 3);
  offsets.stride = at;
  return offsets;
}

}  // namespace legacy_gl
