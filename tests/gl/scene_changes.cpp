#include "scene_changes.hpp"

#include <array>
#include <cmath>

namespace legacy_gl::test {

namespace {

void light(const GlFunctions& gl, GLenum name, GLenum pname, float a, float b, float c, float d) {
  const float values[] = {a, b, c, d};
  gl.Lightfv(name, pname, values);
}

void material(const GlFunctions& gl, GLenum face, GLenum pname, float a, float b, float c) {
  const float values[] = {a, b, c, 0.75f};
  gl.Materialfv(face, pname, values);
}

void stipple(const GlFunctions& gl, unsigned first) {
  std::array<GLubyte, 128> mask{};
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = static_cast<GLubyte>(first + 7 * i);
  gl.PolygonStipple(mask.data());
}

}  // namespace

void set_up_scene(const GlFunctions& gl) {
  gl.Viewport(0, 0, 64, 64);
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustum(-1, 1, -1, 1, 2, 20);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Translatef(0, 0, -4);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_DEPTH_TEST);
  material(gl, GL_FRONT_AND_BACK, GL_SPECULAR, 0.6f, 0.5f, 0.4f);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 12);
  light(gl, GL_LIGHT0, GL_POSITION, 0.5f, 0.7f, 1, 0);
  light(gl, GL_LIGHT1, GL_DIFFUSE, 0.9f, 0.3f, 0.2f, 1);
}

void draw_scene(const GlFunctions& gl) {
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int i = 0; i < 8; ++i) {
    gl.Begin(i % 2 ? GL_TRIANGLES : GL_QUADS);
    for (int corner = 0; corner < (i % 2 ? 3 : 4); ++corner) {
      const float u = static_cast<float>(i + (corner == 1 || corner == 2)) / 8;
      const float v = corner >= 2 ? 1.0f : 0.0f;
      gl.Color4f(u, v, 1 - u, 0.5f + 0.5f * v);
      gl.Normal3f(std::sin(3 * u - 1.5f), v - 0.5f, std::cos(4 * u));
      gl.Vertex3f(3.2f * u - 1.6f, 2.4f * v - 1.2f, std::sin(6 * u));
    }
    gl.End();
  }
  gl.Begin(GL_LINES);
  gl.Normal3f(0, 0.6f, 0.8f);
  gl.Vertex3f(-1.8f, -1.5f, 1);
  gl.Vertex3f(1.8f, 1.4f, 1);
  gl.End();
  gl.Begin(GL_POINTS);
  gl.Vertex3f(-0.9f, 1.3f, 1.2f);
  gl.End();
  // The initial current values: what tracks the current colour does not depend on how often this
  // was drawn.
  gl.Color4f(1, 1, 1, 1);
  gl.Normal3f(0, 0, 1);
}

const std::vector<SceneChange>& scene_changes() {
  using Gl = const GlFunctions&;
  static const std::vector<SceneChange> changes{
      {"light position", [](Gl gl) { light(gl, GL_LIGHT0, GL_POSITION, -0.5f, 0.2f, 0.6f, 0); }},
      {"positional light", [](Gl gl) { light(gl, GL_LIGHT0, GL_POSITION, 0.5f, 0.5f, 2, 1); }},
      {"light diffuse", [](Gl gl) { light(gl, GL_LIGHT0, GL_DIFFUSE, 0.1f, 0.9f, 0.4f, 1); }},
      {"light specular", [](Gl gl) { light(gl, GL_LIGHT0, GL_SPECULAR, 0.9f, 0.1f, 0.7f, 1); }},
      {"light ambient", [](Gl gl) { light(gl, GL_LIGHT0, GL_AMBIENT, 0.3f, 0.1f, 0.2f, 1); }},
      {"attenuation", [](Gl gl) { gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.4f); }},
      {"quadratic", [](Gl gl) { gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.1f); }},
      {"constant attenuation", [](Gl gl) { gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1.5f); }},
      {"spot cutoff", [](Gl gl) { gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 40); }},
      {"spot exponent", [](Gl gl) { gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 5); }},
      {"spot direction",
       [](Gl gl) { light(gl, GL_LIGHT0, GL_SPOT_DIRECTION, 0.2f, -0.3f, -1, 0); }},
      {"no cutoff", [](Gl gl) { gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 180); }},
      {"second light", [](Gl gl) { gl.Enable(GL_LIGHT1); }},
      {"first light off", [](Gl gl) { gl.Disable(GL_LIGHT0); }},
      {"first light on", [](Gl gl) { gl.Enable(GL_LIGHT0); }},
      {"material diffuse", [](Gl gl) { material(gl, GL_FRONT, GL_DIFFUSE, 0.2f, 0.6f, 0.9f); }},
      {"material ambient", [](Gl gl) { material(gl, GL_FRONT, GL_AMBIENT, 0.7f, 0.2f, 0.1f); }},
      {"material specular", [](Gl gl) { material(gl, GL_FRONT, GL_SPECULAR, 0, 0, 0); }},
      {"specular again", [](Gl gl) { material(gl, GL_FRONT, GL_SPECULAR, 0.3f, 0.9f, 0.5f); }},
      {"emission", [](Gl gl) { material(gl, GL_FRONT, GL_EMISSION, 0.1f, 0.0f, 0.2f); }},
      {"shininess", [](Gl gl) { gl.Materialf(GL_FRONT, GL_SHININESS, 31); }},
      {"fractional shininess", [](Gl gl) { gl.Materialf(GL_FRONT, GL_SHININESS, 3.5f); }},
      {"back material", [](Gl gl) { material(gl, GL_BACK, GL_DIFFUSE, 0.9f, 0.1f, 0.1f); }},
      {"two-sided", [](Gl gl) { gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); }},
      {"front face", [](Gl gl) { gl.FrontFace(GL_CW); }},
      {"cull back", [](Gl gl) { gl.Enable(GL_CULL_FACE); }},
      {"cull front", [](Gl gl) { gl.CullFace(GL_FRONT); }},
      {"no cull", [](Gl gl) { gl.Disable(GL_CULL_FACE); }},
      {"local viewer", [](Gl gl) { gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); }},
      {"separate specular",
       [](Gl gl) { gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR); }},
      {"fog", [](Gl gl) { gl.Enable(GL_FOG); }},
      {"fog density", [](Gl gl) { gl.Fogf(GL_FOG_DENSITY, 0.2f); }},
      {"fog color",
       [](Gl gl) {
         const float color[] = {0.2f, 0.9f, 0.4f, 1};
         gl.Fogfv(GL_FOG_COLOR, color);
       }},
      {"squared fog", [](Gl gl) { gl.Fogi(GL_FOG_MODE, GL_EXP2); }},
      {"linear fog",
       [](Gl gl) {
         gl.Fogi(GL_FOG_MODE, GL_LINEAR);
         gl.Fogf(GL_FOG_END, 9);
       }},
      {"fog start", [](Gl gl) { gl.Fogf(GL_FOG_START, 2); }},
      {"fog by coordinate",
       [](Gl gl) {
         gl.FogCoordf(4);
         gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
       }},
      {"no fog", [](Gl gl) { gl.Disable(GL_FOG); }},
      {"alpha test",
       [](Gl gl) {
         gl.Enable(GL_ALPHA_TEST);
         gl.AlphaFunc(GL_GREATER, 0.8f);
       }},
      {"alpha reference", [](Gl gl) { gl.AlphaFunc(GL_GREATER, 0.6f); }},
      {"alpha function", [](Gl gl) { gl.AlphaFunc(GL_LEQUAL, 0.6f); }},
      {"no alpha test", [](Gl gl) { gl.Disable(GL_ALPHA_TEST); }},
      {"clip plane",
       [](Gl gl) {
         const double plane[] = {1, 0.3, 0, 0.2};
         gl.ClipPlane(GL_CLIP_PLANE0, plane);
         gl.Enable(GL_CLIP_PLANE0);
       }},
      {"other plane",
       [](Gl gl) {
         const double plane[] = {-0.2, 1, 0, 0.4};
         gl.ClipPlane(GL_CLIP_PLANE0, plane);
       }},
      {"no clip plane", [](Gl gl) { gl.Disable(GL_CLIP_PLANE0); }},
      {"global ambient",
       [](Gl gl) {
         const float ambient[] = {0.4f, 0.1f, 0.5f, 1};
         gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
       }},
      {"color material", [](Gl gl) { gl.Enable(GL_COLOR_MATERIAL); }},
      {"tracks emission", [](Gl gl) { gl.ColorMaterial(GL_FRONT_AND_BACK, GL_EMISSION); }},
      {"color material off", [](Gl gl) { gl.Disable(GL_COLOR_MATERIAL); }},
      {"flat", [](Gl gl) { gl.ShadeModel(GL_FLAT); }},
      {"smooth", [](Gl gl) { gl.ShadeModel(GL_SMOOTH); }},
      {"scale", [](Gl gl) { gl.Scalef(0.8f, 0.8f, 0.8f); }},
      {"normalize", [](Gl gl) { gl.Enable(GL_NORMALIZE); }},
      {"stretch", [](Gl gl) { gl.Scalef(1.2f, 0.7f, 1); }},
      {"normalize off", [](Gl gl) { gl.Disable(GL_NORMALIZE); }},
      {"rescale", [](Gl gl) { gl.Enable(GL_RESCALE_NORMAL); }},
      {"rotate", [](Gl gl) { gl.Rotatef(20, 0.3f, 1, 0.1f); }},
      {"translate", [](Gl gl) { gl.Translatef(0.1f, -0.1f, 0.2f); }},
      {"parallel projection",
       [](Gl gl) {
         gl.MatrixMode(GL_PROJECTION);
         gl.LoadIdentity();
         gl.Ortho(-2, 2, -2, 2, 2, 20);
         gl.MatrixMode(GL_MODELVIEW);
       }},
      {"perspective",
       [](Gl gl) {
         gl.MatrixMode(GL_PROJECTION);
         gl.LoadIdentity();
         gl.Frustum(-1, 1, -1, 1, 2, 20);
         gl.MatrixMode(GL_MODELVIEW);
       }},
      {"projection",
       [](Gl gl) {
         gl.MatrixMode(GL_PROJECTION);
         gl.Scalef(0.9f, 0.9f, 1);
         gl.MatrixMode(GL_MODELVIEW);
       }},
      {"point size", [](Gl gl) { gl.PointSize(5); }},
      {"point attenuation",
       [](Gl gl) {
         constexpr GLfloat attenuation[] = {0.01F, 0.01F, 0.02F};
         gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, attenuation);
       }},
      {"least point size", [](Gl gl) { gl.PointParameterf(GL_POINT_SIZE_MIN, 9); }},
      {"line width", [](Gl gl) { gl.LineWidth(3); }},
      {"viewport", [](Gl gl) { gl.Viewport(4, 2, 56, 60); }},
      {"polygon stipple",
       [](Gl gl) {
         stipple(gl, 0x33);
         gl.Enable(GL_POLYGON_STIPPLE);
       }},
      {"stipple pattern", [](Gl gl) { stipple(gl, 0x1e); }},
      {"no polygon stipple", [](Gl gl) { gl.Disable(GL_POLYGON_STIPPLE); }},
      {"smooth points", [](Gl gl) { gl.Enable(GL_POINT_SMOOTH); }},
      {"size of smooth points", [](Gl gl) { gl.PointSize(6.4f); }},
      {"no smooth points", [](Gl gl) { gl.Disable(GL_POINT_SMOOTH); }},
      {"line stipple",
       [](Gl gl) {
         gl.LineStipple(1, 0x3939);
         gl.Enable(GL_LINE_STIPPLE);
       }},
      {"line stipple's factor", [](Gl gl) { gl.LineStipple(2, 0x3939); }},
      {"line stipple's pattern", [](Gl gl) { gl.LineStipple(2, 0x0f35); }},
      {"no line stipple", [](Gl gl) { gl.Disable(GL_LINE_STIPPLE); }},
      {"lighting off", [](Gl gl) { gl.Disable(GL_LIGHTING); }},
      {"color sum",
       [](Gl gl) {
         gl.Enable(GL_COLOR_SUM);
         gl.SecondaryColor3f(0.2f, 0.1f, 0);
       }},
      {"lighting on", [](Gl gl) { gl.Enable(GL_LIGHTING); }},
  };
  return changes;
}

}  // namespace legacy_gl::test
