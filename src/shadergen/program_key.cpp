#include "shadergen/program_key.hpp"

#include <algorithm>

namespace legacy_gl {

namespace {

void mix(std::size_t& hash, std::size_t value) {
  hash = (hash ^ value) * 0x100000001b3ull;  // FNV-1a, a field at a time
}

void append(std::string& text, const std::string& words) {
  if (!text.empty()) text += ", ";
  text += words;
}

std::string describe_kind(std::uint8_t kind) {
  std::string text;
  if (!(kind & kLightPoint)) text = "directional";
  else if (kind & kLightSpot) text = kind & kLightSpotExponent ? "spot" : "spot without exponent";
  else text = "point";
  if (kind & kLightAttenuated) text = "attenuated " + text;
  text += " (";
  if (kind & kLightAmbient) text += "a";
  if (kind & kLightDiffuse) text += "d";
  if (kind & kLightSpecular) text += "s";
  return text + ")";
}

void describe_fragments(std::string& text, const FragmentKey& key) {
  static constexpr const char* kFog[] = {"", "linear fog", "exponential fog", "exp2 fog"};
  static constexpr const char* kAlpha[] = {"", "never", "<", "=", "<=", ">", "!=", ">="};
  if (key.has_fog())
    append(text, std::string(kFog[static_cast<unsigned>(key.fog)]) +
                     (key.fog_coordinate ? " by coordinate" : ""));
  if (key.has_alpha_test())
    append(text, std::string("alpha test ") + kAlpha[static_cast<unsigned>(key.alpha)]);
  static constexpr const char* kCoverage[] = {"", "polygon stipple", "smooth"};
  if (key.coverage != Coverage::kWhole)
    append(text, kCoverage[static_cast<unsigned>(key.coverage)]);
  for (unsigned plane = 0; plane < 8; ++plane)
    if (key.clip_planes & 1u << plane) append(text, "clip plane " + std::to_string(plane));
}

}  // namespace

std::size_t ProgramKeyHash::operator()(const ProgramKey& key) const noexcept {
  std::size_t hash = 0xcbf29ce484222325ull;
  const bool flags[] = {key.lit,          key.flat,         key.secondary_from_vertex,
                        key.two_side,     key.local_viewer, key.separate_specular,
                        key.position4,    key.w_is_one,     key.parallel,
                        key.points,       key.per_fragment, key.back_only,
                        key.angle_error,  key.scaled_sums,  key.lighting_position,
                        key.depth_offset, key.line_offset,  key.point_distance,
                        key.point_fade};
  std::size_t bits = 0;
  for (const bool flag : flags) bits = bits << 1 | (flag ? 1u : 0u);
  mix(hash, bits);
  mix(hash, static_cast<std::size_t>(key.space) << 16 | static_cast<std::size_t>(key.normal) << 8 |
                static_cast<std::size_t>(key.quality) | static_cast<std::size_t>(key.pixels) << 24);
  for (const auto& face : key.material)
    for (const MaterialSource source : face) mix(hash, static_cast<std::size_t>(source));
  mix(hash, key.vertex_materials);
  for (const std::uint8_t shininess : key.integer_shininess) mix(hash, shininess);
  for (const LightRun& run : key.lights)
    mix(hash, static_cast<std::size_t>(run.kind) << 16 | run.count);
  mix(hash, key.general_lights);
  mix(hash, static_cast<std::size_t>(key.fragments.fog) << 24 |
                static_cast<std::size_t>(key.fragments.alpha) << 16 |
                std::size_t{key.fragments.clip_planes} << 8 |
                static_cast<std::size_t>(key.fragments.coverage) << 1 |
                static_cast<std::size_t>(key.fragments.fog_coordinate));
  if (key.textures.count) mix(hash, hash_of(key.textures));
  return hash;
}

bool lighting_reads_position(const ProgramKey& key) {
  if (key.local_viewer) return true;
  for (const LightRun& run : key.lights)
    if (run.count && run.kind & kLightPoint) return true;
  return false;
}

bool computes_half_vectors(const ProgramKey& key) {
  return std::any_of(key.lights.begin(), key.lights.end(), [&key](const LightRun& run) {
    return run.count && run.kind & kLightSpecular && (run.kind & kLightPoint || key.local_viewer);
  });
}

bool splits_half_vectors(const ProgramKey& key) {
  if (key.quality != Quality::kDefault) return key.quality == Quality::kPrecise;
  return key.normal == NormalMode::kNormalize || !computes_half_vectors(key);
}

std::string describe(const ProgramKey& key) {
  std::string text;
  if (!key.lit) append(text, "unlit");
  if (key.general_lights) append(text, "general");
  for (const LightRun& run : key.lights)
    if (run.count) append(text, std::to_string(run.count) + " " + describe_kind(run.kind));
  if (key.lit && !key.general_lights && key.light_count() == 0) append(text, "lit by no light");
  if (key.lit && !key.general_lights) {
    switch (key.space) {
      case LightingSpace::kObject: append(text, "in object space"); break;
      case LightingSpace::kEyeAxes: append(text, "in eye axes"); break;
      case LightingSpace::kEyeHomogeneous: append(text, "in eye coordinates, V/w"); break;
    }
  }
  if (key.normal == NormalMode::kNormalize) append(text, "normalize");
  switch (key.quality) {
    case Quality::kDefault: break;
    case Quality::kFastest: append(text, "fastest"); break;
    case Quality::kPrecise: append(text, "precise"); break;
  }
  if (key.scaled_sums) append(text, "scaled sums");
  if (key.two_side) append(text, "two-sided");
  if (key.local_viewer) append(text, "local viewer");
  if (key.separate_specular) append(text, "separate specular");
  static constexpr const char* kProperties[] = {"ambient", "diffuse", "specular", "emission",
                                                "shininess"};
  for (unsigned face = 0; face < 2; ++face)
    for (unsigned property = 0; property < 5; ++property)
      if (const MaterialSource source = key.material[face][property];
          source != MaterialSource::kUniform)
        append(text, std::string(face ? "back " : "front ") + kProperties[property] +
                         (source == MaterialSource::kColor ? " from colour" : " per vertex"));
  for (unsigned face = 0; face < 2; ++face)
    if (key.integer_shininess[face] && key.integer_shininess[face] != kGeneralShininess)
      append(text, std::string(face ? "back " : "") + "shininess " +
                       std::to_string(key.integer_shininess[face]));
  if (key.secondary_from_vertex) append(text, "colour sum");
  if (key.flat) append(text, "flat");
  if (key.per_fragment) append(text, "per fragment");
  if (key.position4) append(text, "vertex w");
  if (key.w_is_one) append(text, "w 1");
  if (key.parallel) append(text, "parallel projection");
  if (key.points) append(text, "points");
  if (key.point_distance) append(text, "sizes by distance");
  if (key.point_fade) append(text, "fading");
  if (key.angle_error) append(text, "angles corrected");
  if (key.back_only) append(text, "back faces");
  if (key.lighting_position) append(text, "lit at a position of its own");
  if (key.depth_offset) append(text, "depth offset");
  if (key.line_offset) append(text, "line offset");
  describe_fragments(text, key.fragments);
  static constexpr const char* kPixels[] = {"", "bitmap", "pixels", "depth pixels",
                                            "stencil pixels"};
  if (key.pixels != PixelSource::kNone) append(text, kPixels[static_cast<unsigned>(key.pixels)]);
  if (key.textures.count) append(text, describe(key.textures));
  return text;
}

}  // namespace legacy_gl
