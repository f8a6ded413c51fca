#include "every_area.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace legacy_gl::test {

namespace {

constexpr int kTile = 16, kTilesInARow = kEveryAreaSize / kTile;

// Before each: the next tile is the viewport, and the state that of a new context but for that.
class Tiles {
 public:
  explicit Tiles(const GlFunctions& functions) : gl(functions) {}

  void draw(void (*area)(const GlFunctions&)) {
    const int column = next_ % kTilesInARow, row = next_ / kTilesInARow;
    ++next_;
    gl.PushAttrib(GL_ALL_ATTRIB_BITS);
    gl.PushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    gl.PushMatrix();
    gl.Viewport(column * kTile, row * kTile, kTile, kTile);
    area(gl);
    gl.MatrixMode(GL_MODELVIEW);
    gl.PopMatrix();
    gl.PopClientAttrib();
    gl.PopAttrib();
  }

 private:
  const GlFunctions& gl;
  int next_ = 0;
};

void light(const GlFunctions& gl) {
  constexpr std::array<GLfloat, 4> direction{0.3F, 0.4F, 1, 0}, place{0.2F, 0.1F, 2, 1},
      green{0.1F, 0.8F, 0.2F, 1};
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_LIGHT1);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, direction.data());
  gl.Lightfv(GL_LIGHT1, GL_POSITION, place.data());
  gl.Lightfv(GL_LIGHT1, GL_DIFFUSE, green.data());
  gl.Lightf(GL_LIGHT1, GL_SPOT_CUTOFF, 40);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, green.data());
  gl.Materialf(GL_FRONT, GL_SHININESS, 8);
}

void square(const GlFunctions& gl, GLenum mode, float size) {
  gl.Begin(mode);
  gl.Normal3f(0.1F, 0.2F, 0.97F);
  gl.TexCoord2f(0, 0);
  gl.Color3f(1, 0.2F, 0);
  gl.Vertex2f(-size, -size);
  gl.TexCoord2f(1, 0);
  gl.Color3f(0, 1, 0.3F);
  gl.Vertex2f(size, -size);
  gl.TexCoord2f(1, 1);
  gl.Vertex2f(size, size);
  gl.TexCoord2f(0, 1);
  gl.Color3f(0.2F, 0, 1);
  gl.Vertex2f(-size, size);
  gl.End();
}

void immediate(const GlFunctions& gl) {
  square(gl, GL_QUADS, 0.9F);
  square(gl, GL_LINE_LOOP, 0.5F);
  square(gl, GL_POINTS, 0.3F);
}

void lit(const GlFunctions& gl) {
  light(gl);
  square(gl, GL_POLYGON, 0.9F);
}

void materials(const GlFunctions& gl) {
  light(gl);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 12; ++i) {
    const auto step = static_cast<float>(i);
    const std::array<GLfloat, 4> color{step / 12, 1 - step / 12, 0.5F, 1};
    gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, color.data());
    gl.Vertex2f(-0.9F + step * 0.15F, i % 3 ? 0.8F : -0.8F);
  }
  gl.End();
}

void small_objects(const GlFunctions& gl) {
  light(gl);
  for (int i = 0; i < 12; ++i) {
    gl.PushMatrix();
    gl.Translatef(static_cast<float>(i % 4) * 0.45F - 0.7F, static_cast<float>(i) * 0.12F - 0.7F,
                  0);
    gl.Rotatef(static_cast<float>(i) * 10, 0, 1, 0);
    square(gl, GL_QUADS, 0.15F);
    gl.PopMatrix();
  }
}

void lists(const GlFunctions& gl) {
  const GLuint list = gl.GenLists(2);
  gl.NewList(list, GL_COMPILE);
  for (int i = 0; i < 40; ++i) {
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(0.02F * static_cast<float>(i), 0.4F, 0.9F);
    gl.Vertex2f(-0.9F, static_cast<float>(i) * 0.04F - 0.9F);
    gl.Vertex2f(0.9F, static_cast<float>(i) * 0.04F - 0.9F);
    gl.Vertex2f(0, static_cast<float>(i) * 0.04F - 0.86F);
    gl.End();
  }
  gl.EndList();
  gl.NewList(list + 1, GL_COMPILE_AND_EXECUTE);
  gl.Scalef(0.9F, 0.9F, 1);
  gl.CallList(list);
  gl.EndList();
  const std::array<GLubyte, 2> offsets{0, 1};
  gl.ListBase(list);
  gl.CallLists(2, GL_UNSIGNED_BYTE, offsets.data());
  gl.DeleteLists(list, 2);
}

constexpr std::array<GLubyte, 4 * 4 * 4> kTexels = [] {
  std::array<GLubyte, 64> texels{};
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<GLubyte>(i * 37 + 60);
  return texels;
}();

void textures(const GlFunctions& gl) {
  std::array<GLuint, 2> names{};
  gl.GenTextures(2, names.data());
  gl.BindTexture(GL_TEXTURE_2D, names[0]);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexels.data());
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, 2, 2, GL_RGB, GL_UNSIGNED_BYTE, kTexels.data());
  gl.Enable(GL_TEXTURE_2D);
  gl.ActiveTexture(GL_TEXTURE1);
  gl.BindTexture(GL_TEXTURE_1D, names[1]);
  gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl.TexImage1D(GL_TEXTURE_1D, 0, GL_LUMINANCE, 4, 0, GL_LUMINANCE, GL_FLOAT, [] {
    static constexpr std::array<GLfloat, 4> values{0.2F, 1, 0.6F, 0.9F};
    return values.data();
  }());
  gl.Enable(GL_TEXTURE_1D);
  gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  gl.Enable(GL_TEXTURE_GEN_S);
  square(gl, GL_QUADS, 0.9F);
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 4, 4, 0);
  std::array<GLfloat, 64> read{};
  gl.GetTexImage(GL_TEXTURE_1D, 0, GL_RGBA, GL_FLOAT, read.data());
  gl.DeleteTextures(2, names.data());
  gl.ActiveTexture(GL_TEXTURE0);
}

struct Vertex {
  std::array<GLfloat, 2> position;
  std::array<GLbyte, 4> normal;
  std::array<GLubyte, 4> color;
};
constexpr std::array<Vertex, 4> kVertices{{{{-0.9F, -0.9F}, {10, 20, 100, 0}, {255, 20, 0, 255}},
                                           {{0.9F, -0.9F}, {0, 90, 80, 0}, {0, 200, 80, 255}},
                                           {{0.9F, 0.9F}, {60, 0, 90, 0}, {30, 40, 255, 255}},
                                           {{-0.9F, 0.9F}, {0, 0, 127, 0}, {200, 200, 0, 255}}}};
constexpr std::array<GLushort, 4> kElements{3, 0, 1, 2};

void arrays_at(const GlFunctions& gl, const void* base) {
  const auto* const bytes = static_cast<const GLubyte*>(base);
  const auto at = [bytes](std::size_t offset) {
    return reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(bytes) + offset);
  };
  gl.VertexPointer(2, GL_FLOAT, sizeof(Vertex), at(offsetof(Vertex, position)));
  gl.NormalPointer(GL_BYTE, sizeof(Vertex), at(offsetof(Vertex, normal)));
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), at(offsetof(Vertex, color)));
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
}

void arrays(const GlFunctions& gl) {
  arrays_at(gl, kVertices.data());
  gl.DrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, kElements.data());
  gl.EnableClientState(GL_NORMAL_ARRAY);
  gl.Enable(GL_COLOR_MATERIAL);
  light(gl);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

void buffers(const GlFunctions& gl) {
  std::array<GLuint, 2> names{};
  gl.GenBuffers(2, names.data());
  gl.BindBuffer(GL_ARRAY_BUFFER, names[0]);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof kVertices, kVertices.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, names[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof kElements, nullptr, GL_DYNAMIC_DRAW);
  gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 0, sizeof kElements, kElements.data());
  arrays_at(gl, nullptr);
  gl.DrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, nullptr);
  gl.EnableClientState(GL_NORMAL_ARRAY);
  light(gl);
  gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr);
  if (void* const mapped = gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE)) {
    static_cast<Vertex*>(mapped)->color[0] = 90;
    gl.UnmapBuffer(GL_ARRAY_BUFFER);
  }
  gl.DrawArrays(GL_LINE_LOOP, 0, 4);
  gl.DeleteBuffers(2, names.data());
}

void many_vertices(const GlFunctions& gl) {
  static const auto positions = [] {
    std::array<GLfloat, 3 * 3000> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<GLfloat>(i * 7919 % 181) / 100 - 0.9F;
    return values;
  }();
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, positions.data());
  gl.Color3f(0.4F, 0.7F, 0.1F);
  gl.DrawArrays(GL_POINTS, 0, 3000);
}

void unfilled(const GlFunctions& gl) {
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.LineStipple(1, 0xF0F0);
  gl.Enable(GL_LINE_STIPPLE);
  square(gl, GL_POLYGON, 0.8F);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  gl.PointSize(3);
  square(gl, GL_QUADS, 0.4F);
}

void wide_and_stippled(const GlFunctions& gl) {
  gl.LineWidth(3);
  square(gl, GL_LINE_STRIP, 0.8F);
  std::array<GLubyte, 128> pattern{};
  for (std::size_t i = 0; i < pattern.size(); ++i) pattern[i] = i % 8 < 4 ? 0xAA : 0x55;
  gl.PolygonStipple(pattern.data());
  gl.Enable(GL_POLYGON_STIPPLE);
  square(gl, GL_QUADS, 0.5F);
  gl.Enable(GL_POINT_SMOOTH);
  gl.PointSize(5);
  square(gl, GL_POINTS, 0.7F);
}

void pixels(const GlFunctions& gl) {
  constexpr std::array<GLubyte, 8> glyph{0x18, 0x3C, 0x66, 0xC3, 0xFF, 0xC3, 0xC3, 0xC3};
  gl.RasterPos2f(-0.9F, -0.9F);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.Bitmap(8, 8, 0, 0, 8, 0, glyph.data());
  gl.Bitmap(8, 8, 0, 0, 0, 8, glyph.data());
  gl.PixelZoom(1.5F, 1.5F);
  gl.DrawPixels(4, 4, GL_RGBA, GL_UNSIGNED_BYTE, kTexels.data());
  gl.CopyPixels(0, 0, 3, 3, GL_COLOR);
  std::array<GLubyte, 64> read{};
  gl.ReadPixels(0, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
}

void states(const GlFunctions& gl) {
  constexpr std::array<GLdouble, 4> plane{1, 0.4, 0, 0.5};
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, GL_EXP2);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.1F);
  gl.ClipPlane(GL_CLIP_PLANE0, plane.data());
  gl.Enable(GL_CLIP_PLANE0);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(0, 0, kEveryAreaSize, kEveryAreaSize);
  square(gl, GL_QUADS, 0.9F);
}

void evaluators(const GlFunctions& gl) {
  constexpr std::array<GLfloat, 12> points{-0.9F, -0.9F, 0, 0.9F, -0.9F, 0,
                                           -0.9F, 0.9F,  0, 0.9F, 0.9F,  0};
  gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, points.data());
  gl.Enable(GL_MAP2_VERTEX_3);
  gl.MapGrid2f(3, 0, 1, 3, 0, 1);
  gl.Color3f(0.8F, 0.3F, 0.6F);
  gl.EvalMesh2(GL_FILL, 0, 3, 0, 3);
}

void selection_and_feedback(const GlFunctions& gl) {
  static std::array<GLuint, 32> hits;  // the mode may outlive this function where memory lacks
  gl.SelectBuffer(32, hits.data());
  gl.RenderMode(GL_SELECT);
  gl.InitNames();
  gl.PushName(7);
  square(gl, GL_QUADS, 0.9F);
  const GLint count = gl.RenderMode(GL_RENDER);
  static std::array<GLfloat, 64> values;
  gl.FeedbackBuffer(64, GL_3D_COLOR, values.data());
  gl.RenderMode(GL_FEEDBACK);
  square(gl, GL_TRIANGLES, 0.9F);
  const GLint written = gl.RenderMode(GL_RENDER);
  gl.Color3f(0.2F, count == 1 ? 0.9F : 0.0F, written > 0 ? 0.9F : 0.0F);
  gl.Rectf(-0.7F, -0.7F, 0.7F, 0.7F);
}

void queries_and_accumulation(const GlFunctions& gl) {
  GLuint query = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_SAMPLES_PASSED, query);
  gl.Color3f(0.3F, 0.3F, 0.9F);
  gl.Rectf(-0.5F, -0.5F, 0.5F, 0.5F);
  gl.EndQuery(GL_SAMPLES_PASSED);
  GLuint samples = 0;
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  gl.DeleteQueries(1, &query);
  gl.Accum(GL_LOAD, 0.5F);
  gl.Accum(GL_ADD, samples ? 0.25F : 0.0F);
  gl.Accum(GL_RETURN, 1);
  GLfloat matrix[16];
  gl.GetFloatv(GL_MODELVIEW_MATRIX, matrix);
  gl.GetString(GL_EXTENSIONS);
}

}  // namespace

void draw_every_area(const GlFunctions& gl) {
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  Tiles tiles(gl);
  for (const auto area : {immediate, lit, materials, small_objects, lists, textures, arrays,
                          buffers, many_vertices, unfilled, wide_and_stippled, pixels, states,
                          evaluators, selection_and_feedback, queries_and_accumulation})
    tiles.draw(area);
  gl.Finish();
}

}  // namespace legacy_gl::test
