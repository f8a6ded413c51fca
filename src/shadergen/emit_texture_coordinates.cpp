#include "shadergen/emit_texture.hpp"
#include "shadergen/uniform_blocks.hpp"

namespace legacy_gl {

namespace {

/// What the fragment reads: s and t; r for three dimensions, cube maps and comparison; q.
unsigned varying_size(const TextureStageKey& stage) {
  const bool three =
      stage.kind == TextureKind::k3D || stage.kind == TextureKind::kCube || stage.shadow;
  return (three ? 3u : 2u) + (stage.projective ? 1u : 0u);
}

bool reads_eye(const TextureStageKey& stage) {
  return stage.generates(CoordinateSource::kSphere) ||
         stage.generates(CoordinateSource::kReflection);
}

std::string component(const TextureStageKey& stage, const std::string& unit, unsigned i) {
  const std::string name(1, "xyzw"[i]);
  switch (stage.sources[i]) {
    case CoordinateSource::kVertex: return "texcoord" + unit + "." + name;
    case CoordinateSource::kLinear:
      return "dot(units[" + unit + "].planes[" + std::to_string(i) + "], position)";
    case CoordinateSource::kSphere: return "sphere." + name;
    case CoordinateSource::kReflection: return "reflected." + name;
    case CoordinateSource::kNormal: return "normal_eye." + name;
  }
  return "0.0";
}

/// GL 2.1 spec 2.11.4: u is the unit vector from the eye to the vertex, r its reflection.
void emit_generation(Writer& w, const TextureKey& key) {
  bool eye = false, sphere = false;
  for (unsigned i = 0; i < key.count; ++i) {
    eye |= reads_eye(key.stages[i]);
    sphere |= key.stages[i].generates(CoordinateSource::kSphere);
  }
  const std::string normal = "texgen_normal_matrix * normal";
  w.line("vec3 normal_eye = " + (key.normalize ? "texgen_unit(" + normal + ")" : normal) + ";");
  if (!eye) return;
  w.line("vec3 to_vertex = texgen_unit((texgen_modelview * position).xyz);");
  w.line("vec3 reflected = to_vertex - 2.0 * dot(normal_eye, to_vertex) * normal_eye;");
  if (!sphere) return;
  w.line("vec3 toward = reflected + vec3(0.0, 0.0, 1.0);");
  w.line(
      "vec2 sphere = reflected.xy * (0.5 * inversesqrt(max(dot(toward, toward), 1e-37))) + 0.5;");
}

}  // namespace

bool vertex_reads_texture_block(const TextureKey& key) {
  for (unsigned i = 0; i < key.count; ++i) {
    const TextureStageKey& stage = key.stages[i];
    if (stage.kind == TextureKind::kNone) continue;
    if (stage.matrix || stage.reads_normal() || stage.generates(CoordinateSource::kLinear))
      return true;
  }
  return false;
}

void emit_texture_block(Writer& w, const TextureKey& key) {
  w.raw(kTextureUnitStructText);
  w.raw(kTexturesHeadText);
  w.line("  TextureUnit units[" + std::to_string(key.count) + "];");
  w.line("};");
  w.blank();
}

void emit_texture_varyings(Writer& w, const TextureKey& key, const std::string& direction) {
  for (unsigned i = 0; i < key.count; ++i)
    if (key.stages[i].kind != TextureKind::kNone)
      w.line(direction + " vec" + std::to_string(varying_size(key.stages[i])) + " coordinate" +
             std::to_string(i) + ";");
}

void emit_texture_functions(Writer& w, const TextureKey& key) {
  if (!key.reads_normal()) return;
  w.raw(R"(vec3 texgen_unit(vec3 v) {
  return v * inversesqrt(max(dot(v, v), 1e-37));
}

)");
}

void emit_texture_coordinates(Writer& w, const TextureKey& key) {
  if (key.reads_normal()) emit_generation(w, key);
  for (unsigned i = 0; i < key.count; ++i) {
    const TextureStageKey& stage = key.stages[i];
    if (stage.kind == TextureKind::kNone) continue;
    const std::string unit = std::to_string(i);
    std::string source = "texcoord" + unit;
    if (stage.generates(CoordinateSource::kVertex) &&
        std::count(stage.sources.begin(), stage.sources.end(), CoordinateSource::kVertex) == 4) {
      if (stage.matrix) source = "(units[" + unit + "].matrix * " + source + ")";
    } else {
      std::string all;
      for (unsigned c = 0; c < 4; ++c) all += (c ? ", " : "") + component(stage, unit, c);
      source = "vec4(" + all + ")";
      if (stage.matrix) source = "(units[" + unit + "].matrix * " + source + ")";
    }
    const bool one_dimension = stage.kind == TextureKind::k1D;
    if (one_dimension) {  // the middle of the only row
      w.line("vec4 transformed" + unit + " = " + source + ";");
      source = "transformed" + unit;
    }
    const std::string target = "coordinate" + unit + " = ";
    if (one_dimension && stage.shadow)
      w.line(target + (stage.projective
                           ? "vec4(" + source + ".x, 0.5 * " + source + ".w, " + source + ".zw);"
                           : "vec3(" + source + ".x, 0.5, " + source + ".z);"));
    else if (one_dimension)
      w.line(target + (stage.projective
                           ? "vec3(" + source + ".x, 0.5 * " + source + ".w, " + source + ".w);"
                           : "vec2(" + source + ".x, 0.5);"));
    else if (varying_size(stage) == 4) w.line(target + source + ";");
    else if (varying_size(stage) == 2) w.line(target + source + ".xy;");
    else w.line(target + source + (stage.projective ? ".xyw;" : ".xyz;"));
  }
}

}  // namespace legacy_gl
