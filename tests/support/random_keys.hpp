// Program keys that a state could lead to, from a fixed seed.
#pragma once

#include <random>

#include "shadergen/attributes.hpp"
#include "shadergen/program_key.hpp"

namespace legacy_gl::test {

class RandomKeys {
 public:
  explicit RandomKeys(unsigned seed) : random_(seed) {}

  ProgramKey next() {
    ProgramKey key = lighting_and_shape();
    if (key.pixels == PixelSource::kStencil || chance(2)) return key;
    add_textures(key);
    if (key.pixels != PixelSource::kNone) {
      // Texture coordinates are the raster position's, which were transformed when it was set.
      for (TextureStageKey& stage : key.textures.stages) {
        stage.sources = {};
        stage.matrix = false;
      }
      key.textures.normalize = false;
    }
    return key;
  }

 private:
  ProgramKey lighting_and_shape() {
    ProgramKey key;
    if (chance(12)) {
      key.pixels = static_cast<PixelSource>(1 + below(4));
      if (key.pixels == PixelSource::kStencil) return key;
      key.fragments.fog = static_cast<FogMode>(below(4));
      key.fragments.fog_coordinate = key.fragments.has_fog();
      key.fragments.alpha = static_cast<AlphaFunction>(below(8));
      key.secondary_from_vertex = chance(2);
      return key;
    }
    key.flat = chance(3);
    key.points = chance(5);
    key.point_distance = key.points && chance(3);
    key.point_fade = key.point_distance && chance(2);
    key.position4 = chance(4);
    key.depth_offset = chance(8);
    key.line_offset = !key.points && !key.depth_offset && chance(8);
    key.fragments.fog = chance(3) ? static_cast<FogMode>(below(4)) : FogMode::kNone;
    key.fragments.fog_coordinate =
        key.fragments.has_fog() && !key.depth_offset && !key.line_offset && chance(3);
    if (chance(4)) key.fragments.alpha = static_cast<AlphaFunction>(below(8));
    if (chance(5)) key.fragments.clip_planes = static_cast<std::uint8_t>(below(64));
    if (chance(6))
      key.fragments.coverage = key.points ? Coverage::kSmoothPoint : Coverage::kPolygonStipple;
    key.lit = !chance(6);
    if (!key.lit) {
      key.secondary_from_vertex = chance(2);
      return key;
    }
    key.two_side = chance(2);
    key.back_only = key.two_side && chance(4);
    key.lighting_position = chance(3);
    key.w_is_one = !key.position4 && !key.lighting_position && chance(2);
    key.parallel = key.w_is_one && chance(2);
    const bool specular = add_lights(key);
    key.space =
        key.position4 ? LightingSpace::kEyeHomogeneous : static_cast<LightingSpace>(below(3));
    add_normals(key);
    for (unsigned face = 0; face < (key.two_side ? 2u : 1u); ++face)
      for (unsigned property = 0; property < 5; ++property)
        if (chance(4)) {
          const bool vertex = property == 4 || chance(2);
          key.material[face][property] = vertex ? MaterialSource::kVertex : MaterialSource::kColor;
          if (vertex)
            key.vertex_materials |= static_cast<std::uint16_t>(1u << (face * 5 + property));
        }
    if (key.light_count() && chance(2))
      key.quality = chance(2) ? Quality::kPrecise : Quality::kFastest;
    if (key.quality != Quality::kPrecise && !key.flat && !key.lighting_position)
      key.per_fragment = key.light_count() && chance(4);
    key.scaled_sums = key.light_count() && chance(8);
    if (!specular) return key;
    key.local_viewer = chance(3);
    key.separate_specular = chance(3);
    key.angle_error =
        key.space == LightingSpace::kObject && key.normal != NormalMode::kNormalize && chance(3);
    for (unsigned face = 0; face < (key.two_side ? 2u : 1u); ++face)
      key.integer_shininess[face] = key.material[face][4] == MaterialSource::kVertex ||
                                            key.quality == Quality::kPrecise || chance(3)
                                        ? kGeneralShininess
                                        : static_cast<std::uint8_t>(below(129));
    return key;
  }

  unsigned below(unsigned n) { return std::uniform_int_distribution<unsigned>(0, n - 1)(random_); }
  bool chance(unsigned n) { return below(n) == 0; }

  CombineKey combine(unsigned functions) {
    CombineKey half;
    half.function = static_cast<CombineFunction>(below(functions));
    half.scale = static_cast<std::uint8_t>(1u << below(3));
    for (unsigned i = 0; i < argument_count(half.function); ++i) {
      half.sources[i] = static_cast<std::uint8_t>(below(3 + kMaxTextureStages));
      half.operands[i] = static_cast<CombineOperand>(functions == 8 ? below(4) : 2 + below(2));
    }
    return half;
  }

  void add_textures(ProgramKey& key) {
    const unsigned units = 1 + (chance(3) ? below(kMaxTextureStages) : below(2));
    for (unsigned unit = 0; unit < units; ++unit) {
      const bool last = unit + 1 == units;
      if (!last && chance(4)) continue;
      TextureStageKey& stage = key.textures.stages[unit];
      stage.kind = static_cast<TextureKind>(1 + below(4));
      stage.base = static_cast<TextureBase>(below(6));
      stage.mode = static_cast<TextureMode>(below(6));
      if (stage.mode == TextureMode::kCombine) {
        stage.rgb = combine(8);
        stage.alpha = combine(6);
        if (stage.rgb.function == CombineFunction::kDot3Rgba)
          stage.alpha = {.scale = stage.alpha.scale};
      }
      if (chance(4))
        for (unsigned i = 0; i < 4; ++i)
          stage.sources[i] = static_cast<CoordinateSource>(below(i < 2 ? 5 : i == 2 ? 2 : 2));
      stage.matrix = chance(3);
      stage.projective = stage.kind != TextureKind::kCube && chance(3);
      stage.lod_bias = chance(5);
      const bool plane = stage.kind == TextureKind::k1D || stage.kind == TextureKind::k2D;
      stage.shadow = plane && chance(4);
      if (stage.kind != TextureKind::kCube && chance(3))
        stage.clamp = static_cast<std::uint8_t>(1 + below(stage.kind == TextureKind::k1D ? 1
                                                          : plane                        ? 3
                                                                                         : 7));
      stage.mipmap = stage.clamp && chance(2);
      // Attributes that the per-vertex materials leave no room for are not read.
      if (stage.reads_vertex() && !has_texcoord_location(key.vertex_materials, unit)) {
        stage = {};
        continue;
      }
      key.textures.count = static_cast<std::uint8_t>(unit + 1);
    }
    key.textures.normalize = key.textures.reads_normal() && chance(2);
  }

  void add_normals(ProgramKey& key) {
    if (chance(2)) key.normal = NormalMode::kNormalize;
    else if (key.space != LightingSpace::kObject) key.normal = NormalMode::kMatrix;
    else key.normal = chance(2) ? NormalMode::kAsIs : NormalMode::kScaled;
  }

  bool add_lights(ProgramKey& key) {
    bool specular = false;
    const unsigned runs = below(kMaxLightRuns + 1);
    for (unsigned i = 0; i < runs; ++i) {
      std::uint8_t kind = 0;
      if (chance(2)) {
        kind |= kLightPoint;
        if (chance(2)) kind |= kLightAttenuated;
        if (chance(2))
          kind |= static_cast<std::uint8_t>(kLightSpot | (chance(2) ? kLightSpotExponent : 0));
        if (kind & (kLightAttenuated | kLightSpot) && chance(2)) kind |= kLightAmbient;
      }
      if (chance(2)) kind |= kLightSpecular;
      if (!(kind & (kLightSpecular | kLightAmbient)) || !chance(4)) kind |= kLightDiffuse;
      specular = specular || kind & kLightSpecular;
      key.lights[i] = {kind, static_cast<std::uint16_t>(chance(8) ? 20 : 1 + below(2))};
    }
    return specular;
  }

  std::mt19937 random_;
};

}  // namespace legacy_gl::test
