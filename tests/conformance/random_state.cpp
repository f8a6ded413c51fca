#include "conformance/random_state.hpp"

#include <random>

#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  // The standard's distributions differ between libraries; the engine does not.
  float between(float low, float high) {
    return low + (high - low) * static_cast<float>(engine_() >> 8) / 16777216.0F;
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  bool chance(int percent) { return below(100) < percent; }
  Parameters color() { return vec(between(0, 1), between(0, 1), between(0, 1), between(0.2F, 1)); }
  Parameters dark_color() {
    return vec(between(0, 0.3F), between(0, 0.3F), between(0, 0.3F), between(0.2F, 1));
  }
  // Dark enough that the sum of a few lights rarely saturates; now and then outside [0, 1].
  Parameters light_color() {
    const float low = chance(10) ? -0.3F : 0.0F;
    const float high = chance(10) ? 1.8F : 0.8F;
    return vec(between(low, high), between(low, high), between(low, high), between(0.2F, 1));
  }
  Parameters direction(float lowest_z = -1) {
    const float z = between(lowest_z, 1);
    const float angle = between(0, 6.2831853F);
    const float ring = std::sqrt(1 - z * z);
    return vec(ring * std::cos(angle), ring * std::sin(angle), z, 0);
  }

 private:
  std::mt19937 engine_;
};

enum class LightKind { off, directional, positional, attenuated, spot, attenuated_spot };

// What decides the program variant. Each structure serves four states with other values.
struct Structure {
  std::array<LightKind, 8> lights{};
  bool two_sided = false;
  bool local_viewer = false;
  bool separate_specular = false;
  bool color_material = false;
  GLenum color_material_face = GL_FRONT_AND_BACK;
  GLenum color_material_mode = GL_AMBIENT_AND_DIFFUSE;
  bool color_per_vertex = false;
  bool zero_shininess = false;
  int normal_mode = 0;  // none, normalize, rescale
  bool flat = false;
  int figure = 0;
};

constexpr int states_of_a_structure = 4;

Structure make_structure(int index) {
  Random random(20231u + static_cast<unsigned>(index));
  Structure structure;
  const int count = random.chance(15) ? random.below(9) : 1 + random.below(3);
  for (int i = 0; i < count; ++i) {
    auto& light = structure.lights[static_cast<std::size_t>(random.below(8))];
    light = static_cast<LightKind>(1 + random.below(5));
  }
  bool confined = false;
  for (const LightKind light : structure.lights) confined |= light >= LightKind::attenuated;
  structure.two_sided = random.chance(30);
  structure.local_viewer = random.chance(40);
  structure.separate_specular = random.chance(25);
  structure.color_material = random.chance(35);
  constexpr std::array<GLenum, 5> modes = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION,
                                           GL_AMBIENT_AND_DIFFUSE};
  structure.color_material_mode = modes[static_cast<std::size_t>(random.below(5))];
  structure.color_material_face = random.chance(50) ? GL_FRONT : GL_FRONT_AND_BACK;
  structure.color_per_vertex = random.chance(50);
  structure.zero_shininess = !confined && random.chance(15);
  structure.normal_mode = random.below(3);
  structure.flat = random.chance(20);
  structure.figure = random.below(4);
  return structure;
}

void set_light(const GlFunctions& gl, Random& random, GLenum light, LightKind kind) {
  if (kind == LightKind::off) {
    gl.Disable(light);
    return;
  }
  gl.Enable(light);
  gl.Lightfv(light, GL_AMBIENT, random.chance(50) ? vec(0, 0, 0) : random.dark_color());
  gl.Lightfv(light, GL_DIFFUSE, random.light_color());
  gl.Lightfv(light, GL_SPECULAR, random.light_color());
  // Most from the side of the eye, or little of the figure would be lit.
  const Parameters direction = random.direction(-0.4F);
  const float distance = kind == LightKind::directional ? 1.0F : random.between(1.7F, 4);
  Parameters position = direction;
  for (std::size_t i = 0; i < 3; ++i) position.values[i] *= distance;
  position.values[3] = kind == LightKind::directional ? 0.0F : 1.0F;
  gl.Lightfv(light, GL_POSITION, position);

  const bool attenuated = kind == LightKind::attenuated || kind == LightKind::attenuated_spot;
  gl.Lightf(light, GL_CONSTANT_ATTENUATION, attenuated ? random.between(0.1F, 1.5F) : 1.0F);
  gl.Lightf(light, GL_LINEAR_ATTENUATION, attenuated ? random.between(0, 0.5F) : 0.0F);
  gl.Lightf(light, GL_QUADRATIC_ATTENUATION, attenuated ? random.between(0, 0.3F) : 0.0F);

  const bool spot = kind == LightKind::spot || kind == LightKind::attenuated_spot;
  gl.Lightf(light, GL_SPOT_CUTOFF, spot ? random.between(5, 90) : 180.0F);
  gl.Lightf(light, GL_SPOT_EXPONENT, spot && random.chance(70) ? random.between(0, 40) : 0.0F);
  // Roughly at the figure.
  gl.Lightfv(light, GL_SPOT_DIRECTION,
             vec(random.between(-0.3F, 0.3F) - direction.values[0],
                 random.between(-0.3F, 0.3F) - direction.values[1],
                 random.between(-0.3F, 0.3F) - direction.values[2]));
}

void set_material(const GlFunctions& gl, Random& random, GLenum face, bool zero_shininess) {
  gl.Materialfv(face, GL_AMBIENT, random.color());
  gl.Materialfv(face, GL_DIFFUSE, random.color());
  gl.Materialfv(face, GL_SPECULAR, random.color());
  gl.Materialfv(face, GL_EMISSION, random.chance(60) ? vec(0, 0, 0) : random.dark_color());
  gl.Materialf(face, GL_SHININESS,
               zero_shininess ? 0.0F : random.between(0.5F, random.chance(50) ? 20 : 128));
}

void set_transform(const GlFunctions& gl, Random& random, int normal_mode) {
  gl.Disable(GL_NORMALIZE);
  gl.Disable(GL_RESCALE_NORMAL);
  if (normal_mode == 1) gl.Enable(GL_NORMALIZE);
  if (normal_mode == 2) gl.Enable(GL_RESCALE_NORMAL);
  const Parameters axis = random.direction();
  gl.Rotatef(random.between(0, 360), axis.values[0], axis.values[1], axis.values[2]);
  const float scale = random.between(0.5F, 1.2F);
  if (normal_mode == 1) gl.Scalef(scale, random.between(0.5F, 1.2F), random.between(0.5F, 1.2F));
  else gl.Scalef(scale, scale, scale);
}

void draw_figure(const GlFunctions& gl, const Structure& structure) {
  if (structure.color_per_vertex) {
    draw_colored_sphere(gl, 0.9F);
    return;
  }
  switch (structure.figure) {
    case 0: return draw_sphere(gl, 0.9F, 12, 8);
    case 1: return draw_torus(gl, 0.3F, 0.6F);
    case 2: return draw_half_tube(gl);
    default: return draw_cube(gl, 0.6F);
  }
}

}  // namespace

void draw_random_state(const GlFunctions& gl, int index) {
  const Structure structure = make_structure(index / states_of_a_structure);
  Random random(77000u + static_cast<unsigned>(index));

  begin_scene(gl);
  gl.Viewport(0, 0, random_state_size, random_state_size);
  gl.Enable(GL_LIGHTING);
  gl.Disable(GL_COLOR_MATERIAL);
  gl.ShadeModel(structure.flat ? GL_FLAT : GL_SMOOTH);
  gl.FrontFace(random.chance(20) ? GL_CW : GL_CCW);

  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, random.dark_color());
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, structure.two_sided ? GL_TRUE : GL_FALSE);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, structure.local_viewer ? GL_TRUE : GL_FALSE);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                 structure.separate_specular ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  for (std::size_t i = 0; i < 8; ++i)
    set_light(gl, random, GL_LIGHT0 + static_cast<GLenum>(i), structure.lights[i]);
  set_material(gl, random, GL_FRONT, structure.zero_shininess);
  set_material(gl, random, GL_BACK, structure.zero_shininess);
  if (structure.color_material) {
    gl.ColorMaterial(structure.color_material_face, structure.color_material_mode);
    gl.Enable(GL_COLOR_MATERIAL);
  }
  gl.Color4fv(random.color());
  set_transform(gl, random, structure.normal_mode);
  draw_figure(gl, structure);
}

}  // namespace legacy_gl::test
