#include "shadergen/generate.hpp"

#include "shadergen/attributes.hpp"
#include "shadergen/emit.hpp"
#include "shadergen/emit_texture.hpp"
#include "shadergen/general.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

namespace {

bool reads_color(const ProgramKey& key) {
  if (!key.lit) return true;
  for (const auto& face : key.material)
    for (const MaterialSource source : face)
      if (source == MaterialSource::kColor) return true;
  return false;
}

void emit_input(Writer& w, unsigned location, const std::string& type, const std::string& name) {
  w.line("layout(location = " + std::to_string(location) + ") in " + type + " " + name + ";");
}

void emit_inputs(Writer& w, const ProgramKey& key) {
  emit_input(w, kLocationPosition, "vec4", "position");
  if (key.lit || key.textures.reads_normal()) emit_input(w, kLocationNormal, "vec3", "normal");
  if (key.pixels != PixelSource::kNone) emit_input(w, kLocationTexel, "vec2", "texel_position");
  if (is_zoomed(key.pixels)) emit_input(w, kLocationPixelPlace, "vec4", "pixel_place");
  if (key.lighting_position) emit_input(w, kLocationLightingPosition, "vec4", "lighting_position");
  if (key.depth_offset) emit_input(w, kLocationDepthOffset, "float", "depth_offset");
  if (key.line_offset) emit_input(w, kLocationLineOffset, "vec3", "line_offset");
  if (key.fragments.fog_coordinate) emit_input(w, kLocationFogCoord, "float", "fog_coordinate");
  if (reads_color(key)) emit_input(w, kLocationColor, "vec4", "color");
  if (key.secondary_from_vertex) emit_input(w, kLocationSecondaryColor, "vec3", "secondary_color");
  for (unsigned face = 0; face < 2; ++face)
    for (unsigned property = 0; property < 5; ++property)
      if (key.material[face][property] == MaterialSource::kVertex)
        emit_input(w, material_location(key.vertex_materials, face * 5 + property),
                   property == 4 ? "float" : "vec4", kMaterialAttributeNames[face][property]);
  for (unsigned unit = 0; unit < key.textures.count; ++unit)
    if (key.textures.stages[unit].reads_vertex())
      emit_input(w, texcoord_location(unit), "vec4", "texcoord" + std::to_string(unit));
  w.blank();
}

/// GL 2.1 spec 3.3: sizes by distance, and the fading of those below a threshold.
void emit_point_size(Writer& w, const ProgramKey& key) {
  w.line("vec4 point_eye = point_modelview * position;");
  w.line("float eye_distance = length(point_eye.xyz / point_eye.w);");
  w.line("vec3 abc = point_attenuation.xyz;");
  w.line("float reduction = abc.x + eye_distance * (abc.y + eye_distance * abc.z);");
  w.line("float point_size = point_sizes.x * inversesqrt(max(reduction, 1e-37));");
  w.line("point_size = min(max(point_size, point_sizes.y), point_sizes.z);");
  if (key.point_fade) {
    w.line("float shown = min(point_size / point_sizes.w, 1.0);");
    w.line("point_fade = shown * shown;");
    w.line("point_size = max(point_size, point_sizes.w);");
  }
}

/// OpenGL ES draws the part of a point that reaches into view; OpenGL clips the point (GL 2.1
/// spec 2.12).
void emit_point_clip(Writer& w) {
  w.line("gl_Position = visible ? gl_Position : vec4(0.0, 0.0, 2.0, 1.0);");
}

/// Smooth points are circles around where they are, in squares that hold all pixels they touch.
void emit_smooth_point(Writer& w, const ProgramKey& key, Dialect dialect) {
  if (key.point_distance) {
    emit_point_size(w, key);
    w.line("gl_PointSize = point_size + 1.0;");
    w.line("point_side = gl_PointSize;");
  } else if (dialect == Dialect::kEs300) {
    w.line("gl_PointSize = point.w;");
  }
  if (dialect == Dialect::kCore330) return;
  w.line("bool visible = all(lessThanEqual(abs(gl_Position.xy), vec2(gl_Position.w)));");
  emit_point_clip(w);
}

/// Aliased points are squares of whole pixels (GL 2.1 spec 3.3.1): their centre moves to the middle
/// of a pixel, or to the corner of four where the size is even. The core profile's own points are
/// not moved.
void emit_point(Writer& w, const ProgramKey& key, Dialect dialect) {
  const std::string odd = key.point_distance ? "odd_half" : "point.y";
  if (key.point_distance) {
    emit_point_size(w, key);
    w.line("gl_PointSize = max(1.0, ceil(point_size - 0.5));");
    w.line("float odd_half = 0.5 * mod(gl_PointSize, 2.0);");
  } else if (dialect == Dialect::kEs300) {
    w.line("gl_PointSize = point.x;");
  }
  w.line("vec2 window = gl_Position.xy / gl_Position.w * viewport.xy + viewport.zw;");
  w.line("window = floor(window * 256.0 + 0.5) / 256.0;  // as rasterisers snap");
  w.line("vec2 center = floor(window + 0.5 - " + odd + ") + " + odd + ";");
  w.line("vec2 snapped = (center - viewport.zw) / viewport.xy * gl_Position.w;");
  w.line("vec2 edge = vec2(gl_Position.w);");
  w.line("bool visible = all(lessThanEqual(abs(gl_Position.xy), edge));");
  w.line("gl_Position.xy = visible ? clamp(snapped, -edge, edge) : gl_Position.xy;");
  if (dialect == Dialect::kEs300) emit_point_clip(w);
}

std::string vertex_shader(const ProgramKey& key, Dialect dialect) {
  Writer w;
  emit_header(w, key, dialect, "vertex");
  const bool pixels = key.pixels != PixelSource::kNone;
  if (!pixels) w.raw(kTransformBlockText);
  if (!pixels) w.blank();
  const bool general = key.general_lights != 0;
  if (key.lit && !key.per_fragment)
    general ? emit_general_blocks(w, key) : emit_lighting_blocks(w, key);
  if (key.point_distance) w.raw(kPointsBlockText);
  emit_fog_block(w, key.fragments);
  emit_clip_block(w, key.fragments);
  if (vertex_reads_texture_block(key.textures)) emit_texture_block(w, key.textures);
  emit_inputs(w, key);
  emit_varyings(w, key, dialect, "out");
  // The same expression in every variant, so that multipass rendering with GL_EQUAL meets its own
  // depth.
  w.line("invariant gl_Position;");
  w.blank();
  if (key.lit) general ? emit_general_functions(w) : emit_lighting_functions(w, key);
  emit_texture_functions(w, key.textures);
  w.open("void main() {");
  w.line(pixels ? "gl_Position = position;"
         : key.parallel
             ? "gl_Position = vec4((modelview_projection * vec4(position.xyz, 1.0)).xyz, 1.0);"
         : key.w_is_one ? "gl_Position = modelview_projection * vec4(position.xyz, 1.0);"
                        : "gl_Position = modelview_projection * position;");
  if (pixels) w.line("texel = texel_position;");
  if (is_zoomed(key.pixels)) w.line("place = pixel_place;");
  if (key.depth_offset) w.line("gl_Position.z += depth_offset * gl_Position.w;");
  if (key.line_offset) w.line("gl_Position.xyz += line_offset * gl_Position.w;");
  if (key.fragments.coverage == Coverage::kSmoothPoint) emit_smooth_point(w, key, dialect);
  else if (key.points) emit_point(w, key, dialect);
  emit_clip_distances(w, key.fragments, dialect);
  emit_fog_coordinate(w, key.fragments);
  if (key.per_fragment) {
    emit_per_fragment_vertex(w, key);
  } else if (key.lit) {
    general ? emit_general_space(w, key) : emit_lighting_space(w, key);
    general ? emit_general_lights(w, key) : emit_lights(w, key);
    w.line("front_color = front_lit;");
    if (key.two_side) w.line("back_color = back_lit;");
    if (key.separate_specular) w.line("front_secondary = front_specular;");
    if (key.separate_specular && key.two_side) w.line("back_secondary = back_specular;");
  } else {
    w.line("front_color = clamp(color, 0.0, 1.0);");
    if (key.secondary_from_vertex) w.line("front_secondary = clamp(secondary_color, 0.0, 1.0);");
  }
  emit_texture_coordinates(w, key.textures);
  w.close();
  return w.text();
}

}  // namespace

ProgramSource generate(const ProgramKey& key, Dialect dialect) {
  return {vertex_shader(key, dialect), emit_fragment(key, dialect)};
}

}  // namespace legacy_gl
