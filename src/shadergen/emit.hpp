#pragma once
#include <string>

#include "shadergen/program_key.hpp"
#include "shadergen/writer.hpp"

namespace legacy_gl {

/// The first lines: the version, the key in words, default precision.
void emit_header(Writer& w, const ProgramKey& key, Dialect dialect, const char* stage);

/// What goes from the vertex to the fragment: the colours of both faces, secondary colours, texture
/// coordinates.
/// `direction` is in or out.
void emit_varyings(Writer& w, const ProgramKey& key, Dialect dialect, const std::string& direction);
bool has_secondary(const ProgramKey& key);

/// A fragment's colours on their way through the stages, as GLSL expressions. Each stage that
/// changes one leaves its own expression.
struct FragmentColors {
  std::string primary;    ///< vec4
  std::string secondary;  ///< vec3, where has_secondary
  bool declared = false;  ///< the variable `color` exists

  /// The primary colour becomes the variable `color`, which the stage may then assign to.
  void make_variable(Writer& w);
};

/// Fog, coverage, alpha test and clip planes; nothing where the key has none. Distances are set
/// after gl_Position.
void emit_fog_block(Writer& w, const FragmentKey& key);
void emit_fog_coordinate(Writer& w, const FragmentKey& key);
void emit_fog(Writer& w, const FragmentKey& key, FragmentColors& colors);
void emit_alpha_test(Writer& w, const FragmentKey& key, FragmentColors& colors);
void emit_coverage_block(Writer& w, const ProgramKey& key);
void emit_coverage(Writer& w, const ProgramKey& key, FragmentColors& colors);
void emit_clip_block(Writer& w, const FragmentKey& key);
void emit_clip_varyings(Writer& w, const FragmentKey& key, Dialect dialect,
                        const std::string& direction);
void emit_clip_distances(Writer& w, const FragmentKey& key, Dialect dialect);
void emit_clip_discard(Writer& w, const FragmentKey& key, Dialect dialect);

/// The text of the fragment stage.
std::string emit_fragment(const ProgramKey& key, Dialect dialect);

/// The uniform blocks that lighting reads, and the structs in them.
void emit_lighting_blocks(Writer& w, const ProgramKey& key);

/// Functions that lighting calls: unit vectors, powers.
void emit_lighting_functions(Writer& w, const ProgramKey& key);
void emit_unit_of_any(Writer& w);
void emit_power_of(Writer& w);

/// Statements that turn `position` (where it is read) and `normal` into `vertex` and `n` in
/// lighting space.
void emit_lighting_space(Writer& w, const ProgramKey& key);

void emit_lighting_position(Writer& w, const ProgramKey& key);
void emit_lighting_normal(Writer& w, const ProgramKey& key);

/// Lighting in every fragment (GL_WIN_phong_shading): what the vertex hands over, and the
/// statements of the fragment that leave front_color and its like.
void emit_per_fragment_varyings(Writer& w, const ProgramKey& key, const std::string& direction);
void emit_per_fragment_vertex(Writer& w, const ProgramKey& key);
void emit_per_fragment_blocks(Writer& w, const ProgramKey& key);
void emit_per_fragment_colors(Writer& w, const ProgramKey& key);

/// Statements that sum the lights: leaves vec4 front_lit, and back_lit, front_specular,
/// back_specular where the key has them. Reads `vertex` and `n`.
void emit_lights(Writer& w, const ProgramKey& key);

/// Leaves `distance` to a point light, in the unit that the light's attenuation has.
void emit_distance(Writer& w, const ProgramKey& key, const std::string& light,
                   const std::string& expression);

// The same steps in pairs of floats (the precise quality).
void emit_precise_functions(Writer& w, const ProgramKey& key);
void emit_precise_half_vector_function(Writer& w, const ProgramKey& key);
void emit_precise_space(Writer& w, const ProgramKey& key);
void emit_precise_viewer(Writer& w, const ProgramKey& key);
/// Leaves n_dot_l, and Two to_light where half vectors are made of it; of a point light also Two
/// delta, and `distance` or `chord` where the kind reads them.
void emit_precise_to_light(Writer& w, const ProgramKey& key, std::uint8_t kind,
                           const std::string& index);
void emit_precise_half_vector(Writer& w, const ProgramKey& key);

/// By default: an attenuated light may be stronger than its colours, and its errors with it; the
/// errors of several lights add up.
bool corrects_half_vector(const ProgramKey& key, std::uint8_t kind);

/// The material property of a face as a GLSL expression: "" where it is in the blocks' products
/// already.
std::string material_expression(const ProgramKey& key, unsigned face, unsigned property);

}  // namespace legacy_gl
