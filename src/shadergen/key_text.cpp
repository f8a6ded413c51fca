#include "shadergen/key_text.hpp"

#include <type_traits>

#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

namespace {

/// Visits every field with the number of values that it may have.
template <typename Key, typename Visit>
void for_each_combine_field(Key& key, Visit visit) {
  visit(key.function, 8);
  visit(key.scale, 5);
  for (auto& source : key.sources)
    visit(source, static_cast<unsigned>(CombineSource::kTexture0) + kMaxTextureStages);
  for (auto& operand : key.operands) visit(operand, 4);
}

template <typename Stage, typename Visit>
void for_each_stage_field(Stage& stage, Visit visit) {
  visit(stage.kind, 5);
  visit(stage.base, 6);
  visit(stage.mode, 6);
  visit(stage.matrix, 2);
  visit(stage.projective, 2);
  visit(stage.lod_bias, 2);
  visit(stage.shadow, 2);
  visit(stage.clamp, 8);
  visit(stage.mipmap, 2);
  for (auto& source : stage.sources) visit(source, 5);
  for_each_combine_field(stage.rgb, visit);
  for_each_combine_field(stage.alpha, visit);
}

template <typename Key, typename Visit>
void for_each_field(Key& key, Visit visit) {
  for (auto* flag : {&key.lit, &key.flat, &key.secondary_from_vertex, &key.two_side,
                     &key.local_viewer, &key.separate_specular, &key.position4, &key.w_is_one,
                     &key.parallel, &key.points, &key.per_fragment, &key.scaled_sums,
                     &key.angle_error, &key.back_only, &key.lighting_position, &key.depth_offset,
                     &key.line_offset, &key.point_distance, &key.point_fade})
    visit(*flag, 2);
  visit(key.pixels, 5);
  visit(key.space, 3);
  visit(key.normal, 4);
  visit(key.quality, 3);
  for (auto& face : key.material)
    for (auto& source : face) visit(source, 3);
  visit(key.vertex_materials, 1u << 10);
  for (auto& shininess : key.integer_shininess) visit(shininess, 256);
  for (auto& run : key.lights) {
    visit(run.kind, 128);
    visit(run.count, kMaxLights + 1);
  }
  visit(key.general_lights, kMaxLights + 1);
  visit(key.fragments.fog, 4);
  visit(key.fragments.fog_coordinate, 2);
  visit(key.fragments.alpha, 8);
  visit(key.fragments.clip_planes, 64);
  visit(key.fragments.coverage, 3);
  visit(key.textures.count, kMaxTextureStages + 1);
  visit(key.textures.normalize, 2);
  // The count is read before its stages are.
  for (unsigned unit = 0; unit < key.textures.count; ++unit)
    for_each_stage_field(key.textures.stages[unit], visit);
}

constexpr unsigned digits_of(unsigned values) { return values <= 16 ? 1 : values <= 256 ? 2 : 4; }

constexpr std::string_view kDigits = "0123456789abcdef";

/// What the fields' ranges do not say, and what the generator relies on.
bool is_sound(const ProgramKey& key) {
  if (key.light_count() > kMaxLights) return false;
  bool ended = false;
  for (const LightRun& run : key.lights) {
    if (ended && run.count) return false;
    ended = run.count == 0;
    if (ended && run.kind) return false;
  }
  for (unsigned i = 0; i < 10; ++i)
    if (key.material[i / 5][i % 5] == MaterialSource::kVertex && !(key.vertex_materials & 1u << i))
      return false;
  return true;
}

}  // namespace

std::string to_text(const ProgramKey& key) {
  std::string text;
  for_each_field(key, [&text](const auto& field, unsigned values) {
    const auto value = static_cast<unsigned>(field);
    for (unsigned digit = digits_of(values); digit-- > 0;) text += kDigits[value >> 4 * digit & 15];
  });
  return text;
}

std::optional<ProgramKey> key_of(std::string_view text) {
  ProgramKey key;
  bool whole = true;
  for_each_field(key, [&](auto& field, unsigned values) {
    unsigned value = 0;
    for (unsigned digits = digits_of(values); whole && digits > 0; --digits) {
      const std::size_t digit = text.empty() ? std::string_view::npos : kDigits.find(text.front());
      whole = digit != std::string_view::npos;
      if (!whole) return;
      value = value << 4 | static_cast<unsigned>(digit);
      text.remove_prefix(1);
    }
    whole = whole && value < values;
    if (whole) field = static_cast<std::remove_reference_t<decltype(field)>>(value);
  });
  if (!whole || !text.empty() || !is_sound(key)) return {};
  return key;
}

}  // namespace legacy_gl
