// Client arrays (GL 2.1 spec 2.8).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "support/contexts.hpp"
#include "support/image_matcher.hpp"
#include "support/shared_context.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 64;

struct Vertex {
  std::array<GLfloat, 3> position;
  std::array<GLfloat, 4> color;
};

// A spiral of points of many colours inside the view volume.
std::vector<Vertex> spiral(unsigned count) {
  std::vector<Vertex> vertices;
  for (unsigned i = 0; i < count; ++i) {
    const float angle = 0.7F * static_cast<float>(i);
    const float radius = 0.95F - 0.4F * static_cast<float>(i % 2) - 0.01F * static_cast<float>(i);
    vertices.push_back(
        {{radius * std::cos(angle), radius * std::sin(angle), 0.02F * static_cast<float>(i)},
         {static_cast<float>(i * 37 % 100) / 100, static_cast<float>(i * 61 % 100) / 100,
          static_cast<float>(i * 17 % 100) / 100, 1}});
  }
  return vertices;
}

using Draw = std::function<void(const GlFunctions&)>;

Image render(RenderContext& context, const Draw& draw) {
  context.recreate();
  context.gl.ClearColor(0, 0, 0, 0);
  context.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw(context.gl);
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
  return context.read();
}

CoreContext& ours() {
  static auto& context = make_shared_context<CoreContext>(kSize, kSize);
  return context;
}
MesaContext& mesa() {
  static auto& context = make_shared_context<MesaContext>(kSize, kSize);
  return context;
}

// One step: two round colours to RGBA8 that differ by the last bits of a float.
constexpr ImageTolerance kOneStep{.max_difference_steps = 1};

void expect_as_mesa(const Draw& draw, const std::string& name) {
  const Image reference = render(mesa(), draw);
  EXPECT_GT(covered_pixels(reference), 5) << name;
  EXPECT_TRUE(images_match(render(ours(), draw), reference, kOneStep, name));
}

void point_at(const GlFunctions& gl, const std::vector<Vertex>& vertices) {
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), vertices[0].position.data());
  gl.ColorPointer(4, GL_FLOAT, sizeof(Vertex), vertices[0].color.data());
}

GLint integer(const GlFunctions& gl, GLenum name) {
  GLint value = -1;
  gl.GetIntegerv(name, &value);
  return value;
}

legacy_gl_statistics statistics() {
  legacy_gl_statistics values{};
  legacy_gl_flush();
  legacy_gl_get_statistics(&values);
  return values;
}

constexpr std::array<const char*, 10> kModeNames = {
    "points",         "lines",        "line_loop", "line_strip", "triangles",
    "triangle_strip", "triangle_fan", "quads",     "quad_strip", "polygon"};

}  // namespace

std::string mode_name(const testing::TestParamInfo<unsigned>& mode) {
  return kModeNames[mode.param];
}

class ArraysMode : public testing::TestWithParam<unsigned> {};

TEST_P(ArraysMode, RendersArraysAsMesa) {
  const std::vector<Vertex> vertices = spiral(13);
  for (const GLenum shade : {GLenum{GL_SMOOTH}, GLenum{GL_FLAT}})
    expect_as_mesa(
        [&](const GlFunctions& gl) {
          gl.ShadeModel(shade);
          point_at(gl, vertices);
          gl.DrawArrays(GetParam(), 1, 11);
        },
        std::string("arrays_") + kModeNames[GetParam()] + (shade == GL_FLAT ? "_flat" : ""));
}

TEST_P(ArraysMode, RendersElementsAsMesa) {
  const std::vector<Vertex> vertices = spiral(13);
  const std::array<GLushort, 12> indices = {3, 4, 5, 6, 7, 5, 4, 9, 10, 11, 12, 3};
  for (const GLenum shade : {GLenum{GL_SMOOTH}, GLenum{GL_FLAT}})
    expect_as_mesa(
        [&](const GlFunctions& gl) {
          gl.ShadeModel(shade);
          point_at(gl, vertices);
          gl.DrawElements(GetParam(), 11, GL_UNSIGNED_SHORT, indices.data());
        },
        std::string("elements_") + kModeNames[GetParam()] + (shade == GL_FLAT ? "_flat" : ""));
}

INSTANTIATE_TEST_SUITE_P(All, ArraysMode, testing::Range(0U, 10U), mode_name);

// Every size, type, stride and enable, as text to compare.
std::string array_state(const GlFunctions& gl) {
  std::string text;
  for (const auto name : {GL_VERTEX_ARRAY_SIZE,
                          GL_VERTEX_ARRAY_TYPE,
                          GL_VERTEX_ARRAY_STRIDE,
                          GL_NORMAL_ARRAY_TYPE,
                          GL_NORMAL_ARRAY_STRIDE,
                          GL_COLOR_ARRAY_SIZE,
                          GL_COLOR_ARRAY_TYPE,
                          GL_COLOR_ARRAY_STRIDE,
                          GL_SECONDARY_COLOR_ARRAY_SIZE,
                          GL_SECONDARY_COLOR_ARRAY_TYPE,
                          GL_SECONDARY_COLOR_ARRAY_STRIDE,
                          GL_FOG_COORD_ARRAY_TYPE,
                          GL_FOG_COORD_ARRAY_STRIDE,
                          GL_INDEX_ARRAY_TYPE,
                          GL_INDEX_ARRAY_STRIDE,
                          GL_EDGE_FLAG_ARRAY_STRIDE,
                          GL_TEXTURE_COORD_ARRAY_SIZE,
                          GL_TEXTURE_COORD_ARRAY_TYPE,
                          GL_TEXTURE_COORD_ARRAY_STRIDE,
                          GL_ARRAY_BUFFER_BINDING,
                          GL_ELEMENT_ARRAY_BUFFER_BINDING,
                          GL_VERTEX_ARRAY_BUFFER_BINDING,
                          GL_CLIENT_ACTIVE_TEXTURE})
    text += std::to_string(integer(gl, static_cast<GLenum>(name))) + " ";
  for (const auto name :
       {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_INDEX_ARRAY, GL_EDGE_FLAG_ARRAY,
        GL_TEXTURE_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY})
    text += gl.IsEnabled(static_cast<GLenum>(name)) ? "on " : "off ";
  for (const auto name : {GL_VERTEX_ARRAY_POINTER, GL_NORMAL_ARRAY_POINTER, GL_COLOR_ARRAY_POINTER,
                          GL_TEXTURE_COORD_ARRAY_POINTER}) {
    void* pointer = nullptr;
    gl.GetPointerv(static_cast<GLenum>(name), &pointer);
    text += std::to_string(reinterpret_cast<std::uintptr_t>(pointer)) + " ";
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  return text;
}

std::string state_after(RenderContext& context, const Draw& set) {
  context.recreate();
  set(context.gl);
  return array_state(context.gl);
}

TEST(ArraysInitialState, IsMesas) {
  const auto nothing = [](const GlFunctions&) {};
  EXPECT_EQ(state_after(ours(), nothing), state_after(mesa(), nothing));
}

TEST(ArraysSetAndGet, PointersOfEachUnit) {
  const std::array<GLfloat, 4> memory{};
  const auto set = [&](const GlFunctions& gl) {
    gl.VertexPointer(2, GL_SHORT, 12, memory.data());
    gl.NormalPointer(GL_BYTE, 4, memory.data() + 1);
    gl.ColorPointer(3, GL_UNSIGNED_SHORT, 8, memory.data() + 2);
    gl.SecondaryColorPointer(3, GL_INT, 20, memory.data());
    gl.FogCoordPointer(GL_DOUBLE, 24, memory.data());
    gl.IndexPointer(GL_UNSIGNED_BYTE, 3, memory.data());
    gl.EdgeFlagPointer(5, memory.data());
    gl.TexCoordPointer(1, GL_INT, 28, memory.data());
    gl.ClientActiveTexture(GL_TEXTURE1);
    gl.TexCoordPointer(3, GL_DOUBLE, 32, memory.data() + 3);
    gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
    gl.EnableClientState(GL_NORMAL_ARRAY);
  };
  EXPECT_EQ(state_after(ours(), set), state_after(mesa(), set));
  const auto back_to_unit_0 = [&](const GlFunctions& gl) {
    set(gl);
    gl.ClientActiveTexture(GL_TEXTURE0);
  };
  EXPECT_EQ(state_after(ours(), back_to_unit_0), state_after(mesa(), back_to_unit_0));
}

TEST(ArraysSetAndGet, InterleavedFormatsAsMesa) {
  const std::array<GLfloat, 16> memory{};
  for (GLenum format = GL_V2F; format <= GL_T4F_C4F_N3F_V4F; ++format)
    for (const GLsizei stride : {0, 100}) {
      const auto set = [&](const GlFunctions& gl) {
        gl.EnableClientState(GL_INDEX_ARRAY);
        gl.EnableClientState(GL_EDGE_FLAG_ARRAY);
        gl.EnableClientState(GL_COLOR_ARRAY);
        gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
        gl.InterleavedArrays(format, stride, memory.data());
      };
      EXPECT_EQ(state_after(ours(), set), state_after(mesa(), set)) << format;
    }
}

TEST(ArraysRenders, NothingWithoutAVertexArray) {
  const std::vector<Vertex> vertices = spiral(6);
  const Image image = render(ours(), [&](const GlFunctions& gl) {
    point_at(gl, vertices);
    gl.DisableClientState(GL_VERTEX_ARRAY);
    gl.DrawArrays(GL_TRIANGLES, 0, 6);
  });
  EXPECT_EQ(covered_pixels(image), 0);
}

// Elements that name few of the vertices that they span.
TEST(ArraysRenders, SparseElements) {
  const std::vector<Vertex> vertices = spiral(90);
  const std::array<GLubyte, 6> indices = {0, 85, 43, 12, 60, 89};
  expect_as_mesa(
      [&](const GlFunctions& gl) {
        point_at(gl, vertices);
        gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, indices.data());
      },
      "sparse_elements");
}

TEST(ArraysRenders, PositionsOfFourComponents) {
  std::array<GLfloat, 16> positions = {-0.9F, -0.9F, 0, 1,    1.8F,  -1.6F, 0, 2,
                                       0.2F,  0.4F,  0, 0.5F, -0.5F, 0.9F,  0, 1};
  const auto draw = [&](const GlFunctions& gl) {
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.VertexPointer(4, GL_FLOAT, 0, positions.data());
    gl.Color3f(0.2F, 0.7F, 0.5F);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  };
  expect_as_mesa(draw, "positions_with_w");
  positions[7] = positions[11] = 1;
  expect_as_mesa(draw, "positions_with_w_1");
}

// Draws of different state, of arrays and of glBegin, one after the other in one batch.
TEST(ArraysRenders, MixedWithBeginEnd) {
  const std::vector<Vertex> vertices = spiral(24);
  const std::array<GLuint, 6> indices = {12, 13, 14, 14, 13, 15};
  expect_as_mesa(
      [&](const GlFunctions& gl) {
        const auto begin_end = [&](unsigned first) {
          gl.Begin(GL_QUADS);
          for (unsigned i = 0; i < 4; ++i) {
            const float x = i == 1 || i == 2 ? 0.3F : -0.3F, y = i > 1 ? 0.3F : -0.3F;
            gl.Color4fv(vertices[first + i].color.data());
            gl.Vertex2f(x, y);
          }
          gl.End();
        };
        point_at(gl, vertices);
        gl.DrawArrays(GL_TRIANGLES, 0, 6);
        begin_end(3);
        gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, indices.data());
        gl.DisableClientState(GL_COLOR_ARRAY);
        gl.DrawArrays(GL_TRIANGLES, 6, 6);  // the current colour is that of the last glColor
        begin_end(9);
      },
      "mixed_with_begin_end");
}

TEST(ArraysRenders, ListsDereferenceWhenCompiled) {
  const auto draw = [](const GlFunctions& gl, bool in_buffer) {
    std::vector<Vertex> vertices = spiral(12);
    std::array<GLushort, 6> indices = {1, 3, 5, 5, 3, 7};
    GLuint buffer = 0;
    if (in_buffer) {
      gl.GenBuffers(1, &buffer);
      gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
      gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                    vertices.data(), GL_STATIC_DRAW);
      gl.EnableClientState(GL_VERTEX_ARRAY);
      gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), nullptr);
      gl.EnableClientState(GL_COLOR_ARRAY);
      gl.ColorPointer(4, GL_FLOAT, sizeof(Vertex),
                      reinterpret_cast<const void*>(offsetof(Vertex, color)));
    } else {
      point_at(gl, vertices);
    }
    gl.NewList(1, GL_COMPILE);
    gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, indices.data());
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) gl.ArrayElement(i);
    gl.End();
    gl.DrawArrays(GL_LINE_STRIP, 2, 9);
    gl.EndList();
    for (Vertex& vertex : vertices) vertex = {{0, 0, 0}, {1, 1, 1, 1}};
    if (in_buffer) gl.DeleteBuffers(1, &buffer);
    indices.fill(0);
    gl.DisableClientState(GL_VERTEX_ARRAY);
    gl.DisableClientState(GL_COLOR_ARRAY);
    gl.CallList(1);
  };
  expect_as_mesa([&](const GlFunctions& gl) { draw(gl, false); }, "list_of_arrays");
  expect_as_mesa([&](const GlFunctions& gl) { draw(gl, true); }, "list_of_buffers");
}

// As many vertices as make a mesh that is kept in the driver's memory.
TEST_P(ArraysMode, RendersListsAsMesa) {
  const std::vector<Vertex> vertices = spiral(64);
  std::vector<GLubyte> indices;
  for (unsigned i = 0; i < 48; ++i) indices.push_back(static_cast<GLubyte>(5 + i * 11 % 57));
  for (const bool indexed : {false, true})
    for (const bool colored : {false, true})
      expect_as_mesa(
          [&](const GlFunctions& gl) {
            gl.Scalef(0.9F, 0.9F, 0.5F);
            point_at(gl, vertices);
            if (!colored) gl.DisableClientState(GL_COLOR_ARRAY);
            gl.NewList(1, GL_COMPILE);
            if (indexed) gl.DrawElements(GetParam(), 47, GL_UNSIGNED_BYTE, indices.data());
            else gl.DrawArrays(GetParam(), 5, 55);
            gl.EndList();
            gl.Color3f(0.3F, 0.9F, 0.4F);
            gl.CallList(1);
            gl.Color3f(0.8F, 0.1F, 0.4F);
            gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
            gl.Translatef(0.1F, 0, 0);
            gl.CallList(1);
          },
          std::string("list_") + (indexed ? "elements_" : "arrays_") + (colored ? "colored_" : "") +
              kModeNames[GetParam()]);
}

TEST(ArraysRenders, ListsAreUploadedOnce) {
  const std::vector<Vertex> vertices = spiral(900);  // small ones join batches instead
  ours().recreate();
  const GlFunctions& gl = ours().gl;
  point_at(gl, vertices);
  gl.NewList(1, GL_COMPILE);
  gl.DrawArrays(GL_TRIANGLES, 0, 900);
  gl.EndList();
  gl.CallList(1);
  legacy_gl_flush();
  legacy_gl_reset_statistics();
  for (int i = 0; i < 3; ++i) gl.CallList(1);
  EXPECT_EQ(statistics().draws, 3U);
  EXPECT_EQ(statistics().vertex_bytes_uploaded, 0U);
}

TEST(ArraysRenders, ListsTakeCurrentValuesOfLater) {
  const std::vector<Vertex> vertices = spiral(6);
  expect_as_mesa(
      [&](const GlFunctions& gl) {
        point_at(gl, vertices);
        gl.DisableClientState(GL_COLOR_ARRAY);
        gl.NewList(1, GL_COMPILE);
        gl.DrawArrays(GL_TRIANGLES, 0, 6);
        gl.EndList();
        gl.Color3f(0.9F, 0.4F, 0.1F);
        gl.CallList(1);
      },
      "list_takes_current_color");
}

// Signed integers are normalised as in the vertex commands (GL 2.1 spec table 2.9), wherever they
// lie.
TEST(ArraysRenders, SignedColorsAsTheVertexCommands) {
  const std::array<GLfloat, 6> positions = {-0.9F, -0.9F, 0.9F, -0.9F, 0, 0.9F};
  const std::array<GLbyte, 12> colors = {0, 20, 127, 0, 90, 3, 60, 0, 1, 50, -3, 0};
  const Image expected = render(ours(), [&](const GlFunctions& gl) {
    gl.Begin(GL_TRIANGLES);
    for (unsigned i = 0; i < 3; ++i) {
      gl.Color3bv(&colors[4 * i]);
      gl.Vertex2fv(&positions[2 * i]);
    }
    gl.End();
  });
  for (const bool in_buffer : {false, true}) {
    const Image image = render(ours(), [&](const GlFunctions& gl) {
      gl.EnableClientState(GL_VERTEX_ARRAY);
      gl.EnableClientState(GL_COLOR_ARRAY);
      gl.VertexPointer(2, GL_FLOAT, 0, positions.data());
      const void* pointer = colors.data();
      if (in_buffer) {
        GLuint buffer = 0;
        gl.GenBuffers(1, &buffer);
        gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
        gl.BufferData(GL_ARRAY_BUFFER, sizeof colors, colors.data(), GL_STATIC_DRAW);
        pointer = nullptr;
      }
      gl.ColorPointer(3, GL_BYTE, 4, pointer);
      gl.DrawArrays(GL_TRIANGLES, 0, 3);
    });
    EXPECT_TRUE(compare(image, expected).identical());
  }
}

TEST(ArraysRenders, SharedVerticesAreUploadedOnce) {
  const std::vector<Vertex> vertices = spiral(100);
  std::vector<GLushort> indices;
  for (unsigned i = 0; i + 2 < 100; ++i)
    for (unsigned k = 0; k < 3; ++k) indices.push_back(static_cast<GLushort>(i + k));
  ours().recreate();
  const GlFunctions& gl = ours().gl;
  point_at(gl, vertices);
  legacy_gl_reset_statistics();
  gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT,
                  indices.data());
  EXPECT_EQ(statistics().vertices, 100U);
  EXPECT_EQ(statistics().vertex_bytes_uploaded, 100U * 7 * sizeof(float));
}

// As many vertices as go to the driver without a detour.
TEST_P(ArraysMode, RendersManyVerticesAsMesa) {
  std::vector<Vertex> vertices;
  for (unsigned i = 0; i < 3001; ++i) {
    const float x = static_cast<float>(i * 7 % 61) / 31 - 0.95F,
                y = static_cast<float>(i * 11 % 53) / 27 - 0.95F;
    vertices.push_back({{x, y, static_cast<float>(i) / 3001},
                        {static_cast<float>(i % 7) / 6, static_cast<float>(i % 5) / 4,
                         static_cast<float>(i % 3) / 2, 1}});
  }
  std::vector<GLushort> indices;
  for (unsigned i = 0; i < 2401; ++i) indices.push_back(static_cast<GLushort>(100 + i * 13 % 2900));
  for (const bool indexed : {false, true})
    expect_as_mesa(
        [&](const GlFunctions& gl) {
          gl.Enable(GL_DEPTH_TEST);
          gl.ShadeModel(GL_FLAT);
          point_at(gl, vertices);
          gl.Rotatef(20, 0, 0, 1);
          gl.Scalef(0.7F, 0.7F, 0.7F);
          gl.Begin(GL_POINTS);
          gl.Vertex2f(0.9F, 0.9F);
          gl.End();
          if (indexed) gl.DrawElements(GetParam(), 2399, GL_UNSIGNED_SHORT, &indices[1]);
          else gl.DrawArrays(GetParam(), 3, 2990);
        },
        std::string(indexed ? "many_elements_" : "many_arrays_") + kModeNames[GetParam()]);
}

TEST(ArraysRenders, ManyPositionsOfFourComponents) {
  std::vector<GLdouble> positions;
  for (int i = 0; i < 3000; ++i) {
    const double w = 1 + i % 4, x = i * 7 % 61 / 31.0 - 0.95, y = i * 11 % 53 / 27.0 - 0.95;
    positions.insert(positions.end(), {x * w, y * w, 0, w});
  }
  expect_as_mesa(
      [&](const GlFunctions& gl) {
        gl.EnableClientState(GL_VERTEX_ARRAY);
        gl.VertexPointer(4, GL_DOUBLE, 0, positions.data());
        gl.Color3f(0.9F, 0.5F, 0.1F);
        gl.DrawArrays(GL_POINTS, 0, 3000);
      },
      "many_positions_with_w");
}

TEST(ArraysRenders, DrawsOfOneStateShareABatch) {
  const std::vector<Vertex> vertices = spiral(30);
  ours().recreate();
  const GlFunctions& gl = ours().gl;
  point_at(gl, vertices);
  legacy_gl_reset_statistics();
  for (int i = 0; i < 10; ++i) gl.DrawArrays(GL_TRIANGLES, 3 * i, 3);
  EXPECT_EQ(statistics().draws, 1U);
}

TEST(ArraysErrors, DrawsFromAMappedBuffer) {
  ours().recreate();
  const GlFunctions& gl = ours().gl;
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, 64, nullptr, GL_STATIC_DRAW);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, 0, nullptr);
  gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
  gl.UnmapBuffer(GL_ARRAY_BUFFER);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST(ArraysErrors, RangeThatEndsBeforeItStarts) {
  ours().recreate();
  const GlFunctions& gl = ours().gl;
  const GLubyte index = 0;
  gl.DrawRangeElements(GL_POINTS, 2, 1, 1, GL_UNSIGNED_BYTE, &index);
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_VALUE});
}

}  // namespace legacy_gl::test
