#include "shadergen/texture_key.hpp"

namespace legacy_gl {

namespace {

constexpr const char* kKinds[] = {"", "1D", "2D", "3D", "cube map"};
constexpr const char* kBases[] = {"alpha",     "luminance", "luminance-alpha",
                                  "intensity", "RGB",       "RGBA"};
constexpr const char* kModes[] = {"modulate", "replace", "decal", "blend", "add", "combine"};
constexpr const char* kSources[] = {"", "linear", "sphere map", "reflection map", "normal map"};

std::string describe(const TextureStageKey& stage) {
  std::string text = std::string(kKinds[static_cast<unsigned>(stage.kind)]) + " " +
                     kBases[static_cast<unsigned>(stage.base)] + " " +
                     kModes[static_cast<unsigned>(stage.mode)];
  for (unsigned i = 0; i < 4; ++i)
    if (stage.sources[i] != CoordinateSource::kVertex)
      text +=
          std::string(" ") + "strq"[i] + " " + kSources[static_cast<unsigned>(stage.sources[i])];
  if (stage.matrix) text += " matrix";
  if (stage.projective) text += " projective";
  if (stage.lod_bias) text += " bias";
  if (stage.shadow) text += " shadow";
  if (stage.clamp) text += " clamped";
  return text;
}

}  // namespace

std::size_t hash_of(const TextureKey& key) {
  std::size_t hash = key.count * 2u + (key.normalize ? 1u : 0u);
  const auto mix = [&hash](std::size_t value) { hash = (hash ^ value) * 0x100000001b3ull; };
  const auto mix_combine = [&](const CombineKey& combine) {
    std::size_t value = static_cast<std::size_t>(combine.function) << 3 | combine.scale;
    for (unsigned i = 0; i < 3; ++i)
      value = value << 6 | std::size_t{combine.sources[i]} << 2 |
              static_cast<std::size_t>(combine.operands[i]);
    mix(value);
  };
  for (unsigned i = 0; i < key.count; ++i) {
    const TextureStageKey& stage = key.stages[i];
    std::size_t value = static_cast<std::size_t>(stage.kind) << 6 |
                        static_cast<std::size_t>(stage.base) << 3 |
                        static_cast<std::size_t>(stage.mode);
    for (const bool flag :
         {stage.matrix, stage.projective, stage.lod_bias, stage.shadow, stage.mipmap})
      value = value << 1 | (flag ? 1u : 0u);
    value = value << 3 | stage.clamp;
    for (const CoordinateSource source : stage.sources)
      value = value << 3 | static_cast<std::size_t>(source);
    mix(value);
    if (stage.mode != TextureMode::kCombine) continue;
    mix_combine(stage.rgb);
    mix_combine(stage.alpha);
  }
  return hash;
}

std::string describe(const TextureKey& key) {
  std::string text;
  for (unsigned i = 0; i < key.count; ++i) {
    if (key.stages[i].kind == TextureKind::kNone) continue;
    if (!text.empty()) text += ", ";
    text += "texture " + std::to_string(i) + " " + describe(key.stages[i]);
  }
  if (key.normalize) text += ", texgen of unit normals";
  return text;
}

}  // namespace legacy_gl
