// GL 2.1 spec 2.8 and 2.9: client memory and buffer objects.
#include <cstring>

#include "conformance/feature_scenes.hpp"
#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

namespace {

// Where a scene's arrays live: `base` is an address, or 0 when a buffer object is bound.
struct Source {
  const std::byte* base;
  const void* at(std::size_t offset) const { return base + offset; }
};

const Mesh& shared_mesh() {
  static const Mesh mesh = sphere_mesh();
  return mesh;
}

void point_at_mesh(const GlFunctions& gl, const Source& source, bool with_color) {
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  if (with_color) gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, sizeof(MeshVertex), source.at(offsetof(MeshVertex, position)));
  gl.NormalPointer(GL_FLOAT, sizeof(MeshVertex), source.at(offsetof(MeshVertex, normal)));
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(MeshVertex), source.at(offsetof(MeshVertex, color)));
}

enum class Storage { client, buffer };

// Draws `draw` with the sphere mesh's arrays set, from client memory or from two buffer objects.
Scene mesh_scene(std::string name, Storage storage, bool lit,
                 std::function<void(const GlFunctions&, const Source& indices)> draw) {
  return {std::move(name), [=](const GlFunctions& gl) {
            if (lit) begin_lit_scene(gl);
            else begin_scene(gl);
            gl.Rotatef(30, 1, 0, 0);
            const Mesh& mesh = shared_mesh();
            if (storage == Storage::client) {
              const auto* vertices = reinterpret_cast<const std::byte*>(mesh.vertices.data());
              const auto* indices =
                  reinterpret_cast<const std::byte*>(mesh.triangle_indices.data());
              point_at_mesh(gl, {vertices}, !lit);
              draw(gl, {indices});
              return;
            }
            std::array<GLuint, 2> buffers{};
            gl.GenBuffers(2, buffers.data());
            gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
            gl.BufferData(GL_ARRAY_BUFFER,
                          static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(MeshVertex)),
                          mesh.vertices.data(), GL_STATIC_DRAW);
            gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
            gl.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                          static_cast<GLsizeiptr>(mesh.triangle_indices.size() * sizeof(GLushort)),
                          mesh.triangle_indices.data(), GL_STATIC_DRAW);
            point_at_mesh(gl, {nullptr}, !lit);
            draw(gl, {nullptr});
            gl.BindBuffer(GL_ARRAY_BUFFER, 0);
            gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
          }};
}

void draw_elements(const GlFunctions& gl, const Source& indices) {
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(shared_mesh().triangle_indices.size()),
                  GL_UNSIGNED_SHORT, indices.at(0));
}

void draw_range_elements(const GlFunctions& gl, const Source& indices) {
  gl.DrawRangeElements(GL_TRIANGLES, 0, static_cast<GLuint>(shared_mesh().vertices.size() - 1),
                       static_cast<GLsizei>(shared_mesh().triangle_indices.size()),
                       GL_UNSIGNED_SHORT, indices.at(0));
}

void multi_draw_elements(const GlFunctions& gl, const Source& indices) {
  const std::array<GLsizei, 3> counts = {60, 150, 90};
  // The parameter's constness differs between headers of OpenGL 1.4 and later ones.
  std::array<const void*, 3> offsets = {indices.at(0), indices.at(300), indices.at(720)};
  gl.MultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_SHORT, offsets.data(), 3);
}

void draw_arrays(const GlFunctions& gl, const Source&) { gl.DrawArrays(GL_TRIANGLE_STRIP, 20, 70); }

void multi_draw_arrays(const GlFunctions& gl, const Source&) {
  const std::array<GLint, 3> first = {10, 40, 80};
  const std::array<GLsizei, 3> counts = {20, 25, 16};
  gl.MultiDrawArrays(GL_TRIANGLE_STRIP, first.data(), counts.data(), 3);
}

void array_element(const GlFunctions& gl, const Source&) {
  gl.Begin(GL_TRIANGLES);
  for (const GLushort index : shared_mesh().triangle_indices) gl.ArrayElement(index);
  gl.End();
}

void draw_quad_elements(const GlFunctions& gl, const Source& indices) {
  gl.DrawElements(GL_QUADS, 120, GL_UNSIGNED_SHORT, indices.at(480));
}

void draw_polygon_arrays(const GlFunctions& gl, const Source&) {
  gl.DrawArrays(GL_POLYGON, 65, 13);
  gl.DrawArrays(GL_QUAD_STRIP, 26, 26);
}

// A ring of quads from an array of positions of any type.
template <typename Value>
Scene position_type_scene(std::string name, GLenum type, GLint components, float unit) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_scene(gl);
            gl.Scalef(1 / unit, 1 / unit, 1 / unit);
            std::vector<Value> values;
            std::vector<GLfloat> colors;
            for (int i = 0; i < 18; ++i) {
              const float angle = 0.37F * static_cast<float>(i);
              const float radius = i % 2 == 0 ? 0.45F * unit : 0.95F * unit;
              const std::array<float, 4> point = {radius * std::cos(angle),
                                                  radius * std::sin(angle), 0.2F * unit, 1};
              for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
                values.push_back(static_cast<Value>(point[c]));
              colors.insert(colors.end(), {0.05F * static_cast<float>(i), 0.6F,
                                           1 - 0.05F * static_cast<float>(i)});
            }
            gl.EnableClientState(GL_VERTEX_ARRAY);
            gl.EnableClientState(GL_COLOR_ARRAY);
            gl.VertexPointer(components, type, 0, values.data());
            gl.ColorPointer(3, GL_FLOAT, 0, colors.data());
            gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 18);
            gl.DisableClientState(GL_VERTEX_ARRAY);
            gl.DisableClientState(GL_COLOR_ARRAY);
          }};
}

constexpr std::array<GLfloat, 8> square_positions = {-0.9F, -0.9F, 0.9F, -0.8F,
                                                     -0.8F, 0.9F,  0.9F, 0.8F};
constexpr std::array<double, 16> square_colors = {0.1, 0.9, 0.4, 0.6, 0.8, 0.2, 0.5, 1.0,
                                                  0.3, 0.6, 0.9, 0.5, 0.7, 0.0, 0.2, 0.8};

template <typename Value>
Scene color_type_scene(std::string name, GLenum type, GLint components, double unit) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_flat_scene(gl);
            std::vector<Value> colors;
            for (std::size_t vertex = 0; vertex < 4; ++vertex)
              for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
                colors.push_back(static_cast<Value>(square_colors[vertex * 4 + c] * unit));
            gl.EnableClientState(GL_VERTEX_ARRAY);
            gl.EnableClientState(GL_COLOR_ARRAY);
            gl.VertexPointer(2, GL_FLOAT, 0, square_positions.data());
            gl.ColorPointer(components, type, 0, colors.data());
            gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
            gl.DisableClientState(GL_VERTEX_ARRAY);
            gl.DisableClientState(GL_COLOR_ARRAY);
          }};
}

void draw_with_byte_colors(const GlFunctions& gl) {
  begin_flat_scene(gl);
  gl.Begin(GL_TRIANGLE_STRIP);
  for (std::size_t vertex = 0; vertex < 4; ++vertex) {
    std::array<GLbyte, 3> color{};
    for (std::size_t c = 0; c < 3; ++c)
      color[c] = static_cast<GLbyte>(square_colors[vertex * 4 + c] * 127);
    gl.Color3bv(color.data());
    gl.Vertex2fv(&square_positions[2 * vertex]);
  }
  gl.End();
}

template <typename Value>
Scene normal_type_scene(std::string name, GLenum type, double unit) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            const Mesh& mesh = shared_mesh();
            std::vector<Value> normals;
            for (const MeshVertex& vertex : mesh.vertices)
              for (const float component : vertex.normal)
                normals.push_back(static_cast<Value>(static_cast<double>(component) * unit));
            gl.EnableClientState(GL_VERTEX_ARRAY);
            gl.EnableClientState(GL_NORMAL_ARRAY);
            gl.VertexPointer(3, GL_FLOAT, sizeof(MeshVertex), mesh.vertices[0].position.data());
            gl.NormalPointer(type, 0, normals.data());
            gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.triangle_indices.size()),
                            GL_UNSIGNED_SHORT, mesh.triangle_indices.data());
            gl.DisableClientState(GL_NORMAL_ARRAY);
            gl.DisableClientState(GL_VERTEX_ARRAY);
          }};
}

void draw_with_byte_normals(const GlFunctions& gl) {
  begin_lit_scene(gl);
  gl.Begin(GL_TRIANGLES);
  for (const GLushort index : shared_mesh().triangle_indices) {
    const MeshVertex& vertex = shared_mesh().vertices[index];
    std::array<GLbyte, 3> normal{};
    for (std::size_t i = 0; i < 3; ++i)
      normal[i] = static_cast<GLbyte>(static_cast<double>(vertex.normal[i]) * 127);
    gl.Normal3bv(normal.data());
    gl.Vertex3fv(vertex.position.data());
  }
  gl.End();
}

template <typename Index>
Scene index_type_scene(std::string name, GLenum type) {
  return {std::move(name), [=](const GlFunctions& gl) {
            begin_lit_scene(gl);
            const Mesh& mesh = shared_mesh();
            std::vector<Index> indices;
            for (const GLushort index : mesh.triangle_indices)
              indices.push_back(static_cast<Index>(index));
            point_at_mesh(gl, {reinterpret_cast<const std::byte*>(mesh.vertices.data())}, false);
            gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), type,
                            indices.data());
          }};
}

Scene interleaved_scene(std::string name, GLenum format, bool lit,
                        std::function<void(std::vector<std::byte>*, const MeshVertex&)> append) {
  return {std::move(name), [=](const GlFunctions& gl) {
            if (lit) begin_lit_scene(gl);
            else begin_scene(gl);
            std::vector<std::byte> data;
            for (const MeshVertex& vertex : shared_mesh().vertices) append(&data, vertex);
            gl.InterleavedArrays(format, 0, data.data());
            gl.DrawElements(GL_TRIANGLES,
                            static_cast<GLsizei>(shared_mesh().triangle_indices.size()),
                            GL_UNSIGNED_SHORT, shared_mesh().triangle_indices.data());
            gl.DisableClientState(GL_VERTEX_ARRAY);
          }};
}

template <typename Values>
void put(std::vector<std::byte>* data, const Values& values) {
  const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
  data->insert(data->end(), bytes, bytes + values.size() * sizeof(values[0]));
}

std::array<GLfloat, 4> float_color(const MeshVertex& vertex) {
  return {static_cast<GLfloat>(vertex.color[0]) / 255.0F,
          static_cast<GLfloat>(vertex.color[1]) / 255.0F,
          static_cast<GLfloat>(vertex.color[2]) / 255.0F, 1.0F};
}

}  // namespace

std::vector<Scene> arrays_scenes() {
  std::vector<Scene> scenes;
  using MeshDraw = void (*)(const GlFunctions&, const Source&);
  const std::pair<const char*, MeshDraw> draws[] = {{"draw_elements", draw_elements},
                                                    {"draw_range_elements", draw_range_elements},
                                                    {"multi_draw_elements", multi_draw_elements},
                                                    {"draw_arrays", draw_arrays},
                                                    {"multi_draw_arrays", multi_draw_arrays},
                                                    {"array_element", array_element},
                                                    {"draw_quad_elements", draw_quad_elements},
                                                    {"draw_polygon_arrays", draw_polygon_arrays}};
  for (const auto& [name, draw] : draws) {
    for (const Storage storage : {Storage::client, Storage::buffer}) {
      const std::string prefix =
          std::string(name) + (storage == Storage::client ? "_client" : "_buffer");
      scenes.push_back(mesh_scene(prefix + "_lit", storage, true, draw));
      scenes.push_back(mesh_scene(prefix + "_colored", storage, false, draw));
    }
  }
  scenes.push_back(position_type_scene<GLshort>("position_short_2", GL_SHORT, 2, 1000));
  scenes.push_back(position_type_scene<GLint>("position_int_3", GL_INT, 3, 50000));
  scenes.push_back(position_type_scene<GLfloat>("position_float_4", GL_FLOAT, 4, 1));
  scenes.push_back(position_type_scene<GLdouble>("position_double_3", GL_DOUBLE, 3, 7));
  // M14. GL 2.1 spec table 2.9 maps the byte c to (2c + 1) / 255, in arrays as in glColor3b. Mesa
  // does for glColor3b, but its arrays follow OpenGL 4.2, c / 127.
  Scene byte_colors = color_type_scene<GLbyte>("color_byte_3", GL_BYTE, 3, 127);
  byte_colors.traits.mesa_departure = "M14";
  byte_colors.traits.reference = draw_with_byte_colors;
  scenes.push_back(std::move(byte_colors));
  scenes.push_back(color_type_scene<GLubyte>("color_unsigned_byte_3", GL_UNSIGNED_BYTE, 3, 255));
  scenes.push_back(color_type_scene<GLshort>("color_short_4", GL_SHORT, 4, 32767));
  scenes.push_back(
      color_type_scene<GLushort>("color_unsigned_short_4", GL_UNSIGNED_SHORT, 4, 65535));
  scenes.push_back(color_type_scene<GLint>("color_int_4", GL_INT, 4, 2147483647));
  scenes.push_back(
      color_type_scene<GLuint>("color_unsigned_int_3", GL_UNSIGNED_INT, 3, 4294967295));
  scenes.push_back(color_type_scene<GLfloat>("color_float_4", GL_FLOAT, 4, 1));
  scenes.push_back(color_type_scene<GLdouble>("color_double_4", GL_DOUBLE, 4, 1));
  // GL 2.1 spec table 2.9 maps the byte c to (2c + 1) / 255, in arrays as in glNormal3b. Mesa does
  // for glNormal3b, but its arrays follow OpenGL 4.2, c / 127.
  Scene byte_normals = normal_type_scene<GLbyte>("normal_byte", GL_BYTE, 127);
  byte_normals.traits.mesa_departure = "M14";
  byte_normals.traits.reference = draw_with_byte_normals;
  scenes.push_back(std::move(byte_normals));
  scenes.push_back(normal_type_scene<GLshort>("normal_short", GL_SHORT, 32767));
  scenes.push_back(normal_type_scene<GLint>("normal_int", GL_INT, 2147483647));
  scenes.push_back(normal_type_scene<GLdouble>("normal_double", GL_DOUBLE, 1));
  scenes.push_back(index_type_scene<GLubyte>("index_unsigned_byte", GL_UNSIGNED_BYTE));
  scenes.push_back(index_type_scene<GLuint>("index_unsigned_int", GL_UNSIGNED_INT));
  scenes.push_back(interleaved_scene("interleaved_n3f_v3f", GL_N3F_V3F, true,
                                     [](std::vector<std::byte>* data, const MeshVertex& v) {
                                       put(data, v.normal);
                                       put(data, v.position);
                                     }));
  scenes.push_back(interleaved_scene("interleaved_c4ub_v3f", GL_C4UB_V3F, false,
                                     [](std::vector<std::byte>* data, const MeshVertex& v) {
                                       put(data, v.color);
                                       put(data, v.position);
                                     }));
  scenes.push_back(
      interleaved_scene("interleaved_c3f_v3f", GL_C3F_V3F, false,
                        [](std::vector<std::byte>* data, const MeshVertex& v) {
                          const auto color = float_color(v);
                          put(data, std::array<GLfloat, 3>{color[0], color[1], color[2]});
                          put(data, v.position);
                        }));
  scenes.push_back(interleaved_scene("interleaved_c4f_n3f_v3f", GL_C4F_N3F_V3F, true,
                                     [](std::vector<std::byte>* data, const MeshVertex& v) {
                                       put(data, float_color(v));
                                       put(data, v.normal);
                                       put(data, v.position);
                                     }));
  scenes.push_back(interleaved_scene("interleaved_t2f_n3f_v3f", GL_T2F_N3F_V3F, true,
                                     [](std::vector<std::byte>* data, const MeshVertex& v) {
                                       put(data, std::array<GLfloat, 2>{0, 1});
                                       put(data, v.normal);
                                       put(data, v.position);
                                     }));
  scenes.push_back({"client_memory_may_change_after_the_draw", [](const GlFunctions& gl) {
                      begin_flat_scene(gl);
                      std::array<GLfloat, 6> positions = {-0.9F, -0.9F, -0.1F, -0.9F, -0.5F, 0.9F};
                      std::array<GLfloat, 9> colors = {1, 0, 0, 0, 1, 0, 0, 0, 1};
                      gl.EnableClientState(GL_VERTEX_ARRAY);
                      gl.EnableClientState(GL_COLOR_ARRAY);
                      gl.VertexPointer(2, GL_FLOAT, 0, positions.data());
                      gl.ColorPointer(3, GL_FLOAT, 0, colors.data());
                      gl.DrawArrays(GL_TRIANGLES, 0, 3);
                      for (std::size_t i = 0; i < 6; i += 2) positions[i] += 1;
                      colors.fill(0.7F);
                      gl.DrawArrays(GL_TRIANGLES, 0, 3);
                      positions.fill(0);
                      gl.DisableClientState(GL_VERTEX_ARRAY);
                      gl.DisableClientState(GL_COLOR_ARRAY);
                    }});
  // Each pointer remembers the buffer that was bound when it was set.
  scenes.push_back(
      {"buffer_and_client_memory_mixed", [](const GlFunctions& gl) {
         begin_scene(gl);
         const Mesh& mesh = shared_mesh();
         GLuint buffer = 0;
         gl.GenBuffers(1, &buffer);
         gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
         gl.BufferData(GL_ARRAY_BUFFER,
                       static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(MeshVertex)),
                       mesh.vertices.data(), GL_STATIC_DRAW);
         gl.EnableClientState(GL_VERTEX_ARRAY);
         gl.VertexPointer(3, GL_FLOAT, sizeof(MeshVertex), nullptr);
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
         gl.EnableClientState(GL_COLOR_ARRAY);
         gl.ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(MeshVertex), mesh.vertices[0].color.data());
         gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(mesh.triangle_indices.size()),
                         GL_UNSIGNED_SHORT, mesh.triangle_indices.data());
         gl.DisableClientState(GL_VERTEX_ARRAY);
         gl.DisableClientState(GL_COLOR_ARRAY);
       }});
  scenes.push_back(
      {"buffer_updated_between_draws",
       [](const GlFunctions& gl) {
         begin_flat_scene(gl);
         const std::array<GLfloat, 6> triangle = {-0.9F, -0.9F, -0.1F, -0.9F, -0.5F, 0.9F};
         const std::array<GLfloat, 2> tip = {0.9F, 0.1F};
         GLuint buffer = 0;
         gl.GenBuffers(1, &buffer);
         gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
         gl.BufferData(GL_ARRAY_BUFFER, sizeof(triangle), triangle.data(), GL_DYNAMIC_DRAW);
         gl.EnableClientState(GL_VERTEX_ARRAY);
         gl.VertexPointer(2, GL_FLOAT, 0, nullptr);
         gl.Color3f(0.9F, 0.2F, 0.1F);
         gl.DrawArrays(GL_TRIANGLES, 0, 3);
         gl.BufferSubData(GL_ARRAY_BUFFER, 16, sizeof(tip), tip.data());
         gl.Color4f(0.1F, 0.2F, 0.9F, 0.5F);
         gl.DrawArrays(GL_TRIANGLES, 0, 3);
         gl.BindBuffer(GL_ARRAY_BUFFER, 0);
       },
       {.few_colors = true}});
  scenes.push_back(
      {"tracked_color_array", [](const GlFunctions& gl) {
         begin_lit_scene(gl);
         gl.Enable(GL_COLOR_MATERIAL);
         const Mesh& mesh = shared_mesh();
         point_at_mesh(gl, {reinterpret_cast<const std::byte*>(mesh.vertices.data())}, true);
         draw_elements(gl, {reinterpret_cast<const std::byte*>(mesh.triangle_indices.data())});
       }});
  return scenes;
}

}  // namespace legacy_gl::test
