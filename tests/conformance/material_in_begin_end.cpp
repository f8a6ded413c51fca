// glMaterial between glBegin and glEnd counts from the next vertex on (GL 2.1 spec 2.14.2).
#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

using Change = std::function<void(const GlFunctions&, int index)>;

void draw_fan(const GlFunctions& gl, const Change& change, GLenum mode) {
  gl.Begin(mode);
  for (int i = 0; i < 12; ++i) {
    const float angle = 0.5712F * static_cast<float>(i);
    change(gl, i);
    gl.Normal3f(0.5F * std::cos(angle), 0.5F * std::sin(angle), 0.7F);
    gl.Vertex3f(0.95F * std::cos(angle), 0.95F * std::sin(angle), 0);
  }
  gl.End();
}

Scene change_scene(std::string name, Change change, GLenum mode = GL_TRIANGLE_FAN, Draw set = {}) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            if (set) set(gl);
            draw_fan(gl, change, mode);
          }};
}

Parameters varied(int index) {
  const float f = static_cast<float>(index);
  return vec(0.5F + 0.5F * std::sin(f), 0.5F + 0.5F * std::cos(2 * f), 0.08F * f, 0.3F + 0.05F * f);
}

Change property(GLenum face, GLenum name) {
  return [=](const GlFunctions& gl, int index) { gl.Materialfv(face, name, varied(index)); };
}

void two_sided(const GlFunctions& gl) {
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  gl.Rotatef(180, 0, 1, 0);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, vec(-0.3F, 0.4F, -1, 0));
  // Seen from behind: lit with the normal turned round, so the light comes from there as well.
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 3);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(0.5F, 0.5F, 0.5F));
}

}  // namespace

std::vector<Scene> material_in_begin_end_scenes() {
  return {
      change_scene("ambient", property(GL_FRONT, GL_AMBIENT)),
      change_scene("diffuse", property(GL_FRONT, GL_DIFFUSE)),
      change_scene("specular", property(GL_FRONT, GL_SPECULAR)),
      change_scene("emission", property(GL_FRONT, GL_EMISSION)),
      change_scene("ambient_and_diffuse", property(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE)),
      change_scene("shininess",
                   [](const GlFunctions& gl, int index) {
                     gl.Materialf(GL_FRONT, GL_SHININESS, 2.0F + 9.0F * static_cast<float>(index));
                   }),
      change_scene("every_property",
                   [](const GlFunctions& gl, int index) {
                     gl.Materialfv(GL_FRONT, GL_AMBIENT, varied(index));
                     gl.Materialfv(GL_FRONT, GL_DIFFUSE, varied(index + 1));
                     gl.Materialfv(GL_FRONT, GL_SPECULAR, varied(index + 2));
                     gl.Materialf(GL_FRONT, GL_SHININESS, 4.0F + static_cast<float>(index));
                   }),
      change_scene("at_some_vertices_only",
                   [](const GlFunctions& gl, int index) {
                     if (index % 5 == 3) gl.Materialfv(GL_FRONT, GL_DIFFUSE, varied(index));
                   }),
      change_scene("flat", property(GL_FRONT, GL_DIFFUSE), GL_TRIANGLE_FAN,
                   [](const GlFunctions& gl) { gl.ShadeModel(GL_FLAT); }),
      change_scene("quads", property(GL_FRONT, GL_DIFFUSE), GL_QUADS),
      change_scene("polygon", property(GL_FRONT, GL_DIFFUSE), GL_POLYGON),
      change_scene("triangles", property(GL_FRONT, GL_EMISSION), GL_TRIANGLES),
      change_scene("line_loop", property(GL_FRONT, GL_DIFFUSE), GL_LINE_LOOP),
      // Every face shows its back, so that the material of both is that of the back; tracked or set
      // per vertex, the back's alone comes out wrong in Mesa.
      {"back_two_sided",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         two_sided(gl);
         draw_fan(gl, property(GL_BACK, GL_DIFFUSE), GL_TRIANGLE_FAN);
       },
       {.mesa_departure = "M6",
        .reference =
            [](const GlFunctions& gl) {
              begin_lit_scene(gl);
              two_sided(gl);
              draw_fan(gl, property(GL_FRONT_AND_BACK, GL_DIFFUSE), GL_TRIANGLE_FAN);
            }}},
      change_scene("both_two_sided", property(GL_FRONT_AND_BACK, GL_SPECULAR), GL_TRIANGLE_FAN,
                   two_sided),
      change_scene(
          "tracked_property_is_ignored",
          [](const GlFunctions& gl, int index) {
            gl.Color4fv(varied(index + 3));
            gl.Materialfv(GL_FRONT, GL_DIFFUSE, varied(index));
          },
          GL_TRIANGLE_FAN, [](const GlFunctions& gl) { gl.Enable(GL_COLOR_MATERIAL); }),
      change_scene(
          "color_material_and_other_property",
          [](const GlFunctions& gl, int index) {
            gl.Color4fv(varied(index + 3));
            gl.Materialfv(GL_FRONT, GL_EMISSION, vec(0.02F * static_cast<float>(index), 0, 0));
          },
          GL_TRIANGLE_FAN, [](const GlFunctions& gl) { gl.Enable(GL_COLOR_MATERIAL); }),
      {"last_value_stays_current",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         in_quarter(gl, 0, 0, [](const GlFunctions& g) {
           draw_fan(g, property(GL_FRONT, GL_DIFFUSE), GL_TRIANGLE_FAN);
         });
         in_quarter(gl, 1, 1, [](const GlFunctions& g) { draw_sphere(g); });
       }},
      {"after_the_last_vertex",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.Begin(GL_TRIANGLES);
         gl.Vertex2f(-0.9F, -0.9F);
         gl.Vertex2f(0.9F, -0.9F);
         gl.Vertex2f(0, -0.2F);
         gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0.9F, 0.2F, 0.1F));
         gl.End();
         gl.Translatef(0, 0.4F, 0);
         draw_sphere(gl, 0.5F);
       }},
  };
}

}  // namespace legacy_gl::test
