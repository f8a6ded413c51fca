#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

// Not symmetric, so that transposing shows.
constexpr std::array<GLfloat, 16> rigid_and_scaled = {
    0.60F, 0.30F, -0.1F, 0, -0.25F, 0.70F, 0.2F, 0, 0.15F, -0.2F, 0.8F, 0, 0.2F, -0.1F, 0.3F, 1};

std::array<GLdouble, 16> as_double(const std::array<GLfloat, 16>& matrix) {
  std::array<GLdouble, 16> result{};
  for (std::size_t i = 0; i < 16; ++i) result[i] = static_cast<GLdouble>(matrix[i]);
  return result;
}

Scene solid_scene(std::string name, Draw set) {
  return {std::move(name), [set = std::move(set)](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.Enable(GL_NORMALIZE);
            set(gl);
            draw_torus(gl, 0.25F, 0.5F);
            draw_cube(gl, 0.3F);
          }};
}

Scene projection_scene(std::string name, Draw set) {
  return {std::move(name), [set = std::move(set)](const GlFunctions& gl) {
            begin_lit_scene(gl);
            gl.MatrixMode(GL_PROJECTION);
            gl.LoadIdentity();
            set(gl);
            gl.MatrixMode(GL_MODELVIEW);
            gl.Rotatef(40, 1, 1, 0);
            draw_torus(gl, 0.25F, 0.5F);
            draw_cube(gl, 0.3F);
          }};
}

void draw_arm(const GlFunctions& gl, int joints) {
  if (joints == 0) return;
  draw_cube(gl, 0.18F);
  for (const float degrees : {-35.0F, 35.0F}) {
    gl.PushMatrix();
    gl.Rotatef(degrees, 0.2F, 0.3F, 1);
    gl.Translatef(0, 0.45F, 0);
    gl.Scalef(0.85F, 0.85F, 0.85F);
    draw_arm(gl, joints - 1);
    gl.PopMatrix();
  }
}

}  // namespace

std::vector<Scene> matrices_scenes() {
  return {
      solid_scene("rotate", [](const GlFunctions& gl) { gl.Rotatef(50, 1, 2, -1); }),
      solid_scene("rotate_double", [](const GlFunctions& gl) { gl.Rotated(-130, 0.3, 0.1, 2); }),
      solid_scene("rotate_about_axes",
                  [](const GlFunctions& gl) {
                    gl.Rotatef(30, 1, 0, 0);
                    gl.Rotatef(40, 0, 1, 0);
                    gl.Rotatef(-20, 0, 0, 1);
                  }),
      solid_scene("translate",
                  [](const GlFunctions& gl) {
                    gl.Translatef(0.3F, -0.2F, 0.5F);
                    gl.Translated(-0.1, 0.1, 0.2);
                  }),
      solid_scene("scale",
                  [](const GlFunctions& gl) {
                    gl.Rotatef(30, 1, 1, 0);
                    gl.Scalef(1.2F, 0.6F, 0.9F);
                    gl.Scaled(0.9, 1.1, 0.8);
                  }),
      solid_scene("load",
                  [](const GlFunctions& gl) {
                    auto matrix = rigid_and_scaled;
                    matrix[14] -= 4;
                    gl.LoadMatrixf(matrix.data());
                  }),
      solid_scene("load_double",
                  [](const GlFunctions& gl) {
                    auto matrix = as_double(rigid_and_scaled);
                    matrix[14] -= 4;
                    gl.LoadMatrixd(matrix.data());
                  }),
      solid_scene("multiply",
                  [](const GlFunctions& gl) { gl.MultMatrixf(rigid_and_scaled.data()); }),
      solid_scene(
          "multiply_double",
          [](const GlFunctions& gl) { gl.MultMatrixd(as_double(rigid_and_scaled).data()); }),
      solid_scene("multiply_transposed",
                  [](const GlFunctions& gl) {
                    std::array<GLfloat, 16> transposed{};
                    for (std::size_t row = 0; row < 4; ++row)
                      for (std::size_t column = 0; column < 4; ++column)
                        transposed[row * 4 + column] = rigid_and_scaled[column * 4 + row];
                    gl.MultTransposeMatrixf(transposed.data());
                  }),
      solid_scene("load_transposed_double",
                  [](const GlFunctions& gl) {
                    const std::array<GLdouble, 16> transposed = {0.8,  0.1, -0.3, 0.2,  //
                                                                 -0.2, 0.9, 0.1,  -0.1,
                                                                 0.3,  0.0, 0.7,  -4.0,  //
                                                                 0,    0,   0,    1};
                    gl.LoadTransposeMatrixd(transposed.data());
                  }),
      {"push_and_pop_hierarchy",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.Enable(GL_NORMALIZE);
         gl.Translatef(0, -0.7F, 0);
         draw_arm(gl, 4);
       }},
      {"modelview_depth_32",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         for (int i = 0; i < 31; ++i) {
           gl.PushMatrix();
           gl.Rotatef(7, 0, 0.3F, 1);
           if (i % 5 == 0) draw_cube(gl, 0.9F - 0.02F * static_cast<float>(i));
         }
         for (int i = 0; i < 31; ++i) gl.PopMatrix();
         gl.Translatef(0.6F, 0.6F, 1);
         draw_sphere(gl, 0.3F);
       }},
      // A thousand products: the error of each must not add up to a step.
      {"hundred_rotations",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         for (int i = 0; i < 100; ++i) gl.Rotatef(3.7F, 0.3F, 1, 0.2F);
         draw_torus(gl);
       }},
      projection_scene("ortho", [](const GlFunctions& gl) { gl.Ortho(-1, 1, -1.2, 0.9, 1, 9); }),
      projection_scene("frustum_off_centre",
                       [](const GlFunctions& gl) { gl.Frustum(-0.3, 0.6, -0.5, 0.4, 2, 8); }),
      projection_scene("projection_multiplied",
                       [](const GlFunctions& gl) {
                         gl.Scalef(0.8F, 1.1F, 1);
                         gl.Translatef(0.1F, 0.05F, 0);
                         gl.Frustum(-0.5, 0.5, -0.5, 0.5, 2, 8);
                       }),
      // Lighting happens before the projection: what is put there is not lit with it.
      projection_scene("rotation_in_the_projection",
                       [](const GlFunctions& gl) {
                         gl.Frustum(-0.5, 0.5, -0.5, 0.5, 2, 8);
                         gl.Translatef(0, 0, -4);
                         gl.Rotatef(60, 0, 1, 0);
                         gl.Translatef(0, 0, 4);
                       }),
      projection_scene("projection_stack",
                       [](const GlFunctions& gl) {
                         gl.Frustum(-0.5, 0.5, -0.5, 0.5, 2, 8);
                         gl.PushMatrix();
                         gl.Scalef(0.1F, 0.1F, 0.1F);
                         gl.PopMatrix();
                       }),
      projection_scene("near_plane_clips",
                       [](const GlFunctions& gl) { gl.Frustum(-0.9, 0.9, -0.9, 0.9, 3.9, 8); }),
      projection_scene("far_plane_clips",
                       [](const GlFunctions& gl) { gl.Frustum(-0.5, 0.5, -0.5, 0.5, 2, 4.1); }),
      projection_scene("sides_clip",
                       [](const GlFunctions& gl) { gl.Frustum(-0.2, 0.25, -0.2, 0.2, 2, 8); }),
      {"viewport_offset",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.Viewport(13, 31, 97, 71);
         draw_torus(gl);
       }},
      {"viewport_beyond_the_window",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.Viewport(-50, -20, 200, 180);
         draw_torus(gl);
       }},
      {"depth_range",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.DepthRange(0.5, 1);
         draw_cube(gl, 0.5F);
         gl.DepthRange(0, 0.4);
         gl.Translatef(0.3F, 0.3F, -1);
         draw_sphere(gl, 0.5F);
         gl.DepthRange(1, 0);
         gl.Translatef(-0.5F, -0.4F, 1);
         draw_sphere(gl, 0.3F);
       }},
      {"texture_matrix_does_not_move_vertices",
       [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.MatrixMode(GL_TEXTURE);
         gl.Rotatef(45, 1, 1, 1);
         gl.MatrixMode(GL_MODELVIEW);
         draw_cube(gl, 0.6F);
         draw_sphere(gl, 0.75F);
       }},
      {"changed_between_primitives",
       [](const GlFunctions& gl) {
         begin_scene(gl);
         gl.ShadeModel(GL_SMOOTH);
         for (int i = 0; i < 40; ++i) {
           gl.Rotatef(9, 0, 0, 1);
           gl.Begin(GL_TRIANGLES);
           gl.Color4f(1, 0.02F * static_cast<float>(i), 0, 1);
           gl.Vertex3f(0.5F, 0, 0);
           gl.Color4f(0, 1, 0.02F * static_cast<float>(i), 1);
           gl.Vertex3f(0.95F, -0.1F, 0);
           gl.Vertex3f(0.95F, 0.1F, 0);
           gl.End();
         }
       }},
  };
}

}  // namespace legacy_gl::test
