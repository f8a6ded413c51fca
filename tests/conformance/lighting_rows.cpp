// Each row of the lighting equation (GL 2.1 spec 2.14.1, table 2.10) alone and in pairs, over a
// scene in which nothing else is on. In every row that attenuates or confines a light the shininess
// is not 0: there Mesa departs from the specification (departures.cpp).
#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

struct Row {
  const char* name;
  void (*set)(const GlFunctions&);
};

constexpr Row rows[] = {
    {"emission",
     [](const GlFunctions& gl) {
       gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, vec(0.2F, 0.05F, 0.1F));
     }},
    {"global_ambient",
     [](const GlFunctions& gl) {
       gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, vec(0.3F, 0.6F, 0.2F));
       gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(0.5F, 0.3F, 0.7F));
     }},
    {"light_ambient",
     [](const GlFunctions& gl) { gl.Lightfv(GL_LIGHT0, GL_AMBIENT, vec(0.3F, 0.2F, 0.1F)); }},
    {"diffuse",
     [](const GlFunctions& gl) {
       gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, vec(0.8F, 0.4F, 0.2F, 0.5F));
       gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, vec(0.7F, 0.8F, 0.9F));
     }},
    {"specular",
     [](const GlFunctions& gl) {
       gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, vec(0.9F, 0.7F, 0.5F));
       gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 7.5F);
       gl.Lightfv(GL_LIGHT0, GL_SPECULAR, vec(1.0F, 0.6F, 0.8F));
     }},
    {"positional",
     [](const GlFunctions& gl) { gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(1.2F, 1.5F, 2.0F)); }},
    {"constant_attenuation",
     [](const GlFunctions& gl) {
       gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(1.2F, 1.5F, 2.0F));
       gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1.7F);
     }},
    {"linear_attenuation",
     [](const GlFunctions& gl) {
       gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(1.2F, 1.5F, 2.0F));
       gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.2F);
     }},
    {"quadratic_attenuation",
     [](const GlFunctions& gl) {
       gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(1.2F, 1.5F, 2.0F));
       gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.1F);
     }},
    {"spot",
     [](const GlFunctions& gl) {
       gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(1.2F, 1.5F, 2.0F));
       gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, vec(-1.2F, -1.4F, -2.0F));
       gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 20);
       gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 9);
     }},
    {"local_viewer",
     [](const GlFunctions& gl) { gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE); }},
    {"separate_specular",
     [](const GlFunctions& gl) {
       gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, vec(1.0F, 0.8F, 0.9F));
       gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
     }},
    {"two_side",
     [](const GlFunctions& gl) {
       gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
       gl.Materialfv(GL_BACK, GL_DIFFUSE, vec(0.7F, 0.2F, 0.4F));
       gl.Materialf(GL_BACK, GL_SHININESS, 4);
     }},
    {"color_material",
     [](const GlFunctions& gl) {
       gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
       gl.Enable(GL_COLOR_MATERIAL);
       gl.Color4f(0.9F, 0.7F, 0.3F, 0.6F);
     }},
    {"normalize",
     [](const GlFunctions& gl) {
       gl.Scalef(1.2F, 0.7F, 0.9F);
       gl.Enable(GL_NORMALIZE);
     }},
    {"second_light",
     [](const GlFunctions& gl) {
       use_positional_light(gl, GL_LIGHT1, vec(-1, -0.5F, 0.6F, 0), vec(0.5F, 0.1F, 0.2F));
     }},
};

void draw_rows(const GlFunctions& gl, const Row& first, const Row* second) {
  begin_lit_scene(gl);
  first.set(gl);
  if (second != nullptr) second->set(gl);
  // The half tube alone shows back faces, the sphere a whole highlight.
  gl.Translatef(-0.5F, 0.2F, 0);
  draw_half_tube(gl, 0.5F);
  gl.Translatef(0.95F, -0.4F, 0);
  draw_sphere(gl, 0.5F);
}

}  // namespace

std::vector<Scene> lighting_rows_scenes() {
  std::vector<Scene> scenes;
  for (const Row& row : rows)
    scenes.push_back({row.name, [&row](const GlFunctions& gl) { draw_rows(gl, row, nullptr); }});
  for (const Row& first : rows) {
    for (const Row* second = &first + 1; second != std::end(rows); ++second) {
      scenes.push_back({std::string(first.name) + "_and_" + second->name,
                        [&first, second](const GlFunctions& gl) { draw_rows(gl, first, second); }});
    }
  }
  return scenes;
}

}  // namespace legacy_gl::test
