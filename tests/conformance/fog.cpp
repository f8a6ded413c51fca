// Fog of all modes and sources, over lit and unlit figures that reach from near to far.
#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

void draw_row(const GlFunctions& gl) {
  for (int i = 0; i < 5; ++i) {
    gl.PushMatrix();
    gl.Translatef(0.5F * static_cast<float>(i) - 1, 0.1F, 1.2F - 0.9F * static_cast<float>(i));
    draw_sphere(gl, 0.4F, 12, 8);
    gl.PopMatrix();
  }
}

void use_fog(const GlFunctions& gl, GLenum mode) {
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, static_cast<GLint>(mode));
  gl.Fogfv(GL_FOG_COLOR, vec(0.5F, 0.6F, 0.8F));
  gl.Fogf(GL_FOG_START, 2);
  gl.Fogf(GL_FOG_END, 7);
  gl.Fogf(GL_FOG_DENSITY, 0.2F);
}

Scene fog_scene(std::string name, GLenum mode, Draw set = {}) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            use_fog(gl, mode);
            if (set) set(gl);
            draw_row(gl);
          }};
}

Scene coordinate_scene(std::string name, Draw draw) {
  return {std::move(name), [draw = std::move(draw)](const GlFunctions& gl) {
            begin_flat_scene(gl);
            use_fog(gl, GL_LINEAR);
            gl.Fogf(GL_FOG_START, 0);
            gl.Fogf(GL_FOG_END, 1);
            gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
            gl.Color3f(1, 0.3F, 0.1F);
            draw(gl);
          }};
}

void draw_square_of_coordinates(const GlFunctions& gl) {
  gl.Begin(GL_QUADS);
  gl.FogCoordf(0);
  gl.Vertex2f(-0.9F, -0.9F);
  gl.FogCoordf(0.4F);
  gl.Vertex2f(0.9F, -0.9F);
  gl.FogCoordd(1.2);
  gl.Vertex2f(0.9F, 0.9F);
  gl.FogCoordf(0.7F);
  gl.Vertex2f(-0.9F, 0.9F);
  gl.End();
}

}  // namespace

std::vector<Scene> fog_scenes() {
  return {
      fog_scene("linear", GL_LINEAR),
      fog_scene("exp", GL_EXP),
      fog_scene("exp2", GL_EXP2),
      fog_scene("initial_parameters", GL_EXP,
                [](const GlFunctions& gl) { gl.Fogf(GL_FOG_DENSITY, 1); }),
      fog_scene("start_is_end", GL_LINEAR, [](const GlFunctions& gl) { gl.Fogf(GL_FOG_END, 2); }),
      fog_scene("end_before_start", GL_LINEAR,
                [](const GlFunctions& gl) {
                  gl.Fogf(GL_FOG_START, 6);
                  gl.Fogf(GL_FOG_END, 1);
                }),
      fog_scene("separate_specular", GL_LINEAR,
                [](const GlFunctions& gl) {
                  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
                }),
      fog_scene("two_side", GL_EXP,
                [](const GlFunctions& gl) {
                  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
                  gl.FrontFace(GL_CW);
                }),
      fog_scene("flat", GL_LINEAR, [](const GlFunctions& gl) { gl.ShadeModel(GL_FLAT); }),
      fog_scene("blended", GL_LINEAR,
                [](const GlFunctions& gl) {
                  gl.Enable(GL_BLEND);
                  gl.BlendFunc(GL_ONE, GL_ONE);
                }),
      fog_scene("integer_color", GL_LINEAR,
                [](const GlFunctions& gl) {
                  const GLint color[] = {2147483647, 0, 1073741824, 0};
                  gl.Fogiv(GL_FOG_COLOR, color);
                }),
      fog_scene("unlit", GL_LINEAR,
                [](const GlFunctions& gl) {
                  gl.Disable(GL_LIGHTING);
                  gl.Color3f(0.9F, 0.4F, 0.1F);
                }),
      fog_scene("lines", GL_LINEAR,
                [](const GlFunctions& gl) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); }),
      fog_scene("attribute_group", GL_LINEAR,
                [](const GlFunctions& gl) {
                  gl.PushAttrib(GL_FOG_BIT);
                  gl.Fogi(GL_FOG_MODE, GL_EXP2);
                  gl.Fogfv(GL_FOG_COLOR, vec(1, 0, 0));
                  gl.Fogf(GL_FOG_END, 3);
                  gl.PopAttrib();
                }),
      fog_scene("enable_group", GL_LINEAR,
                [](const GlFunctions& gl) {
                  gl.PushAttrib(GL_ENABLE_BIT);
                  gl.Disable(GL_FOG);
                  gl.PopAttrib();
                }),
      coordinate_scene("coordinates", draw_square_of_coordinates),
      coordinate_scene("coordinates_in_a_list",
                       [](const GlFunctions& gl) {
                         const GLuint list = gl.GenLists(1);
                         gl.NewList(list, GL_COMPILE);
                         draw_square_of_coordinates(gl);
                         gl.EndList();
                         gl.CallList(list);
                       }),
      coordinate_scene("coordinate_array",
                       [](const GlFunctions& gl) {
                         static constexpr GLfloat positions[] = {-1, -1, 1, -1, -1, 1, 1, 1};
                         static constexpr GLfloat coordinates[] = {0, 0.3F, 0.9F, 0.5F};
                         gl.EnableClientState(GL_VERTEX_ARRAY);
                         gl.EnableClientState(GL_FOG_COORD_ARRAY);
                         gl.VertexPointer(2, GL_FLOAT, 0, positions);
                         gl.FogCoordPointer(GL_FLOAT, 0, coordinates);
                         gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
                         gl.DisableClientState(GL_FOG_COORD_ARRAY);
                         gl.DisableClientState(GL_VERTEX_ARRAY);
                       }),
      coordinate_scene("current_coordinate",
                       [](const GlFunctions& gl) {
                         gl.FogCoordf(0.25F);
                         for (int i = 0; i < 5; ++i) {
                           const float x = 0.2F * static_cast<float>(i);
                           gl.Color3f(x, 1 - x, 0.5F);
                           gl.Rectf(2 * x - 1, -1, 2 * x - 0.7F, 1);
                         }
                       }),
  };
}

}  // namespace legacy_gl::test
