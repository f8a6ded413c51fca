// What the driver's buffers hold is read back once, however often it is drawn: a map for reading
// waits for the GPU.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "support/contexts.hpp"
#include "support/driver_shim.hpp"

namespace legacy_gl::test {
namespace {

constexpr int kSize = 32;
constexpr GLsizei kVertices = 1200;  // enough for every way that arrays are drawn

class Reads : public DriverObserver {
 public:
  bool before(const DriverCall& call) override {
    if (call.is("glMapBufferRange") && call.argument(3) & GL_MAP_READ_BIT) ++count;
    if (call.is("glGetBufferSubData")) ++count;
    return true;
  }
  int count = 0;

 private:
  static constexpr std::uint64_t GL_MAP_READ_BIT = 1;
};

struct Case {
  const char* name;
  GLenum mode;
  GLsizei count;
  bool indexed;
  bool signed_normals;  // which core drivers normalise otherwise than OpenGL 1.x
  bool unfilled;
};

const std::vector<Case> kCases = {
    {"quads by elements", GL_QUADS, 24, true, false, false},
    {"a quad strip by elements", GL_QUAD_STRIP, 24, true, false, false},
    {"a polygon by elements", GL_POLYGON, 24, true, false, false},
    {"many quads by elements", GL_QUADS, kVertices, true, false, false},
    {"signed normals", GL_TRIANGLES, 24, false, true, false},
    {"many signed normals", GL_TRIANGLES, kVertices, false, true, false},
    {"signed normals by elements", GL_QUADS, kVertices, true, true, false},
    {"unfilled", GL_TRIANGLES, 24, false, false, true},
    {"unfilled by elements", GL_QUADS, 24, true, false, true},
};

struct Vertex {
  std::array<GLfloat, 3> position;
  std::array<GLbyte, 4> signed_normal;
  std::array<GLfloat, 3> normal;
};

std::vector<Vertex> make_vertices() {
  std::vector<Vertex> vertices;
  for (GLsizei i = 0; i < kVertices; ++i)
    vertices.push_back(
        {{static_cast<float>(i * 29 % 19) / 10 - 0.9F, static_cast<float>(i * 17 % 19) / 10 - 0.9F,
          static_cast<float>(i % 7) / 10},
         {10, static_cast<GLbyte>(i % 100), 100, 0},
         {0.1F, static_cast<float>(i % 100) / 100, 0.8F}});
  return vertices;
}

std::vector<GLuint> make_elements(GLuint shift) {
  std::vector<GLuint> elements;
  for (GLuint i = 0; i < GLuint{kVertices}; ++i)
    elements.push_back((i + shift) % GLuint{kVertices});
  return elements;
}

template <typename T>
void fill(const GlFunctions& gl, GLenum target, const std::vector<T>& data) {
  gl.BufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(),
                GL_STATIC_DRAW);
}

const void* at(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

class BufferReads : public testing::Test {
 protected:
  BufferReads()
      : context(kSize, kSize, PixelFormat::rgba8, {}, {.loader = shimmed_proc}), gl(context.gl) {
    gl.Enable(GL_LIGHTING);
    gl.Enable(GL_LIGHT0);
    std::array<GLuint, 2> names{};
    gl.GenBuffers(2, names.data());
    gl.BindBuffer(GL_ARRAY_BUFFER, names[0]);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
    fill(gl, GL_ARRAY_BUFFER, make_vertices());
    fill(gl, GL_ELEMENT_ARRAY_BUFFER, make_elements(0));
    gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), at(offsetof(Vertex, position)));
    gl.EnableClientState(GL_VERTEX_ARRAY);
    gl.EnableClientState(GL_NORMAL_ARRAY);
  }

  std::vector<std::uint8_t> draw(const Case& drawn) {
    if (drawn.signed_normals)
      gl.NormalPointer(GL_BYTE, sizeof(Vertex), at(offsetof(Vertex, signed_normal)));
    else gl.NormalPointer(GL_FLOAT, sizeof(Vertex), at(offsetof(Vertex, normal)));
    gl.PolygonMode(GL_FRONT_AND_BACK, drawn.unfilled ? GL_LINE : GL_FILL);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (drawn.indexed) gl.DrawElements(drawn.mode, drawn.count, GL_UNSIGNED_INT, nullptr);
    else gl.DrawArrays(drawn.mode, 0, drawn.count);
    return context.read_rgba8().bytes;
  }

  Reads reads;
  CoreContext context;
  const GlFunctions& gl;
};

TEST_F(BufferReads, ContentsAreReadOnce) {
  for (const Case& drawn : kCases) {
    fill(gl, GL_ARRAY_BUFFER, make_vertices());
    fill(gl, GL_ELEMENT_ARRAY_BUFFER, make_elements(0));
    const auto first = draw(drawn);
    const int after_first = reads.count;
    for (int i = 0; i < 5; ++i) EXPECT_EQ(draw(drawn), first) << drawn.name;
    EXPECT_EQ(reads.count, after_first) << drawn.name;
  }
}

// The judge is a context that draws the new contents for the first time.
TEST_F(BufferReads, ChangedContentsAreSeen) {
  for (const Case& drawn : kCases) {
    fill(gl, GL_ARRAY_BUFFER, make_vertices());
    std::vector<GLuint> elements = make_elements(7);
    fill(gl, GL_ELEMENT_ARRAY_BUFFER, elements);
    std::vector<Vertex> vertices = make_vertices();
    for (int i = 0; i < 2; ++i) vertices[2].position[static_cast<std::size_t>(i)] = 0.5F;
    elements[3] = 11;
    fill(gl, GL_ARRAY_BUFFER, vertices);
    fill(gl, GL_ELEMENT_ARRAY_BUFFER, elements);
    const auto expected = draw(drawn);

    fill(gl, GL_ARRAY_BUFFER, make_vertices());
    fill(gl, GL_ELEMENT_ARRAY_BUFFER, make_elements(7));
    for (int i = 0; i < 3; ++i) draw(drawn);
    gl.BufferSubData(GL_ARRAY_BUFFER, 2 * sizeof(Vertex), sizeof(Vertex), &vertices[2]);
    auto* const mapped = static_cast<GLuint*>(gl.MapBuffer(GL_ELEMENT_ARRAY_BUFFER, GL_READ_WRITE));
    ASSERT_NE(mapped, nullptr);
    mapped[3] = 11;
    gl.UnmapBuffer(GL_ELEMENT_ARRAY_BUFFER);
    EXPECT_EQ(draw(drawn), expected) << drawn.name;
  }
}

}  // namespace
}  // namespace legacy_gl::test
