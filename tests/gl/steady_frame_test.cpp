// A steady frame takes no memory: neither the scenes of the benchmark nor what they leave out.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "allocations.hpp"
#include "benchmark/speed_scenes.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {
namespace {

using Frame = std::function<void(const GlFunctions& gl)>;

constexpr int kFramesUntilSteady = 8;
constexpr int kSteadyFrames = 3;

void expect_no_allocations(RenderContext& context, const std::string& name, const Frame& prepare,
                           const Frame& frame) {
  const GlFunctions& gl = context.gl;
  prepare(gl);
  for (int i = 0; i < kFramesUntilSteady; ++i) {
    frame(gl);
    gl.Flush();
  }
  legacy_gl_reset_statistics();
  const std::uint64_t before = allocation_count();
  for (int i = 0; i < kSteadyFrames; ++i) {
    frame(gl);
    gl.Flush();
  }
  EXPECT_EQ(allocation_count() - before, 0u) << name;
  legacy_gl_statistics statistics;
  legacy_gl_get_statistics(&statistics);
  EXPECT_EQ(statistics.programs_generated, 0u) << name;
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR}) << name;
}

TEST(SteadyFrame, TheCounterCounts) {
  const std::uint64_t before = allocation_count();
  const std::vector<int> one(1000);
  EXPECT_EQ(one.size(), 1000u);
  EXPECT_EQ(allocation_count() - before, 1u);
}

TEST(SteadyFrame, OfTheBenchmarksScenesAllocatesNothing) {
  for (const SpeedScene& scene : speed_scenes()) {
    if (scene.first_frame_only) continue;
    CoreContext context(16, 16);
    expect_no_allocations(context, scene.name, scene.prepare, scene.frame);
  }
}

// As a program gets it that asks for nothing: small objects are lit on the processor.
TEST(SteadyFrame, OfSmallObjectsWithStandInsAllocatesNothing) {
  legacy_gl_options options{};
  options.programs = LEGACY_GL_PROGRAMS_GENERAL_FIRST;
  for (const SpeedScene& scene : speed_scenes()) {
    if (scene.name != "S4" && scene.name != "S4b" && scene.name != "S4i" && scene.name != "S8")
      continue;
    CoreContext context(16, 16, PixelFormat::rgba8, options);
    expect_no_allocations(context, scene.name, scene.prepare, scene.frame);
  }
}

TEST(SteadyFrame, OnOpenGlEsAllocatesNothing) {
  for (const SpeedScene& scene : speed_scenes()) {
    if (scene.name != "S1" && scene.name != "S4" && scene.name != "S8") continue;
    GlesContext context(16, 16);
    expect_no_allocations(context, scene.name, scene.prepare, scene.frame);
  }
}

struct Figure {
  const char* name;
  Frame prepare;
  Frame frame;
};

void view(const GlFunctions& gl) {
  set_up_view(gl);
  set_up_light(gl);
  set_up_material(gl);
}

void triangles(const GlFunctions& gl, GLenum mode, int count) {
  gl.Begin(mode);
  for (int i = 0; i < count; ++i) {
    const auto f = static_cast<float>(i);
    gl.Normal3f(0, 0.1F * f, 1);
    gl.Color3f(0.01F * f, 0.5F, 0.5F);
    gl.TexCoord2f(0.2F * f, 0.1F * f);
    gl.Vertex3f(0.1F * static_cast<float>(i % 4) - 0.2F, 0.02F * f, 0);
  }
  gl.End();
}

// Quads by index, points of their own vertices, strips: what the core profile draws otherwise.
void client_arrays(const GlFunctions& gl, int count) {
  static const std::vector<float> vertices = [] {
    std::vector<float> all;
    for (int i = 0; i < 6000; ++i)
      for (int axis = 0; axis < 3; ++axis)
        all.push_back(0.1F * static_cast<float>((i * (axis + 3)) % 11) - 0.5F);
    return all;
  }();
  static const std::vector<GLushort> indices = [] {
    std::vector<GLushort> all;
    for (int i = 0; i < 6000; ++i) all.push_back(static_cast<GLushort>((i * 7) % 6000));
    return all;
  }();
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, vertices.data());
  for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
    gl.DrawElements(mode, count, GL_UNSIGNED_SHORT, indices.data());
    gl.DrawArrays(mode, 0, count);
  }
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 12; ++i) gl.ArrayElement(i);
  gl.End();
  gl.DisableClientState(GL_VERTEX_ARRAY);
}

// The same arrays from buffer objects.
void fill_buffers(const GlFunctions& gl) {
  view(gl);
  std::array<GLuint, 2> names{};
  gl.GenBuffers(2, names.data());
  std::vector<float> vertices;
  std::vector<GLuint> indices;
  for (int i = 0; i < 300; ++i) {
    for (int axis = 0; axis < 3; ++axis)
      vertices.push_back(0.1F * static_cast<float>((i * (axis + 3)) % 11) - 0.5F);
    indices.push_back(static_cast<GLuint>((i * 7) % 300));
  }
  gl.BindBuffer(GL_ARRAY_BUFFER, names[0]);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(float)),
                vertices.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(GLuint)),
                indices.data(), GL_STATIC_DRAW);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
}

void draw_buffers(const GlFunctions& gl) {
  clear_frame(gl);
  for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
    gl.DrawElements(mode, 300, GL_UNSIGNED_INT, nullptr);
    gl.DrawArrays(mode, 0, 300);
  }
}

void make_texture(const GlFunctions& gl) {
  view(gl);
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  const std::array<GLubyte, 16> texels{255, 0, 0,   255, 0, 255, 0, 255,
                                       0,   0, 255, 255, 9, 9,   9, 255};
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.Enable(GL_TEXTURE_2D);
}

void textured(const GlFunctions& gl) {
  clear_frame(gl);
  gl.MatrixMode(GL_TEXTURE);
  gl.PushMatrix();
  gl.Scalef(2, 2, 2);
  triangles(gl, GL_QUADS, 16);
  gl.PopMatrix();
  gl.MatrixMode(GL_MODELVIEW);
  gl.Disable(GL_LIGHTING);
  triangles(gl, GL_TRIANGLE_STRIP, 16);
  gl.Enable(GL_LIGHTING);
}

// Attribute groups, queries, fog, clip planes and materials inside Begin/End.
void state(const GlFunctions& gl) {
  clear_frame(gl);
  std::array<float, 16> values{};
  gl.PushAttrib(GL_ALL_ATTRIB_BITS);
  gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  gl.Enable(GL_FOG);
  gl.Enable(GL_CLIP_PLANE0);
  triangles(gl, GL_QUAD_STRIP, 12);
  gl.Disable(GL_CLIP_PLANE0);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 6; ++i) {
    const std::array<float, 4> color{0.1F * static_cast<float>(i), 0.5F, 0, 1};
    gl.Materialfv(GL_FRONT, GL_DIFFUSE, color.data());
    gl.Vertex3f(0.1F * static_cast<float>(i), static_cast<float>(i % 2), 0);
  }
  gl.End();
  gl.PopClientAttrib();
  gl.PopAttrib();
  gl.GetFloatv(GL_MODELVIEW_MATRIX, values.data());
  gl.GetMaterialfv(GL_FRONT, GL_DIFFUSE, values.data());
  (void)gl.GetString(GL_VENDOR);
  (void)gl.GetError();
}

void unfilled(const GlFunctions& gl) {
  clear_frame(gl);
  gl.PolygonMode(GL_FRONT, GL_LINE);
  gl.PolygonMode(GL_BACK, GL_POINT);
  for (GLenum mode = GL_TRIANGLES; mode <= GL_POLYGON; ++mode) triangles(gl, mode, 12);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

void nested_lists(const GlFunctions& gl) {
  view(gl);
  gl.NewList(1, GL_COMPILE);
  triangles(gl, GL_QUADS, 16);
  triangles(gl, GL_TRIANGLE_FAN, 16);
  gl.EndList();
  gl.NewList(2, GL_COMPILE);
  gl.PushMatrix();
  gl.Rotatef(20, 0, 0, 1);
  gl.CallList(1);
  gl.PopMatrix();
  gl.EndList();
}

void call_lists(const GlFunctions& gl) {
  clear_frame(gl);
  const std::array<GLubyte, 4> names{1, 2, 1, 2};
  gl.CallLists(4, GL_UNSIGNED_BYTE, names.data());
}

void letters(const GlFunctions& gl) {
  clear_frame(gl);
  const std::array<GLubyte, 8> glyph{0x18, 0x24, 0x42, 0x42, 0x7E, 0x42, 0x42, 0x42};
  gl.RasterPos3f(0, 0, 0);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (int i = 0; i < 20; ++i) gl.Bitmap(8, 8, 0, 0, 9, 0, glyph.data());
}

TEST(SteadyFrame, OfEveryOtherWayToDrawAllocatesNothing) {
  const std::vector<Figure> figures{
      {"few vertices of client arrays", view,
       [](const GlFunctions& gl) {
         clear_frame(gl);
         client_arrays(gl, 60);
       }},
      {"many vertices of client arrays", view,
       [](const GlFunctions& gl) {
         clear_frame(gl);
         client_arrays(gl, 6000);
       }},
      {"buffer objects", fill_buffers, draw_buffers},
      {"textures", make_texture, textured},
      {"state", view, state},
      {"unfilled", view, unfilled},
      {"lists", nested_lists, call_lists},
      {"bitmaps", view, letters},
  };
  for (const Figure& figure : figures) {
    CoreContext context(16, 16);
    expect_no_allocations(context, figure.name, figure.prepare, figure.frame);
  }
}

}  // namespace
}  // namespace legacy_gl::test
