// GL 2.1 spec 5.4. Lists are compiled from the calls that immediate mode makes.
#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

void compile(const GlFunctions& gl, GLuint list, const Draw& calls) {
  gl.NewList(list, GL_COMPILE);
  calls(gl);
  gl.EndList();
}

// Four lists that draw a cube, a sphere, a torus and a patch in a quarter of the view each.
void compile_figures(const GlFunctions& gl, GLuint first) {
  const Draw figures[] = {[](const GlFunctions& g) { draw_cube(g, 0.5F); },
                          [](const GlFunctions& g) { draw_sphere(g); },
                          [](const GlFunctions& g) { draw_torus(g); },
                          [](const GlFunctions& g) { draw_patch(g, 3); }};
  for (GLuint i = 0; i < 4; ++i) {
    compile(gl, first + i, [&figures, i](const GlFunctions& g) {
      g.PushMatrix();
      g.Translatef(i % 2 == 0 ? -0.5F : 0.5F, i < 2 ? -0.5F : 0.5F, 0);
      g.Scalef(0.4F, 0.4F, 0.4F);
      g.Rotatef(25, 1, 1, 0);
      figures[i](g);
      g.PopMatrix();
    });
  }
}

template <typename Index>
Scene call_lists_scene(std::string name, GLenum type) {
  return {std::move(name), [type](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.Enable(GL_NORMALIZE);
            compile_figures(gl, 40);
            gl.ListBase(38);
            const std::array<Index, 3> names = {Index{2}, Index{5}, Index{4}};
            gl.CallLists(3, type, names.data());
          }};
}

// GL_2_BYTES and its siblings: big-endian bytes.
Scene byte_lists_scene(std::string name, GLenum type, std::vector<GLubyte> bytes, GLsizei count) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.Enable(GL_NORMALIZE);
            compile_figures(gl, 300);
            gl.CallLists(count, type, bytes.data());
          }};
}

}  // namespace

std::vector<Scene> lists_scenes() {
  return {
      {"compile_then_call",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         compile(gl, 1, [](const GlFunctions& g) { draw_sphere(g); });
         gl.CallList(1);
       }},
      {"compile_and_execute",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.NewList(1, GL_COMPILE_AND_EXECUTE);
         draw_sphere(gl, 0.7F);
         gl.Translatef(0.5F, 0.5F, 0);
         gl.EndList();
         gl.CallList(1);
       }},
      {"compile_alone_changes_nothing",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         compile(gl, 1, [](const GlFunctions& g) {
           g.Disable(GL_LIGHTING);
           g.Translatef(5, 0, 0);
           g.Color3f(1, 0, 0);
         });
         draw_sphere(gl);
       }},
      {"state_in_a_list",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         compile(gl, 1, [](const GlFunctions& g) {
           use_brass(g, GL_FRONT);
           g.Lightfv(GL_LIGHT0, GL_POSITION, vec(-1, 0.5F, 1, 0));
           g.Lightfv(GL_LIGHT0, GL_AMBIENT, vec(0.1F, 0.1F, 0.2F));
           g.LightModelfv(GL_LIGHT_MODEL_AMBIENT, vec(0.4F, 0.2F, 0.2F));
           g.ShadeModel(GL_FLAT);
           g.Rotatef(30, 0, 1, 0);
         });
         gl.CallList(1);
         draw_torus(gl);
       }},
      // The pointed-to values are copied when the list is compiled.
      {"parameters_are_copied",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         std::array<GLfloat, 4> color = {0.9F, 0.3F, 0.1F, 1};
         compile(gl, 1, [&color](const GlFunctions& g) {
           g.Materialfv(GL_FRONT, GL_DIFFUSE, color.data());
         });
         color = {0, 0, 1, 1};
         gl.CallList(1);
         draw_sphere(gl);
       }},
      {"nested",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.Enable(GL_NORMALIZE);
         compile(gl, 1, [](const GlFunctions& g) { draw_cube(g, 0.25F); });
         compile(gl, 2, [](const GlFunctions& g) {
           for (int i = 0; i < 6; ++i) {
             g.PushMatrix();
             g.Rotatef(60.0F * static_cast<float>(i), 0, 0, 1);
             g.Translatef(0.65F, 0, 0);
             g.CallList(1);
             g.PopMatrix();
           }
         });
         compile(gl, 3, [](const GlFunctions& g) {
           use_turquoise(g, GL_FRONT);
           g.CallList(2);
           g.Scalef(0.45F, 0.45F, 0.45F);
           use_brass(g, GL_FRONT);
           g.CallList(2);
         });
         gl.CallList(3);
       }},
      // What a called list contains is looked up at the call, not when the caller was compiled.
      {"redefined_after_it_was_nested",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         compile(gl, 1, [](const GlFunctions& g) { draw_cube(g, 0.5F); });
         compile(gl, 2, [](const GlFunctions& g) { g.CallList(1); });
         compile(gl, 1, [](const GlFunctions& g) { draw_torus(g); });
         gl.CallList(2);
       }},
      {"list_called_inside_begin_end",
       [](const GlFunctions& gl) {
         begin_scene(gl);
         compile(gl, 1, [](const GlFunctions& g) {
           g.Color4f(1, 0.5F, 0, 1);
           g.Vertex2f(-0.7F, 0.6F);
           g.Color4f(0, 0.5F, 1, 1);
         });
         gl.Begin(GL_TRIANGLES);
         gl.Color4f(0.2F, 1, 0.2F, 1);
         gl.Vertex2f(-0.9F, -0.8F);
         gl.Vertex2f(0.9F, -0.8F);
         gl.CallList(1);
         gl.Vertex2f(0.9F, -0.6F);
         gl.Vertex2f(0.8F, 0.8F);
         gl.CallList(1);
         gl.End();
       }},
      {"begin_in_a_list_end_outside",
       [](const GlFunctions& gl) {
         begin_scene(gl);
         compile(gl, 1, [](const GlFunctions& g) {
           g.Begin(GL_TRIANGLE_FAN);
           g.Color4f(1, 1, 0, 1);
           g.Vertex2f(0, 0);
         });
         gl.CallList(1);
         for (int i = 0; i < 9; ++i) {
           const float angle = 0.7F * static_cast<float>(i);
           gl.Color4f(0.1F * static_cast<float>(i), 0.3F, 0.8F, 1);
           gl.Vertex2f(0.9F * std::cos(angle), 0.9F * std::sin(angle));
         }
         gl.End();
       }},
      {"current_values_left_by_a_list",
       [](const GlFunctions& gl) {
         begin_scene(gl);
         compile(gl, 1, [](const GlFunctions& g) {
           g.Begin(GL_TRIANGLES);
           g.Color4f(1, 0, 0, 1);
           g.Vertex2f(-0.9F, -0.9F);
           g.Color4f(0, 1, 0, 1);
           g.Vertex2f(0, -0.9F);
           g.Color4f(0.3F, 0.4F, 0.9F, 1);
           g.Vertex2f(-0.5F, 0.5F);
           g.End();
         });
         gl.CallList(1);
         gl.Begin(GL_TRIANGLES);
         gl.Vertex2f(0.1F, -0.9F);
         gl.Vertex2f(0.9F, -0.9F);
         gl.Color4f(1, 1, 1, 1);
         gl.Vertex2f(0.5F, 0.8F);
         gl.End();
       }},
      // A list that sets no colour draws with the colour that is current at the call.
      {"current_values_taken_at_the_call",
       [](const GlFunctions& gl) {
         begin_scene(gl);
         compile(gl, 1, [](const GlFunctions& g) { draw_cube(g, 0.6F); });
         for (int i = 0; i < 4; ++i) {
           gl.Color4f(0.3F * static_cast<float>(i), 0.9F, 0.4F, 1);
           in_quarter(gl, i % 2, i / 2, [](const GlFunctions& g) { g.CallList(1); });
         }
       }},
      {"same_list_under_other_lighting",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         compile(gl, 1, [](const GlFunctions& g) { draw_colored_sphere(g); });
         for (int i = 0; i < 4; ++i) {
           if (i == 1) gl.ShadeModel(GL_FLAT);
           if (i == 2) gl.Enable(GL_COLOR_MATERIAL);
           if (i == 3) gl.Disable(GL_LIGHTING);
           in_quarter(gl, i % 2, i / 2, [](const GlFunctions& g) { g.CallList(1); });
         }
       }},
      {"material_in_begin_end_in_a_list",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         compile(gl, 1, [](const GlFunctions& g) {
           g.Begin(GL_TRIANGLES);
           for (int i = 0; i < 12; ++i) {
             const float f = static_cast<float>(i);
             g.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0.08F * f, 0.5F, 1 - 0.08F * f));
             g.Vertex2f(std::cos(2.2F * f), std::sin(2.2F * f));
           }
           g.End();
         });
         gl.CallList(1);
       }},
      {"push_attrib_in_a_list",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         compile(gl, 1, [](const GlFunctions& g) {
           g.PushAttrib(GL_ENABLE_BIT | GL_CURRENT_BIT);
           g.Disable(GL_LIGHTING);
           g.Color4f(0.9F, 0.3F, 0.2F, 1);
           draw_cube(g, 0.3F);
           g.PopAttrib();
         });
         gl.Translatef(-0.5F, 0, 0);
         gl.CallList(1);
         gl.Translatef(1, 0, 0);
         draw_sphere(gl, 0.4F);
       }},
      {"every_primitive_in_one_list",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         compile(gl, 7, [](const GlFunctions& g) {
           g.PointSize(4);
           for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
             g.Begin(mode);
             for (int i = 0; i < 8; ++i) {
               const float angle = 0.785F * static_cast<float>(i);
               const float x = -0.75F + 0.37F * static_cast<float>(mode % 5);
               color_by_position(g, std::cos(angle), std::sin(angle), 0);
               g.Vertex2f(x + 0.17F * std::cos(angle),
                          (mode < 5 ? -0.5F : 0.5F) + 0.3F * std::sin(angle));
             }
             g.End();
           }
         });
         gl.CallList(7);
       }},
      {"arrays_are_dereferenced_when_compiled",
       [](const GlFunctions& gl) {
         begin_scene(gl);
         std::array<GLfloat, 6> positions = {-0.9F, -0.9F, 0.9F, -0.7F, 0.1F, 0.9F};
         const std::array<GLubyte, 12> colors = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255};
         gl.EnableClientState(GL_VERTEX_ARRAY);
         gl.EnableClientState(GL_COLOR_ARRAY);
         gl.VertexPointer(2, GL_FLOAT, 0, positions.data());
         gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors.data());
         compile(gl, 1, [](const GlFunctions& g) { g.DrawArrays(GL_TRIANGLES, 0, 3); });
         positions = {};
         gl.CallList(1);
         // The arrays die with this function.
         gl.DisableClientState(GL_VERTEX_ARRAY);
         gl.DisableClientState(GL_COLOR_ARRAY);
       }},
      {"deleted_list_draws_nothing",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         const GLuint first = gl.GenLists(2);
         compile(gl, first, [](const GlFunctions& g) { draw_cube(g, 0.8F); });
         compile(gl, first + 1, [](const GlFunctions& g) { draw_sphere(g, 0.5F); });
         gl.DeleteLists(first, 1);
         gl.CallList(first);
         gl.CallList(first + 1);
       }},
      {"called_a_hundred_times",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.Enable(GL_NORMALIZE);
         compile(gl, 1, [](const GlFunctions& g) { draw_cube(g, 0.08F); });
         for (int i = 0; i < 100; ++i) {
           gl.PushMatrix();
           gl.Translatef(-0.9F + 0.2F * static_cast<float>(i % 10),
                         -0.9F + 0.2F * static_cast<float>(i / 10), 0);
           gl.Rotatef(7.0F * static_cast<float>(i), 1, 1, 0);
           gl.Materialfv(GL_FRONT, GL_DIFFUSE, vec(0.01F * static_cast<float>(i), 0.5F, 0.5F));
           gl.CallList(1);
           gl.PopMatrix();
         }
       }},
      call_lists_scene<GLbyte>("call_lists_byte", GL_BYTE),
      call_lists_scene<GLubyte>("call_lists_unsigned_byte", GL_UNSIGNED_BYTE),
      call_lists_scene<GLshort>("call_lists_short", GL_SHORT),
      call_lists_scene<GLushort>("call_lists_unsigned_short", GL_UNSIGNED_SHORT),
      call_lists_scene<GLint>("call_lists_int", GL_INT),
      call_lists_scene<GLuint>("call_lists_unsigned_int", GL_UNSIGNED_INT),
      call_lists_scene<GLfloat>("call_lists_float", GL_FLOAT),
      byte_lists_scene("call_lists_2_bytes", GL_2_BYTES, {1, 44, 1, 46}, 2),
      byte_lists_scene("call_lists_3_bytes", GL_3_BYTES, {0, 1, 45, 0, 1, 47}, 2),
      byte_lists_scene("call_lists_4_bytes", GL_4_BYTES, {0, 0, 1, 44, 0, 0, 1, 45}, 2),
  };
}

}  // namespace legacy_gl::test
