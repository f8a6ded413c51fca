// Texture coordinates: where they come from, generated, transformed, of several units (GL 2.1 spec
// 2.7, 2.8, 2.11.4, 3.8.15).
#include "conformance/feature_scenes.hpp"
#include "conformance/texture_kit.hpp"

namespace legacy_gl::test {

namespace {

void use_default_texture(const GlFunctions& gl) { use_texture(gl, GL_RGBA, GL_LINEAR, GL_LINEAR); }

void generate(const GlFunctions& gl, GLenum coordinate, GLenum mode) {
  gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, static_cast<GLint>(mode));
  gl.Enable(GL_TEXTURE_GEN_S + (coordinate - GL_S));
}

Scene texgen_scene(std::string name, Draw set, bool lit = false) {
  return {std::move(name),
          [=](const GlFunctions& gl) {
            if (lit) begin_lit_scene(gl);
            else begin_scene(gl);
            use_default_texture(gl);
            gl.Rotatef(30, 0.3F, 1, 0.2F);
            set(gl);
            gl.Rotatef(25, 1, 0.2F, 0);
            gl.Scalef(0.9F, 1.1F, 0.8F);
            if (lit) draw_sphere(gl);
            else draw_torus(gl);
          },
          {.filtered = true}};
}

void add_texgen(std::vector<Scene>& scenes) {
  scenes.push_back(texgen_scene("object_linear", [](const GlFunctions& gl) {
    gl.TexGenfv(GL_S, GL_OBJECT_PLANE, vec(0.7F, 0.2F, 0.1F, 0.3F));
    gl.TexGenfv(GL_T, GL_OBJECT_PLANE, vec(-0.1F, 0.8F, 0.3F, 0.1F));
    generate(gl, GL_S, GL_OBJECT_LINEAR);
    generate(gl, GL_T, GL_OBJECT_LINEAR);
  }));
  scenes.push_back(texgen_scene("eye_linear", [](const GlFunctions& gl) {
    gl.TexGenfv(GL_S, GL_EYE_PLANE, vec(0.7F, 0.2F, 0.1F, 0.3F));
    gl.TexGenfv(GL_T, GL_EYE_PLANE, vec(-0.1F, 0.8F, 0.3F, 0.1F));
    generate(gl, GL_S, GL_EYE_LINEAR);
    generate(gl, GL_T, GL_EYE_LINEAR);
  }));
  scenes.push_back(texgen_scene("initial_planes", [](const GlFunctions& gl) {
    gl.Enable(GL_TEXTURE_GEN_S);
    gl.Enable(GL_TEXTURE_GEN_T);
  }));
  for (const bool normalize : {false, true})
    for (const bool lit : {false, true})
      scenes.push_back(texgen_scene(
          std::string("sphere_map") + (normalize ? "_normalized" : "") + (lit ? "_lit" : ""),
          [=](const GlFunctions& gl) {
            if (normalize) gl.Enable(GL_NORMALIZE);
            generate(gl, GL_S, GL_SPHERE_MAP);
            generate(gl, GL_T, GL_SPHERE_MAP);
          },
          lit));
  scenes.push_back(texgen_scene("one_generated_one_given", [](const GlFunctions& gl) {
    gl.TexCoord2f(0.3F, 0.4F);
    generate(gl, GL_S, GL_OBJECT_LINEAR);
  }));
  scenes.push_back(texgen_scene("projective", [](const GlFunctions& gl) {
    gl.TexGenfv(GL_Q, GL_EYE_PLANE, vec(0.1F, 0.2F, 0.3F, 2));
    for (GLenum coordinate = GL_S; coordinate <= GL_Q; ++coordinate)
      generate(gl, coordinate, GL_EYE_LINEAR);
  }));
}

void use_cube_map(const GlFunctions& gl) {
  for (GLenum face = 0; face < 6; ++face) {
    std::vector<GLubyte> colors = texture_colors(8, 8);
    for (std::size_t i = 0; i < colors.size(); i += 4)
      colors[i + 2] = static_cast<GLubyte>(40 * face);
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGB, 8, 8, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, colors.data());
  }
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.Enable(GL_TEXTURE_CUBE_MAP);
}

void add_targets(std::vector<Scene>& scenes) {
  for (const GLenum mode : {GLenum{GL_REFLECTION_MAP}, GLenum{GL_NORMAL_MAP}})
    scenes.push_back(texgen_scene(mode == GL_NORMAL_MAP ? "normal_map" : "reflection_map",
                                  [=](const GlFunctions& gl) {
                                    use_cube_map(gl);
                                    for (GLenum c = GL_S; c <= GL_R; ++c) generate(gl, c, mode);
                                  }));
  for (const GLenum filter : {GLenum{GL_NEAREST}, GLenum{GL_LINEAR}})
    scenes.push_back({filter == GL_NEAREST ? "one_dimension_nearest" : "one_dimension_linear",
                      [=](const GlFunctions& gl) {
                        begin_flat_scene(gl);
                        use_texture_1d(gl, GL_RGBA, filter);
                        draw_textured_quad(gl);
                      },
                      {.filtered = true}});
  scenes.push_back({"two_dimensions_win", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      use_texture_1d(gl, GL_RGBA, GL_NEAREST);
                      use_texture(gl, GL_RGB, GL_NEAREST, GL_NEAREST);
                      draw_textured_quad(gl);
                    }});
  scenes.push_back({"three_dimensions",
                    [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 8, 4, 4, 0, GL_RGBA,
                                    GL_UNSIGNED_BYTE, texture_colors(8, 16).data());
                      gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
                      gl.Enable(GL_TEXTURE_3D);
                      gl.Begin(GL_TRIANGLES);
                      gl.TexCoord3f(0.1F, 0.1F, 0.9F);
                      gl.Vertex2f(-0.9F, -0.8F);
                      gl.TexCoord3f(0.9F, 0.2F, 0.1F);
                      gl.Vertex2f(0.9F, -0.7F);
                      gl.TexCoord3f(0.4F, 1.9F, 0.5F);
                      gl.Vertex2f(0.1F, 0.9F);
                      gl.End();
                    },
                    {.filtered = true}});
  scenes.push_back({"incomplete_is_off", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.BindTexture(GL_TEXTURE_2D, 3);
                      gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                                    texture_colors(16, 16).data());
                      gl.Enable(GL_TEXTURE_2D);  // the initial filter asks for levels
                      draw_textured_quad(gl);
                    }});
}

void add_matrices(std::vector<Scene>& scenes) {
  const auto scene = [&](const char* name, Draw set) {
    scenes.push_back({name,
                      [=](const GlFunctions& gl) {
                        begin_flat_scene(gl);
                        use_default_texture(gl);
                        gl.MatrixMode(GL_TEXTURE);
                        set(gl);
                        gl.MatrixMode(GL_MODELVIEW);
                        draw_textured_quad(gl);
                      },
                      {.filtered = true}});
  };
  scene("matrix_translated", [](const GlFunctions& gl) { gl.Translatef(0.3F, 0.2F, 0); });
  scene("matrix_turned", [](const GlFunctions& gl) {
    gl.Translatef(0.5F, 0.5F, 0);
    gl.Rotatef(35, 0, 0, 1);
    gl.Scalef(1.7F, 0.8F, 1);
  });
  scene("matrix_projective", [](const GlFunctions& gl) {
    const GLfloat m[16] = {1, 0, 0, 0.4F, 0, 1, 0, 0.3F, 0, 0, 1, 0, 0.1F, 0.2F, 0, 1};
    gl.MultMatrixf(m);
  });
  scenes.push_back({"projective_q",
                    [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      use_default_texture(gl);
                      gl.Begin(GL_QUADS);
                      gl.TexCoord2f(0, 0);  // of two kinds in one primitive
                      gl.Vertex2f(-0.9F, -0.9F);
                      gl.TexCoord4f(3, 0, 0, 3);
                      gl.Vertex2f(0.9F, -0.9F);
                      gl.TexCoord4f(1.5F, 1.5F, 0.5F, 1.5F);
                      gl.Vertex2f(0.4F, 0.9F);
                      gl.TexCoord2f(0, 1);
                      gl.Vertex2f(-0.4F, 0.9F);
                      gl.End();
                    },
                    {.filtered = true}});
}

// Unit 0 modulates, unit 1 does what `mode` says with a texture of another size.
void use_two_units(const GlFunctions& gl, GLenum mode) {
  use_texture(gl, GL_RGB, GL_NEAREST, GL_NEAREST, 1);
  gl.ActiveTexture(GL_TEXTURE1);
  gl.BindTexture(GL_TEXTURE_2D, 5);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE_ALPHA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                texture_colors(4, 4).data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(mode));
  gl.Enable(GL_TEXTURE_2D);
}

void draw_with_two_coordinates(const GlFunctions& gl) {
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 6; ++i) {
    const float u = static_cast<float>(i / 2) / 2, v = static_cast<float>(i % 2);
    gl.Color4f(u, v, 1 - u, 0.9F);
    gl.MultiTexCoord2f(GL_TEXTURE0, u + 0.011F, v + 0.017F);
    gl.MultiTexCoord2f(GL_TEXTURE1, 0.8F * v + 0.013F, 1.3F * u + 0.019F);
    gl.Vertex2f(1.8F * u - 0.93F, 1.7F * v - 0.87F);
  }
  gl.End();
}

void add_units(std::vector<Scene>& scenes) {
  for (const auto& [name, mode] :
       {std::pair{"two_units_modulate", GL_MODULATE}, std::pair{"two_units_add", GL_ADD},
        std::pair{"two_units_replace", GL_REPLACE}})
    scenes.push_back({name, [mode = static_cast<GLenum>(mode)](const GlFunctions& gl) {
                        begin_flat_scene(gl);
                        use_two_units(gl, mode);
                        draw_with_two_coordinates(gl);
                      }});
  scenes.push_back({"second_unit_alone", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      use_two_units(gl, GL_MODULATE);
                      gl.ActiveTexture(GL_TEXTURE0);
                      gl.Disable(GL_TEXTURE_2D);
                      draw_with_two_coordinates(gl);
                    }});
  scenes.push_back({"crossbar", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      use_two_units(gl, GL_COMBINE);
                      gl.TexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE0);
                      gl.TexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_TEXTURE1);
                      draw_with_two_coordinates(gl);
                    }});
}

void add_sources(std::vector<Scene>& scenes) {
  scenes.push_back({"in_a_list",
                    [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.NewList(1, GL_COMPILE);
                      use_default_texture(gl);
                      draw_textured_quad(gl);
                      gl.EndList();
                      gl.CallList(1);
                    },
                    {.filtered = true}});
  scenes.push_back({"list_of_one_then_another_coordinate",
                    [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      use_default_texture(gl);
                      gl.NewList(1, GL_COMPILE);
                      gl.Begin(GL_TRIANGLES);  // its coordinates are the caller's
                      gl.Vertex2f(-0.3F, -0.3F);
                      gl.Vertex2f(0.3F, -0.3F);
                      gl.Vertex2f(0, 0.3F);
                      gl.End();
                      draw_textured_quad(gl);
                      gl.EndList();
                      gl.TexCoord2f(0.7F, 0.3F);
                      gl.CallList(1);
                    },
                    {.filtered = true}});
  for (const GLint size : {1, 2, 3, 4})
    for (const bool in_buffer : {false, true})
      scenes.push_back({"array_of_" + std::to_string(size) + (in_buffer ? "_in_a_buffer" : ""),
                        [=](const GlFunctions& gl) {
                          begin_flat_scene(gl);
                          use_default_texture(gl);
                          gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
                          static const GLfloat data[] = {0.1F, 0.1F, 0,    1,    -0.9F, -0.9F, 0,
                                                         0.9F, 0.2F, 0.3F, 1.2F, 0.9F,  -0.8F, 0,
                                                         0.2F, 0.9F, 0,    0.8F, -0.8F, 0.9F,  0,
                                                         0.9F, 0.8F, 0.5F, 1.3F, 0.9F,  0.8F,  0};
                          const auto* base = reinterpret_cast<const GLubyte*>(data);
                          if (in_buffer) {
                            gl.BindBuffer(GL_ARRAY_BUFFER, 1);
                            gl.BufferData(GL_ARRAY_BUFFER, sizeof data, data, GL_STATIC_DRAW);
                            base = nullptr;
                          }
                          gl.TexCoordPointer(size, GL_FLOAT, 28, base);
                          gl.VertexPointer(3, GL_FLOAT, 28, base + 16);
                          gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
                          gl.EnableClientState(GL_VERTEX_ARRAY);
                          gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
                        },
                        {.filtered = true}});
  scenes.push_back({"lit_with_separate_specular",
                    [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
                      gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
                      use_default_texture(gl);
                      generate(gl, GL_S, GL_OBJECT_LINEAR);
                      generate(gl, GL_T, GL_OBJECT_LINEAR);
                      draw_half_tube(gl);
                    },
                    {.filtered = true}});
  scenes.push_back({"flat_lines_of_polygons",
                    [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      use_default_texture(gl);
                      gl.ShadeModel(GL_FLAT);
                      gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
                      draw_textured_quad(gl);
                    },
                    {.filtered = true}});
}

}  // namespace

std::vector<Scene> texture_coordinates_scenes() {
  std::vector<Scene> scenes;
  add_texgen(scenes);
  add_targets(scenes);
  add_matrices(scenes);
  add_units(scenes);
  add_sources(scenes);
  return scenes;
}

}  // namespace legacy_gl::test
