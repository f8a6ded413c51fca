// Buffer objects (GL 2.1 spec 2.9).
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstring>
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
  std::array<GLfloat, 3> normal;
  std::array<GLubyte, 4> color;
};

// Four triangles' worth of vertices around the centre.
std::vector<Vertex> fan(unsigned count) {
  std::vector<Vertex> vertices;
  for (unsigned i = 0; i < count; ++i) {
    const float x = static_cast<float>(i * 29 % 19) / 10 - 0.9F;
    const float y = static_cast<float>(i * 17 % 19) / 10 - 0.9F;
    const auto shade = static_cast<GLubyte>(40 + i * 50 % 200);
    vertices.push_back({{x, y, 0.03F * static_cast<float>(i)},
                        {0.3F, 0.1F * static_cast<float>(i % 5), 0.9F},
                        {shade, static_cast<GLubyte>(255 - shade), 90, 255}});
  }
  return vertices;
}

CoreContext& core() {
  static auto& context = make_shared_context<CoreContext>(kSize, kSize);
  return context;
}
MesaContext& mesa() {
  static auto& context = make_shared_context<MesaContext>(kSize, kSize);
  return context;
}
GlesContext& gles() {
  static auto& context = make_shared_context<GlesContext>(kSize, kSize);
  return context;
}

GLuint make_buffer(const GlFunctions& gl, GLenum target, std::size_t size, const void* data) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(size), data, GL_STATIC_DRAW);
  return buffer;
}

const void* offset_of(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void point_into_buffer(const GlFunctions& gl, const std::vector<Vertex>& vertices) {
  make_buffer(gl, GL_ARRAY_BUFFER, vertices.size() * sizeof(Vertex), vertices.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), offset_of(offsetof(Vertex, position)));
  gl.NormalPointer(GL_FLOAT, sizeof(Vertex), offset_of(offsetof(Vertex, normal)));
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), offset_of(offsetof(Vertex, color)));
}

template <typename Draw>
Image render(RenderContext& context, Draw draw) {
  context.recreate();
  context.gl.ClearColor(0, 0, 0, 0);
  context.gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw(context.gl);
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
  return context.read();
}

// One step: two round colours to RGBA8 that differ by the last bits of a float.
template <typename Draw>
void expect_as_mesa(Draw draw, const std::string& name) {
  const Image reference = render(mesa(), draw);
  EXPECT_GT(covered_pixels(reference), 5) << name;
  EXPECT_TRUE(images_match(render(core(), draw), reference, {.max_difference_steps = 1}, name));
}

legacy_gl_statistics statistics() {
  legacy_gl_flush();
  legacy_gl_statistics values{};
  legacy_gl_get_statistics(&values);
  return values;
}

GLint parameter(const GlFunctions& gl, GLenum name) {
  GLint value = -1;
  gl.GetBufferParameteriv(GL_ARRAY_BUFFER, name, &value);
  return value;
}

// Both dialects: they read and map by different functions.
class BufferObjects : public testing::TestWithParam<bool> {
 protected:
  RenderContext& context() {
    if (GetParam()) return gles();
    return core();
  }
  const GlFunctions& fresh() {
    context().recreate();
    return context().gl;
  }
};

class BufferObjectsMode : public testing::TestWithParam<unsigned> {};

std::string dialect_name(const testing::TestParamInfo<bool>& gles_too) {
  return gles_too.param ? "es_300" : "core_330";
}

}  // namespace

// As in Mesa, and as OpenGL ES 3.0 refuses a range of no bytes.
TEST_P(BufferObjects, WithoutBytesAreNotMapped) {
  for (RenderContext* const each : {&context(), static_cast<RenderContext*>(&mesa())}) {
    each->recreate();
    const GlFunctions& gl = each->gl;
    for (const GLenum target : {GLenum{GL_ARRAY_BUFFER}, GLenum{GL_ELEMENT_ARRAY_BUFFER}})
      for (const bool has_data : {false, true}) {
        GLuint buffer = 0;
        gl.GenBuffers(1, &buffer);
        gl.BindBuffer(target, buffer);
        if (has_data) gl.BufferData(target, 0, nullptr, GL_STATIC_DRAW);
        for (const GLenum access :
             {GLenum{GL_READ_ONLY}, GLenum{GL_WRITE_ONLY}, GLenum{GL_READ_WRITE}}) {
          EXPECT_EQ(gl.MapBuffer(target, access), nullptr);
          EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
        }
        EXPECT_EQ(gl.UnmapBuffer(target), GL_FALSE);
        EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
      }
  }
}

TEST_P(BufferObjects, AreNamesUntilTheyAreBound) {
  const GlFunctions& gl = fresh();
  std::array<GLuint, 2> names{};
  gl.GenBuffers(2, names.data());
  EXPECT_NE(names[0], 0U);
  EXPECT_NE(names[0], names[1]);
  EXPECT_FALSE(gl.IsBuffer(names[0]));
  gl.BindBuffer(GL_ARRAY_BUFFER, names[0]);
  EXPECT_TRUE(gl.IsBuffer(names[0]));
  EXPECT_FALSE(gl.IsBuffer(names[1]));
  EXPECT_FALSE(gl.IsBuffer(0));
  gl.DeleteBuffers(2, names.data());
  EXPECT_FALSE(gl.IsBuffer(names[0]));
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

// GL 1.5 lets a program choose names itself; the core profile does not.
TEST_P(BufferObjects, TakeNamesOfTheProgramsOwnChoice) {
  const GlFunctions& gl = fresh();
  for (GLuint name = 1; name < 40; ++name) {
    gl.BindBuffer(GL_ARRAY_BUFFER, name);
    gl.BufferData(GL_ARRAY_BUFFER, sizeof name, &name, GL_STATIC_DRAW);
  }
  GLuint generated = 0;
  gl.GenBuffers(1, &generated);
  EXPECT_FALSE(gl.IsBuffer(generated)) << "a name in use was given out";
  for (GLuint name = 1; name < 40; ++name) {
    GLuint contents = 0;
    gl.BindBuffer(GL_ARRAY_BUFFER, name);
    gl.GetBufferSubData(GL_ARRAY_BUFFER, 0, sizeof contents, &contents);
    EXPECT_EQ(contents, name);
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(BufferObjects, KeepData) {
  const GlFunctions& gl = fresh();
  const std::array<GLubyte, 6> data = {1, 2, 3, 4, 5, 6};
  make_buffer(gl, GL_ARRAY_BUFFER, 6, data.data());
  const std::array<GLubyte, 2> part = {40, 50};
  gl.BufferSubData(GL_ARRAY_BUFFER, 3, 2, part.data());
  std::array<GLubyte, 4> read{};
  gl.GetBufferSubData(GL_ARRAY_BUFFER, 2, 4, read.data());
  EXPECT_EQ(read, (std::array<GLubyte, 4>{3, 40, 50, 6}));
  EXPECT_EQ(parameter(gl, GL_BUFFER_SIZE), 6);
  EXPECT_EQ(parameter(gl, GL_BUFFER_USAGE), GL_STATIC_DRAW);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(BufferObjects, MapAndUnmap) {
  const GlFunctions& gl = fresh();
  const std::array<GLubyte, 4> data = {1, 2, 3, 4};
  make_buffer(gl, GL_ARRAY_BUFFER, 4, data.data());
  EXPECT_EQ(parameter(gl, GL_BUFFER_ACCESS), GL_READ_WRITE);
  EXPECT_EQ(parameter(gl, GL_BUFFER_MAPPED), GL_FALSE);
  auto* const mapped = static_cast<GLubyte*>(gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE));
  ASSERT_NE(mapped, nullptr);
  EXPECT_EQ(mapped[2], 3);
  mapped[2] = 30;
  void* pointer = nullptr;
  gl.GetBufferPointerv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
  EXPECT_EQ(pointer, mapped);
  EXPECT_EQ(parameter(gl, GL_BUFFER_MAPPED), GL_TRUE);
  EXPECT_TRUE(gl.UnmapBuffer(GL_ARRAY_BUFFER));
  gl.GetBufferPointerv(GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, &pointer);
  EXPECT_EQ(pointer, nullptr);
  std::array<GLubyte, 4> read{};
  gl.GetBufferSubData(GL_ARRAY_BUFFER, 0, 4, read.data());
  EXPECT_EQ(read[2], 30);
  gl.MapBuffer(GL_ARRAY_BUFFER, GL_WRITE_ONLY);
  EXPECT_EQ(parameter(gl, GL_BUFFER_ACCESS), GL_WRITE_ONLY);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  // New data ends the mapping.
  gl.BufferData(GL_ARRAY_BUFFER, 8, nullptr, GL_DYNAMIC_DRAW);
  EXPECT_EQ(parameter(gl, GL_BUFFER_MAPPED), GL_FALSE);
  EXPECT_FALSE(gl.UnmapBuffer(GL_ARRAY_BUFFER));
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
}

TEST_P(BufferObjects, LoseTheirBindingsWhenDeleted) {
  const GlFunctions& gl = fresh();
  const std::vector<Vertex> vertices = fan(6);
  point_into_buffer(gl, vertices);
  GLint name = 0, binding = -1;
  gl.GetIntegerv(GL_VERTEX_ARRAY_BUFFER_BINDING, &name);
  const auto buffer = static_cast<GLuint>(name);
  gl.DrawArrays(GL_TRIANGLES, 0, 6);
  gl.DeleteBuffers(1, &buffer);
  for (const auto query : {GL_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BUFFER_BINDING}) {
    gl.GetIntegerv(static_cast<GLenum>(query), &binding);
    EXPECT_EQ(binding, 0);
  }
  gl.DrawArrays(GL_TRIANGLES, 0, 6);  // an offset into nothing: no read through it
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(BufferObjects, DrawWithoutAnUpload) {
  const GlFunctions& gl = fresh();
  const std::vector<Vertex> vertices = fan(12);
  const std::array<GLushort, 6> indices = {0, 1, 2, 2, 1, 3};
  point_into_buffer(gl, vertices);
  make_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices.data());
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  legacy_gl_reset_statistics();
  gl.DrawArrays(GL_TRIANGLES, 0, 12);
  gl.DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, nullptr);
  EXPECT_EQ(statistics().draws, 2U);
  EXPECT_EQ(statistics().vertex_bytes_uploaded, 0U);
  EXPECT_EQ(statistics().index_bytes_uploaded, 0U);
  gl.DrawArrays(GL_QUADS, 0, 12);  // three quads are six triangles
  EXPECT_EQ(statistics().vertex_bytes_uploaded, 0U);
  EXPECT_EQ(statistics().index_bytes_uploaded, 18 * sizeof(GLuint));
}

// More than the buffer holds is undefined; it must not be a read of foreign memory, and what is
// there is drawn.
TEST_P(BufferObjects, SurviveDrawsPastTheirEnd) {
  const GlFunctions& gl = fresh();
  point_into_buffer(gl, fan(6));
  gl.DrawArrays(GL_TRIANGLES, 0, 6000);
  gl.DrawArrays(GL_TRIANGLES, 2'000'000'000, 3);
  const std::array<GLuint, 3> indices = {0, 1, 4'000'000'000U};
  gl.NewList(1, GL_COMPILE);
  gl.DrawArrays(GL_TRIANGLES, 3, 2'000'000'000);
  gl.EndList();
  gl.CallList(1);
  make_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices.data());
  gl.DrawElements(GL_TRIANGLES, 300, GL_UNSIGNED_INT, offset_of(8));
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

INSTANTIATE_TEST_SUITE_P(Dialects, BufferObjects, testing::Bool(), dialect_name);

TEST_P(BufferObjectsMode, RendersAsMesa) {
  const std::vector<Vertex> vertices = fan(16);
  const std::array<GLubyte, 15> indices = {0, 0, 0, 3, 4, 5, 9, 7, 12, 11, 2, 3, 15, 14, 1};
  for (const bool lit : {false, true})
    for (const bool flat : {false, true})
      for (const int elements : {0, 1, 2}) {  // none, in client memory, in a buffer
        const std::string name = "buffers_mode_" + std::to_string(GetParam()) +
                                 (lit ? "_lit" : "") + (flat ? "_flat" : "") + "_" +
                                 std::to_string(elements);
        expect_as_mesa(
            [&](const GlFunctions& gl) {
              if (lit) {
                gl.Enable(GL_LIGHTING);
                gl.Enable(GL_LIGHT0);
              }
              gl.ShadeModel(flat ? GL_FLAT : GL_SMOOTH);
              point_into_buffer(gl, vertices);
              if (elements == 2)
                make_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, indices.size(), indices.data());
              const void* const first = elements == 2 ? offset_of(3) : &indices[3];
              if (elements) gl.DrawElements(GetParam(), 12, GL_UNSIGNED_BYTE, first);
              else gl.DrawArrays(GetParam(), 2, 12);
            },
            name);
      }
}

INSTANTIATE_TEST_SUITE_P(All, BufferObjectsMode, testing::Range(0U, 10U));

// Arrays that are not enabled have the current values, and change with them between draws.
TEST(BufferObjectsRender, CurrentValues) {
  const std::vector<Vertex> vertices = fan(12);
  expect_as_mesa(
      [&](const GlFunctions& gl) {
        point_into_buffer(gl, vertices);
        gl.DisableClientState(GL_COLOR_ARRAY);
        gl.Color4f(0.9F, 0.2F, 0.4F, 1);
        gl.DrawArrays(GL_TRIANGLES, 0, 6);
        gl.Color4f(0.1F, 0.8F, 0.4F, 1);
        gl.DrawArrays(GL_TRIANGLES, 6, 3);
        gl.DisableClientState(GL_NORMAL_ARRAY);
        gl.Enable(GL_LIGHTING);
        gl.Enable(GL_LIGHT0);
        gl.Normal3f(0.6F, 0, 0.8F);
        gl.DrawArrays(GL_TRIANGLES, 9, 3);
      },
      "buffers_current_values");
}

// What is drawn from buffers and what is recorded keep their order.
TEST(BufferObjectsRender, InOrderWithBeginEnd) {
  const std::vector<Vertex> vertices = fan(12);
  expect_as_mesa(
      [&](const GlFunctions& gl) {
        const auto square = [&gl](float size, float red) {
          gl.Color3f(red, 0.5F, 1 - red);
          gl.Rectf(-size, -size, size, size);
        };
        square(0.9F, 0.2F);
        point_into_buffer(gl, vertices);
        gl.DrawArrays(GL_TRIANGLES, 0, 12);
        square(0.2F, 0.9F);
        gl.BindBuffer(GL_ARRAY_BUFFER, 0);
        gl.DrawArrays(GL_LINE_STRIP, 0, 12);
      },
      "buffers_in_order");
}

TEST(BufferObjectsRender, SharedVerticesInADeletedAndRemadeBuffer) {
  const std::vector<Vertex> first = fan(6), second = fan(12);
  expect_as_mesa(
      [&](const GlFunctions& gl) {
        point_into_buffer(gl, first);
        gl.DrawArrays(GL_TRIANGLES, 0, 6);
        GLint name = 0;
        gl.GetIntegerv(GL_ARRAY_BUFFER_BINDING, &name);
        const auto buffer = static_cast<GLuint>(name);
        gl.DeleteBuffers(1, &buffer);
        point_into_buffer(gl, second);  // the driver may give the same name again
        gl.DrawArrays(GL_TRIANGLES, 6, 6);
      },
      "buffers_remade");
}

}  // namespace legacy_gl::test
