// Every way of giving quads draws them as Mesa does, cut or whole: which diagonal divides a quad is
// seen where its colours are not linear.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <map>
#include <tuple>
#include <vector>

#include "support/contexts.hpp"
#include "support/shared_context.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kSize = 64;

struct Vertex {
  std::array<GLfloat, 3> position;
  std::array<GLfloat, 3> color;
};

constexpr std::array<Vertex, 8> kVertices{{{{1, 1, 0}, {1, 0, 0}},
                                           {{7, 2, 0}, {0, 1, 0}},
                                           {{6, 7, 0}, {0, 0, 1}},
                                           {{2, 6, 0}, {1, 1, 0}},
                                           {{1, 6.5F, 0.1F}, {0, 1, 1}},
                                           {{2, 0.5F, 0.2F}, {1, 0, 1}},
                                           {{4, 0.75F, 0.3F}, {1, 1, 1}},
                                           {{4.5F, 5, 0.2F}, {0, 0.5F, 0}}}};
constexpr auto kCount = static_cast<GLsizei>(kVertices.size());
constexpr std::array<GLushort, 8> kElements{0, 1, 2, 3, 4, 5, 6, 7};

enum class Way { begin_end, list, client_arrays, client_elements, buffer, short_buffer, elements };
constexpr std::array kWays{Way::begin_end,       Way::list,   Way::client_arrays,
                           Way::client_elements, Way::buffer, Way::short_buffer,
                           Way::elements};

void by_begin_end(const GlFunctions& gl, GLenum mode) {
  gl.Begin(mode);
  for (const Vertex& vertex : kVertices) {
    gl.Color3fv(vertex.color.data());
    gl.Vertex3fv(vertex.position.data());
  }
  gl.End();
}

GLuint make_buffer(const GlFunctions& gl, GLenum target, std::size_t size, const void* data) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(target, buffer);
  gl.BufferData(target, static_cast<GLsizeiptr>(size), data, GL_STATIC_DRAW);
  return buffer;
}

/// Positions in twentieths.
std::vector<std::array<GLshort, 4>> short_positions() {
  std::vector<std::array<GLshort, 4>> positions;
  for (const Vertex& vertex : kVertices) {
    std::array<GLshort, 4>& to = positions.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<GLshort>(20 * vertex.position[c]);
    to[3] = 20;
  }
  return positions;
}

void by_arrays(const GlFunctions& gl, GLenum mode, Way way) {
  const bool in_buffer = way == Way::buffer || way == Way::short_buffer || way == Way::elements;
  if (in_buffer) make_buffer(gl, GL_ARRAY_BUFFER, sizeof kVertices, kVertices.data());
  const auto* const base = in_buffer ? nullptr : reinterpret_cast<const GLubyte*>(&kVertices);
  gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), base);
  gl.ColorPointer(3, GL_FLOAT, sizeof(Vertex), base + sizeof(Vertex::position));
  if (way == Way::short_buffer) {
    const auto positions = short_positions();
    make_buffer(gl, GL_ARRAY_BUFFER, positions.size() * sizeof positions[0], positions.data());
    gl.VertexPointer(4, GL_SHORT, 0, nullptr);
  }
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  if (way == Way::elements)
    make_buffer(gl, GL_ELEMENT_ARRAY_BUFFER, sizeof kElements, kElements.data());
  if (way == Way::elements || way == Way::client_elements)
    gl.DrawElements(mode, kCount, GL_UNSIGNED_SHORT,
                    way == Way::elements ? nullptr : kElements.data());
  else gl.DrawArrays(mode, 0, kCount);
}

void draw(const GlFunctions& gl, GLenum mode, Way way) {
  if (way == Way::begin_end) return by_begin_end(gl, mode);
  if (way != Way::list) return by_arrays(gl, mode, way);
  gl.NewList(1, GL_COMPILE);
  by_begin_end(gl, mode);
  gl.EndList();
  gl.CallList(1);
}

enum class Cut { nothing, view, near_plane, clip_plane };
constexpr std::array kCuts{Cut::nothing, Cut::view, Cut::near_plane, Cut::clip_plane};

Image picture(RenderContext& context, GLenum mode, Way way, Cut cut, GLenum shade_model) {
  context.recreate();
  const GlFunctions& gl = context.gl;
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.ShadeModel(shade_model);
  gl.Ortho(0, cut == Cut::view ? 5.3 : 8, 0, 8, cut == Cut::near_plane ? -0.17 : -1, 1);
  if (cut == Cut::clip_plane) {
    constexpr std::array<GLdouble, 4> plane{0.5, 0.3, 0, -2.2};
    gl.ClipPlane(GL_CLIP_PLANE0, plane.data());
    gl.Enable(GL_CLIP_PLANE0);
  }
  draw(gl, mode, way);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  return context.read_rgba8();
}

MesaContext& mesa() {
  static auto& context = make_shared_context<MesaContext>(kSize, kSize);
  return context;
}
CoreContext& core() {
  static auto& context = make_shared_context<CoreContext>(kSize, kSize);
  return context;
}
GlesContext& gles() {
  static auto& context = make_shared_context<GlesContext>(kSize, kSize);
  return context;
}

/// Mesa's pictures, each once.
const Image& mesa_picture(GLenum mode, Way way, Cut cut, GLenum shade_model) {
  static std::map<std::tuple<GLenum, Way, Cut, GLenum>, Image> pictures;
  const auto [at, fresh] = pictures.try_emplace({mode, way, cut, shade_model});
  if (fresh) at->second = picture(mesa(), mode, way, cut, shade_model);
  return at->second;
}

/// Pixels that differ by more than a step: the two round colours to RGBA8 that differ by the last
/// bits of a float.
int different_pixels(const Image& a, const Image& b) {
  int different = 0;
  for (std::size_t at = 0; at < a.bytes.size(); at += 4) {
    bool same = true;
    for (std::size_t c = at; c < at + 4; ++c)
      same = same && std::abs(int{a.bytes[c]} - int{b.bytes[c]}) <= 1;
    different += !same;
  }
  return different;
}

void compare_all(RenderContext& ours, bool clips, GLenum mode) {
  for (const GLenum shade_model : {GLenum{GL_SMOOTH}, GLenum{GL_FLAT}})
    for (const Cut cut : kCuts) {
      const Image first = picture(ours, mode, kWays[0], cut, shade_model);
      EXPECT_GT(covered_pixels(first), 1000);
      // Row D15: fragments behind a plane are discarded, and others may lie on its edge, which is
      // some 60 pixels long.
      const int allowed = !clips && cut == Cut::clip_plane ? 16 : 0;
      for (const Way way : kWays) {
        // Mesa splits strips that are cut along the other diagonal, in whatever way they come.
        const bool is_judge = mode != GL_QUAD_STRIP || shade_model == GL_FLAT;
        EXPECT_LE(different_pixels(picture(ours, mode, way, cut, shade_model),
                                   is_judge ? mesa_picture(mode, way, cut, shade_model) : first),
                  allowed)
            << "mode " << mode << ", shade model " << shade_model << ", cut "
            << static_cast<int>(cut) << ", way " << static_cast<int>(way);
      }
    }
}

class Quads : public testing::TestWithParam<GLenum> {};

INSTANTIATE_TEST_SUITE_P(Modes, Quads, testing::Values(GL_QUADS, GL_QUAD_STRIP, GL_POLYGON));

TEST_P(Quads, OfTheCoreProfile) { compare_all(core(), true, GetParam()); }
TEST_P(Quads, OfGles) { compare_all(gles(), false, GetParam()); }

}  // namespace

}  // namespace legacy_gl::test
