// GL 2.1 spec 2.11.3. GL_NORMALIZE and GL_RESCALE_NORMAL are different operations.
#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

void no_mode(const GlFunctions&) {}
void normalize(const GlFunctions& gl) { gl.Enable(GL_NORMALIZE); }
void rescale(const GlFunctions& gl) { gl.Enable(GL_RESCALE_NORMAL); }
void both(const GlFunctions& gl) {
  normalize(gl);
  rescale(gl);
}

// Normals of the length 1 + y/2, where only GL_NORMALIZE restores unit length.
void draw_uneven_normals(const GlFunctions& gl) {
  gl.Begin(GL_TRIANGLES);
  const Mesh mesh = sphere_mesh(16, 10);
  for (const GLushort index : mesh.triangle_indices) {
    const MeshVertex& vertex = mesh.vertices[index];
    const float length = 1.0F + 0.5F * vertex.normal[1];
    gl.Normal3f(length * vertex.normal[0], length * vertex.normal[1], length * vertex.normal[2]);
    gl.Vertex3fv(vertex.position.data());
  }
  gl.End();
}

}  // namespace

std::vector<Scene> normals_scenes() {
  std::vector<Scene> scenes;
  const std::pair<const char*, Draw> modes[] = {
      {"as_they_are", no_mode}, {"normalize", normalize}, {"rescale", rescale}, {"both", both}};
  for (const auto& [mode_name, mode] : modes) {
    const std::string name = mode_name;
    scenes.push_back(
        lit_sphere_scene(name + "_uniform_scale", [mode = mode](const GlFunctions& gl) {
          mode(gl);
          gl.Scalef(0.6F, 0.6F, 0.6F);
        }));
    scenes.push_back(
        lit_sphere_scene(name + "_nonuniform_scale", [mode = mode](const GlFunctions& gl) {
          mode(gl);
          gl.Rotatef(25, 0, 0, 1);
          gl.Scalef(1.1F, 0.5F, 0.8F);
        }));
    scenes.push_back(lit_sphere_scene(name + "_rotated", [mode = mode](const GlFunctions& gl) {
      mode(gl);
      gl.Rotatef(75, 1, 2, 3);
    }));
    scenes.push_back(lit_sphere_scene(name + "_mirrored", [mode = mode](const GlFunctions& gl) {
      mode(gl);
      gl.Scalef(-1, 1, 1);
    }));
    scenes.push_back({name + "_uneven_lengths", [mode = mode](const GlFunctions& gl) {
                        begin_lit_scene(gl);
                        mode(gl);
                        gl.Scalef(0.9F, 0.9F, 0.9F);
                        draw_uneven_normals(gl);
                      }});
    scenes.push_back(lit_sphere_scene(name + "_sheared", [mode = mode](const GlFunctions& gl) {
      mode(gl);
      const std::array<GLfloat, 16> shear = {0.9F, 0.2F, 0, 0, 0.4F, 0.7F, 0, 0,
                                             0,    0.1F, 1, 0, 0,    0,    0, 1};
      gl.MultMatrixf(shear.data());
    }));
    scenes.push_back(lit_sphere_scene(name + "_scale_1000", [mode = mode](const GlFunctions& gl) {
      mode(gl);
      gl.Scalef(1000, 1000, 1000);
      gl.Scalef(0.001F, 0.001F, 0.0009F);
    }));
  }
  scenes.push_back({"current_normal_of_before_begin", [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      for (int i = 0; i < 4; ++i) {
                        const float x = -0.6F + 0.4F * static_cast<float>(i);
                        gl.Normal3f(x, 0, 0.8F);
                        in_quarter(gl, i % 2, i / 2, [](const GlFunctions& g) {
                          g.Begin(GL_TRIANGLES);
                          g.Vertex2f(-0.9F, -0.9F);
                          g.Vertex2f(0.9F, -0.9F);
                          g.Vertex2f(0, 0.9F);
                          g.End();
                        });
                      }
                    }});
  scenes.push_back({"default_normal_is_plus_z",
                    [](const GlFunctions& gl) {
                      begin_lit_scene(gl);
                      gl.Begin(GL_TRIANGLES);
                      gl.Vertex2f(-0.9F, -0.9F);
                      gl.Vertex2f(0.9F, -0.9F);
                      gl.Vertex2f(0, 0.9F);
                      gl.End();
                    },
                    {.few_colors = true}});
  return scenes;
}

}  // namespace legacy_gl::test
