// Every variant of glVertex, glColor, glNormal, glSecondaryColor, with the conversions of GL 2.1
// spec table 2.9. Each figure below is drawn by one variant.
#include <string>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

// The corners of a triangle, integer in a view of [-10, 10]².
constexpr std::array<std::array<int, 2>, 3> corners = {{{-9, -8}, {8, -7}, {1, 9}}};

using Corner = std::function<void(const GlFunctions&, int x, int y)>;

Scene vertex_scene(std::string name, Corner corner) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            gl.Scalef(0.1F, 0.1F, 0.1F);
            gl.Begin(GL_TRIANGLES);
            for (std::size_t i = 0; i < 3; ++i) {
              gl.Color4f(i == 0 ? 1.0F : 0.1F, i == 1 ? 0.9F : 0.2F, i == 2 ? 0.8F : 0.1F, 1);
              corner(gl, corners[i][0], corners[i][1]);
            }
            gl.End();
          }};
}

template <typename Value>
std::array<Value, 4> values(int x, int y, int z = 3, int w = 1) {
  return {static_cast<Value>(x), static_cast<Value>(y), static_cast<Value>(z),
          static_cast<Value>(w)};
}

// `set` is given a fraction of full intensity for red, green, blue and alpha.
using SetColor = std::function<void(const GlFunctions&, const std::array<double, 4>&)>;

Scene color_scene(std::string name, SetColor set) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            gl.Enable(GL_COLOR_SUM);
            const std::array<std::array<double, 4>, 3> colors = {
                {{0.9, 0.1, 0.3, 1.0}, {0.2, 0.85, 0.4, 0.6}, {0.05, 0.3, 0.95, 0.3}}};
            gl.Begin(GL_TRIANGLES);
            for (std::size_t i = 0; i < 3; ++i) {
              set(gl, colors[i]);
              gl.Vertex2f(0.1F * static_cast<float>(corners[i][0]),
                          0.1F * static_cast<float>(corners[i][1]));
            }
            gl.End();
          }};
}

template <typename Value>
std::array<Value, 4> scaled(const std::array<double, 4>& color, double unit) {
  std::array<Value, 4> result{};
  for (std::size_t i = 0; i < 4; ++i) result[i] = static_cast<Value>(color[i] * unit);
  return result;
}

#define SCALAR_AND_VECTOR_COLOR(suffix, Value, unit)                                             \
  scenes.push_back(color_scene("color_3" #suffix, [](const GlFunctions& gl, const auto& color) { \
    const auto v = scaled<Value>(color, unit);                                                   \
    gl.Color3##suffix(v[0], v[1], v[2]);                                                         \
  }));                                                                                           \
  scenes.push_back(                                                                              \
      color_scene("color_3" #suffix "v", [](const GlFunctions& gl, const auto& color) {          \
        gl.Color3##suffix##v(scaled<Value>(color, unit).data());                                 \
      }));                                                                                       \
  scenes.push_back(color_scene("color_4" #suffix, [](const GlFunctions& gl, const auto& color) { \
    const auto v = scaled<Value>(color, unit);                                                   \
    gl.Color4##suffix(v[0], v[1], v[2], v[3]);                                                   \
  }));                                                                                           \
  scenes.push_back(                                                                              \
      color_scene("color_4" #suffix "v", [](const GlFunctions& gl, const auto& color) {          \
        gl.Color4##suffix##v(scaled<Value>(color, unit).data());                                 \
      }));                                                                                       \
  scenes.push_back(                                                                              \
      color_scene("secondary_color_3" #suffix, [](const GlFunctions& gl, const auto& color) {    \
        gl.Color4f(0.3F, 0.1F, 0.0F, 0.8F);                                                      \
        const auto v = scaled<Value>(color, (unit) / 2);                                         \
        gl.SecondaryColor3##suffix(v[0], v[1], v[2]);                                            \
        gl.SecondaryColor3##suffix##v(v.data());                                                 \
      }))

#define SCALAR_AND_VECTOR_VERTEX(suffix, Value)                                                   \
  scenes.push_back(vertex_scene("vertex_2" #suffix, [](const GlFunctions& gl, int x, int y) {     \
    const auto v = values<Value>(x, y);                                                           \
    gl.Vertex2##suffix(v[0], v[1]);                                                               \
  }));                                                                                            \
  scenes.push_back(vertex_scene("vertex_2" #suffix "v", [](const GlFunctions& gl, int x, int y) { \
    gl.Vertex2##suffix##v(values<Value>(x, y).data());                                            \
  }));                                                                                            \
  scenes.push_back(vertex_scene("vertex_3" #suffix, [](const GlFunctions& gl, int x, int y) {     \
    const auto v = values<Value>(x, y);                                                           \
    gl.Vertex3##suffix(v[0], v[1], v[2]);                                                         \
  }));                                                                                            \
  scenes.push_back(vertex_scene("vertex_3" #suffix "v", [](const GlFunctions& gl, int x, int y) { \
    gl.Vertex3##suffix##v(values<Value>(x, y).data());                                            \
  }));                                                                                            \
  scenes.push_back(vertex_scene("vertex_4" #suffix, [](const GlFunctions& gl, int x, int y) {     \
    const auto v = values<Value>(2 * x, 2 * y, 5, 2);                                             \
    gl.Vertex4##suffix(v[0], v[1], v[2], v[3]);                                                   \
  }));                                                                                            \
  scenes.push_back(vertex_scene("vertex_4" #suffix "v", [](const GlFunctions& gl, int x, int y) { \
    gl.Vertex4##suffix##v(values<Value>(x, y, 4, x > 0 ? 1 : 2).data());                          \
  }))

using SetNormal = std::function<void(const GlFunctions&, const std::array<double, 4>&)>;

Scene normal_scene(std::string name, SetNormal set) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            const Mesh mesh = sphere_mesh(14, 9);
            gl.Begin(GL_TRIANGLES);
            for (const GLushort index : mesh.triangle_indices) {
              const auto& n = mesh.vertices[index].normal;
              set(gl, {static_cast<double>(n[0]), static_cast<double>(n[1]),
                       static_cast<double>(n[2]), 0});
              gl.Vertex3fv(mesh.vertices[index].position.data());
            }
            gl.End();
          }};
}

#define SCALAR_AND_VECTOR_NORMAL(suffix, Value, unit)                                      \
  scenes.push_back(                                                                        \
      normal_scene("normal_3" #suffix, [](const GlFunctions& gl, const auto& normal) {     \
        const auto v = scaled<Value>(normal, unit);                                        \
        gl.Normal3##suffix(v[0], v[1], v[2]);                                              \
      }));                                                                                 \
  scenes.push_back(                                                                        \
      normal_scene("normal_3" #suffix "v", [](const GlFunctions& gl, const auto& normal) { \
        gl.Normal3##suffix##v(scaled<Value>(normal, unit).data());                         \
      }))

}  // namespace

std::vector<Scene> vertex_formats_scenes() {
  std::vector<Scene> scenes;
  SCALAR_AND_VECTOR_VERTEX(s, GLshort);
  SCALAR_AND_VECTOR_VERTEX(i, GLint);
  SCALAR_AND_VECTOR_VERTEX(f, GLfloat);
  SCALAR_AND_VECTOR_VERTEX(d, GLdouble);
  SCALAR_AND_VECTOR_COLOR(b, GLbyte, 127.0);
  SCALAR_AND_VECTOR_COLOR(ub, GLubyte, 255.0);
  SCALAR_AND_VECTOR_COLOR(s, GLshort, 32767.0);
  SCALAR_AND_VECTOR_COLOR(us, GLushort, 65535.0);
  SCALAR_AND_VECTOR_COLOR(i, GLint, 2147483647.0);
  SCALAR_AND_VECTOR_COLOR(ui, GLuint, 4294967295.0);
  SCALAR_AND_VECTOR_COLOR(f, GLfloat, 1.0);
  SCALAR_AND_VECTOR_COLOR(d, GLdouble, 1.0);
  SCALAR_AND_VECTOR_NORMAL(b, GLbyte, 127.0);
  SCALAR_AND_VECTOR_NORMAL(s, GLshort, 32767.0);
  SCALAR_AND_VECTOR_NORMAL(i, GLint, 2147483647.0);
  SCALAR_AND_VECTOR_NORMAL(f, GLfloat, 1.0);
  SCALAR_AND_VECTOR_NORMAL(d, GLdouble, 1.0);
  scenes.push_back(color_scene("color_above_one", [](const GlFunctions& gl, const auto& color) {
    const auto v = scaled<GLfloat>(color, 2.5);
    gl.Color4f(v[0], v[1] - 1, v[2], 0.5F);
  }));
  // Color3 sets alpha to 1; after Color4 for the same vertex Mesa keeps that one's alpha.
  Scene color_3_after_color_4 =
      color_scene("color_3_after_color_4", [](const GlFunctions& gl, const auto& color) {
        gl.Color4f(0, 0, 0, 0.2F);
        gl.Color3fv(scaled<GLfloat>(color, 1).data());
      });
  color_3_after_color_4.traits.mesa_departure = "M15";
  color_3_after_color_4.traits.reference =
      color_scene("", [](const GlFunctions& gl, const auto& color) {
        gl.Color3fv(scaled<GLfloat>(color, 1).data());
      }).draw;
  scenes.push_back(std::move(color_3_after_color_4));
  // Attributes of texturing and fog leave an untextured, unfogged picture alone.
  scenes.push_back(color_scene("unused_attributes", [](const GlFunctions& gl, const auto& color) {
    gl.Color4dv(color.data());
    gl.TexCoord2f(0.3F, 0.4F);
    gl.MultiTexCoord2f(GL_TEXTURE1, 0.1F, 0.9F);
    gl.FogCoordf(0.5F);
    gl.EdgeFlag(GL_TRUE);
  }));
  scenes.push_back({"secondary_color_without_color_sum", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      gl.Begin(GL_TRIANGLES);
                      for (int i = 0; i < 3; ++i) {
                        const auto& corner = corners[static_cast<std::size_t>(i)];
                        gl.Color3f(0.3F * static_cast<float>(i), 0.5F, 0.2F);
                        gl.SecondaryColor3f(0.9F, 0.2F * static_cast<float>(i), 0.9F);
                        gl.Vertex2f(0.1F * static_cast<float>(corner[0]),
                                    0.1F * static_cast<float>(corner[1]));
                      }
                      gl.End();
                    }});
  return scenes;
}

}  // namespace legacy_gl::test
