// Phong interpolation: the direction of the normal, its length, the position and the materials that
// come with vertices are interpolated, and the fragment evaluates the same equation.
#include "shadergen/attributes.hpp"
#include "shadergen/emit.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

namespace {

bool tracks_color(const ProgramKey& key) {
  for (const auto& face : key.material)
    for (const MaterialSource source : face)
      if (source == MaterialSource::kColor) return true;
  return false;
}

template <class Emit>
void for_each_material_attribute(const ProgramKey& key, Emit&& emit) {
  for (unsigned face = 0; face < 2; ++face)
    for (unsigned property = 0; property < 5; ++property)
      if (key.material[face][property] == MaterialSource::kVertex)
        emit(property == 4 ? "float" : "vec4",
             std::string(kMaterialAttributeNames[face][property]));
}

}  // namespace

void emit_per_fragment_varyings(Writer& w, const ProgramKey& key, const std::string& direction) {
  if (lighting_reads_position(key)) w.line(direction + " vec4 position_at;");
  w.line(direction + " vec3 normal_at;");
  if (key.normal != NormalMode::kNormalize) w.line(direction + " float normal_length_at;");
  if (tracks_color(key)) w.line(direction + " vec4 color_at;");
  for_each_material_attribute(key, [&](const char* type, const std::string& name) {
    w.line(direction + " " + type + " " + name + "_at;");
  });
}

void emit_per_fragment_vertex(Writer& w, const ProgramKey& key) {
  if (lighting_reads_position(key)) w.line("position_at = position;");
  emit_lighting_normal(w, key);
  if (key.normal == NormalMode::kNormalize) {
    w.line("normal_at = n;");
  } else {
    w.line("normal_at = unit_of_any(n);");
    w.line("normal_length_at = min(dot(n, normal_at), 1e18);");
  }
  if (tracks_color(key)) w.line("color_at = color;");
  for_each_material_attribute(
      key, [&](const char*, const std::string& name) { w.line(name + "_at = " + name + ";"); });
}

void emit_per_fragment_blocks(Writer& w, const ProgramKey& key) {
  w.raw(kTransformBlockText);
  w.blank();
  emit_lighting_blocks(w, key);
}

void emit_per_fragment_colors(Writer& w, const ProgramKey& key) {
  if (lighting_reads_position(key)) w.line("vec4 position = position_at;");
  emit_lighting_position(w, key);
  w.line(key.normal == NormalMode::kNormalize
             ? "vec3 n = unit_of_any(normal_at);"
             : "vec3 n = normal_length_at * unit_of_any(normal_at);");
  emit_lights(w, key);
  w.line("vec4 front_color = front_lit;");
  if (key.two_side) w.line("vec4 back_color = back_lit;");
  if (key.separate_specular) w.line("vec3 front_secondary = front_specular;");
  if (key.separate_specular && key.two_side) w.line("vec3 back_secondary = back_specular;");
}

}  // namespace legacy_gl
