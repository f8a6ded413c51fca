// Feedback (GL 2.1 spec 5.3), beside Mesa's.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kWidth = 64, kHeight = 48;
constexpr GLenum kTypes[] = {GL_2D, GL_3D, GL_3D_COLOR, GL_3D_COLOR_TEXTURE, GL_4D_COLOR_TEXTURE};

using Values = std::vector<GLfloat>;
using Draw = void (*)(const GlFunctions&);

/// Written behind the values: what must not be touched.
constexpr GLfloat kUntouched = -12345;

struct FedBack {
  GLint count = 0;
  Values buffer;
};

FedBack feed_back(const GlFunctions& gl, GLenum type, Draw draw, GLsizei size = 4096) {
  FedBack result;
  result.buffer.assign(static_cast<std::size_t>(size) + 8, kUntouched);
  gl.FeedbackBuffer(size, type, result.buffer.data());
  EXPECT_EQ(gl.RenderMode(GL_FEEDBACK), 0);
  draw(gl);
  result.count = gl.RenderMode(GL_RENDER);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  for (std::size_t i = static_cast<std::size_t>(size); i < result.buffer.size(); ++i)
    EXPECT_EQ(result.buffer[i], kUntouched) << "behind the buffer";
  return result;
}

unsigned vertex_size(GLenum type) {
  switch (type) {
    case GL_2D: return 2;
    case GL_3D: return 3;
    case GL_3D_COLOR: return 7;
    case GL_3D_COLOR_TEXTURE: return 11;
    default: return 12;
  }
}

/// One token with all that belongs to it.
struct Token {
  GLenum name = 0;
  Values values;
  bool operator==(const Token&) const = default;
};

std::vector<Token> tokens_of(const FedBack& result, GLenum type) {
  std::vector<Token> tokens;
  const std::size_t vertex = vertex_size(type);
  for (auto at = result.buffer.begin(), end = at + result.count; at < end;) {
    Token token{static_cast<GLenum>(*at++), {}};
    std::size_t size = vertex;
    switch (token.name) {
      case GL_PASS_THROUGH_TOKEN: size = 1; break;
      case GL_LINE_TOKEN:
      case GL_LINE_RESET_TOKEN: size = 2 * vertex; break;
      case GL_POLYGON_TOKEN: size = 1 + static_cast<std::size_t>(*at) * vertex; break;
      case GL_POINT_TOKEN:
      case GL_BITMAP_TOKEN:
      case GL_DRAW_PIXEL_TOKEN:
      case GL_COPY_PIXEL_TOKEN: break;
      default: ADD_FAILURE() << "no token: " << token.name; return tokens;
    }
    if (end - at < static_cast<std::ptrdiff_t>(size)) {
      ADD_FAILURE() << "a token is cut off";
      return tokens;
    }
    token.values.assign(at, at + static_cast<std::ptrdiff_t>(size));
    at += static_cast<std::ptrdiff_t>(size);
    tokens.push_back(std::move(token));
  }
  return tokens;
}

std::string text_of(const std::vector<Token>& tokens) {
  std::string text;
  for (const Token& token : tokens) {
    text += std::to_string(token.name) + ":";
    for (const GLfloat value : token.values) text += " " + std::to_string(value);
    text += "\n";
  }
  return text;
}

/// Window coordinates of a 64-pixel window are sums of float32 whose last place is 4e-6; Mesa turns
/// y over and back, and interpolates what it cuts in float32. Colours: Mesa lights in float32, with
/// an error below 4e-6; the powers of shininess take up to 1e-5.
float tolerance(const Token& token, float value) {
  return token.name == GL_PASS_THROUGH_TOKEN ? 0 : 2e-5F * std::max(1.0F, std::abs(value));
}

bool near(const Token& a, const Token& b) {
  if (a.name != b.name || a.values.size() != b.values.size()) return false;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    if (!(std::abs(a.values[i] - b.values[i]) <= tolerance(a, a.values[i]))) return false;
  return true;
}

/// The specification asks that a segment which starts its stipple anew says so; row M20.
std::vector<Token> without_resets(std::vector<Token> tokens) {
  for (Token& token : tokens)
    if (token.name == GL_LINE_RESET_TOKEN) token.name = GL_LINE_TOKEN;
  return tokens;
}

class Feedback : public testing::Test {
 protected:
  void compare(Draw draw, std::size_t count) {
    for (const GLenum type : kTypes) {
      mesa_.recreate();
      const auto mesa = without_resets(tokens_of(feed_back(mesa_.gl, type, draw), type));
      ours_.recreate();
      const auto ours = without_resets(tokens_of(feed_back(ours_.gl, type, draw), type));
      EXPECT_EQ(ours.size(), count) << type;
      bool same = mesa.size() == ours.size();
      for (std::size_t i = 0; same && i < mesa.size(); ++i) same = near(mesa[i], ours[i]);
      EXPECT_TRUE(same) << "type " << type << "\nMesa:\n"
                        << text_of(mesa) << "ours:\n"
                        << text_of(ours);
    }
  }

  MesaContext mesa_{kWidth, kHeight};
  CoreContext ours_{kWidth, kHeight};
};

/// Each vertex differs in all that a vertex has.
void ring(const GlFunctions& gl, GLenum mode, int count, float radius = 0.7F) {
  gl.Begin(mode);
  for (int i = 0; i < count; ++i) {
    const float part = static_cast<float>(i) / static_cast<float>(count);
    const float turn = 6.2831853F * part;
    gl.Color4f(part, 1 - part, 0.25F, 0.5F + 0.5F * part);
    gl.TexCoord4f(part, 2 * part, 0.5F, 1 + part);
    gl.Normal3f(0.3F * std::cos(turn), 0.3F * std::sin(turn), 0.9F);
    gl.Vertex3f(radius * std::cos(turn), radius * std::sin(turn), 0.2F - 0.5F * part);
  }
  gl.End();
}

void perspective(const GlFunctions& gl) {
  gl.MatrixMode(GL_PROJECTION);
  gl.Frustum(-0.6, 0.6, -0.5, 0.5, 1, 6);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Translatef(0, 0, -2);
  gl.Rotatef(25, 0.3F, 1, 0.1F);
}

void light(const GlFunctions& gl) {
  constexpr GLfloat position[] = {1, 2, 3, 1}, specular[] = {0.5F, 0.25F, 0.75F, 1};
  constexpr GLfloat red[] = {0.9F, 0.2F, 0.1F, 0.75F}, blue[] = {0.1F, 0.2F, 0.9F, 0.5F};
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_NORMALIZE);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  gl.Materialfv(GL_FRONT, GL_DIFFUSE, red);
  gl.Materialfv(GL_BACK, GL_DIFFUSE, blue);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 12);
}

void enable_texture(const GlFunctions& gl) {
  constexpr GLubyte texel[] = {1, 2, 3, 4};
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
}

void draw_with_texture_coordinates(const GlFunctions& gl) {
  perspective(gl);
  gl.MatrixMode(GL_TEXTURE);
  gl.Translatef(0.1F, 0.2F, 0.3F);
  gl.Scalef(2, 3, 0.5F);
  gl.MatrixMode(GL_MODELVIEW);
  ring(gl, GL_TRIANGLES, 3);
  constexpr GLfloat plane[] = {0.5F, 1, 0.25F, 0.125F};
  gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  gl.TexGenfv(GL_S, GL_OBJECT_PLANE, plane);
  gl.TexGenfv(GL_T, GL_EYE_PLANE, plane);
  gl.Enable(GL_TEXTURE_GEN_S);
  gl.Enable(GL_TEXTURE_GEN_T);
  ring(gl, GL_TRIANGLES, 3);
  gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
  gl.TexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
  ring(gl, GL_LINES, 2);
  gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
  gl.TexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_NORMAL_MAP);
  ring(gl, GL_POINTS, 3);
}

}  // namespace

TEST_F(Feedback, InitialState) {
  GLint size = -1, type = 0;
  void* pointer = this;
  ours_.gl.GetIntegerv(GL_FEEDBACK_BUFFER_SIZE, &size);
  ours_.gl.GetIntegerv(GL_FEEDBACK_BUFFER_TYPE, &type);
  ours_.gl.GetPointerv(GL_FEEDBACK_BUFFER_POINTER, &pointer);
  EXPECT_EQ(size, 0);
  EXPECT_EQ(type, GL_2D);
  EXPECT_EQ(pointer, nullptr);
}

TEST_F(Feedback, SetAndGet) {
  std::array<GLfloat, 8> buffer{};
  GLint size = -1, type = 0, mode = 0;
  void* pointer = nullptr;
  ours_.make_current();
  ours_.gl.FeedbackBuffer(8, GL_3D_COLOR, buffer.data());
  EXPECT_EQ(ours_.gl.RenderMode(GL_FEEDBACK), 0);
  ours_.gl.GetIntegerv(GL_FEEDBACK_BUFFER_SIZE, &size);
  ours_.gl.GetIntegerv(GL_FEEDBACK_BUFFER_TYPE, &type);
  ours_.gl.GetIntegerv(GL_RENDER_MODE, &mode);
  ours_.gl.GetPointerv(GL_FEEDBACK_BUFFER_POINTER, &pointer);
  EXPECT_EQ(size, 8);
  EXPECT_EQ(type, GL_3D_COLOR);
  EXPECT_EQ(mode, GL_FEEDBACK);
  EXPECT_EQ(pointer, buffer.data());
  EXPECT_EQ(ours_.gl.RenderMode(GL_RENDER), 0);
}

TEST_F(Feedback, OfEachPrimitive) {
  constexpr std::size_t kTokens[] = {7, 3, 7, 6, 2, 5, 5, 2, 4, 5};
  static GLenum mode;
  for (mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
    SCOPED_TRACE(mode);
    compare([](const GlFunctions& gl) { ring(gl, mode, 7); }, kTokens[mode]);
  }
}

TEST_F(Feedback, InPerspective) {
  compare(
      [](const GlFunctions& gl) {
        perspective(gl);
        gl.Viewport(5, 3, 40, 30);
        gl.DepthRange(0.25, 0.75);
        ring(gl, GL_POLYGON, 5);
        ring(gl, GL_LINE_STRIP, 3);
      },
      5);
}

TEST_F(Feedback, OfClippedPrimitives) {
  compare(
      [](const GlFunctions& gl) {
        ring(gl, GL_TRIANGLES, 3, 1.4F);
        ring(gl, GL_QUADS, 4, 1.3F);
        ring(gl, GL_POLYGON, 5, 1.2F);
        ring(gl, GL_LINE_LOOP, 3, 1.4F);
        ring(gl, GL_LINES, 4, 1.2F);
        ring(gl, GL_POINTS, 4, 1.1F);
      },
      25);
}

TEST_F(Feedback, OfWhatIsBehindTheEye) {
  compare(
      [](const GlFunctions& gl) {
        perspective(gl);
        gl.Begin(GL_TRIANGLES);
        gl.TexCoord2f(0, 0);
        gl.Vertex3f(-0.5F, -0.2F, -1);
        gl.TexCoord2f(1, 0);
        gl.Color3f(1, 0, 0);
        gl.Vertex3f(0.5F, -0.3F, -1.5F);
        gl.TexCoord2f(1, 1);
        gl.Color3f(0, 1, 0);
        gl.Vertex3f(0.2F, 0.4F, 3);
        gl.End();
        gl.Begin(GL_LINES);
        gl.Vertex3f(0, 0, -1);
        gl.Vertex3f(0.1F, 0.2F, 4);
        gl.End();
      },
      4);
}

TEST_F(Feedback, HeedsClipPlanes) {
  compare(
      [](const GlFunctions& gl) {
        constexpr GLdouble plane[] = {1, 0.5, 0, 0.125}, other[] = {-1, 0, 0.25, 0.5};
        gl.ClipPlane(GL_CLIP_PLANE1, plane);
        gl.ClipPlane(GL_CLIP_PLANE3, other);
        gl.Enable(GL_CLIP_PLANE1);
        gl.Enable(GL_CLIP_PLANE3);
        ring(gl, GL_TRIANGLES, 3);
        ring(gl, GL_LINE_LOOP, 5);
        ring(gl, GL_POINTS, 8);
      },
      9);
}

TEST_F(Feedback, OfLitVertices) {
  compare(
      [](const GlFunctions& gl) {
        light(gl);
        perspective(gl);
        ring(gl, GL_TRIANGLE_FAN, 6);
        gl.Enable(GL_COLOR_MATERIAL);
        ring(gl, GL_TRIANGLE_STRIP, 6);
        gl.Disable(GL_COLOR_MATERIAL);
        gl.Begin(GL_POINTS);
        gl.Normal3f(0, 0, 1);
        for (const float green : {0.2F, 0.4F, 0.6F}) {
          const GLfloat color[] = {0.1F, green, 0.3F, green};
          gl.Materialfv(GL_FRONT, GL_DIFFUSE, color);
          gl.Vertex2f(green, 0.1F);
        }
        gl.End();
      },
      11);
}

TEST_F(Feedback, OfBothSides) {
  compare(
      [](const GlFunctions& gl) {
        light(gl);
        gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
        ring(gl, GL_TRIANGLES, 3);
        gl.FrontFace(GL_CW);
        ring(gl, GL_TRIANGLES, 3);
        gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        ring(gl, GL_TRIANGLES, 3);
        ring(gl, GL_LINES, 2);
      },
      6);
}

TEST_F(Feedback, LeavesCulledPolygonsOut) {
  compare(
      [](const GlFunctions& gl) {
        gl.Enable(GL_CULL_FACE);
        ring(gl, GL_TRIANGLES, 3);
        gl.FrontFace(GL_CW);
        ring(gl, GL_QUADS, 4);
        gl.CullFace(GL_FRONT);
        ring(gl, GL_TRIANGLES, 3);
        gl.CullFace(GL_FRONT_AND_BACK);
        ring(gl, GL_TRIANGLES, 3);
        ring(gl, GL_POINTS, 1);
      },
      3);
}

TEST_F(Feedback, OfUnfilledPolygons) {
  compare(
      [](const GlFunctions& gl) {
        gl.PolygonMode(GL_FRONT, GL_LINE);
        gl.PolygonMode(GL_BACK, GL_POINT);
        for (GLenum mode = GL_TRIANGLES; mode <= GL_POLYGON; ++mode) ring(gl, mode, 6);
        gl.FrontFace(GL_CW);
        ring(gl, GL_POLYGON, 5);
        ring(gl, GL_QUADS, 4);
      },
      57);
}

TEST_F(Feedback, OfUnfilledClippedPolygons) {
  compare(
      [](const GlFunctions& gl) {
        constexpr GLdouble plane[] = {1, 0.5, 0, 0.125};
        gl.ClipPlane(GL_CLIP_PLANE1, plane);
        gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        ring(gl, GL_TRIANGLES, 3, 1.4F);
        ring(gl, GL_QUADS, 4, 1.3F);
        gl.Enable(GL_CLIP_PLANE1);
        ring(gl, GL_TRIANGLES, 3);
        gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
        ring(gl, GL_TRIANGLES, 3);
        gl.Disable(GL_CLIP_PLANE1);
        ring(gl, GL_TRIANGLES, 3, 1.4F);
      },
      18);
}

TEST_F(Feedback, FlatShadingOfLinesAndUnfilledPolygons) {
  compare(
      [](const GlFunctions& gl) {
        gl.ShadeModel(GL_FLAT);
        gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        ring(gl, GL_TRIANGLES, 6);
        ring(gl, GL_QUADS, 4);
        ring(gl, GL_POLYGON, 5);
        ring(gl, GL_LINE_LOOP, 3);
      },
      18);
}

TEST_F(Feedback, OfTextureCoordinates) {
  compare(
      [](const GlFunctions& gl) {
        enable_texture(gl);
        draw_with_texture_coordinates(gl);
      },
      6);
}

// Row M20: Mesa neither generates nor transforms them.
TEST_F(Feedback, OfTextureCoordinatesWithoutATexture) {
  ours_.recreate();
  const FedBack without = feed_back(ours_.gl, GL_4D_COLOR_TEXTURE, draw_with_texture_coordinates);
  ours_.recreate();
  enable_texture(ours_.gl);
  EXPECT_EQ(feed_back(ours_.gl, GL_4D_COLOR_TEXTURE, draw_with_texture_coordinates).buffer,
            without.buffer);
}

TEST_F(Feedback, OfPassThroughBitmapsAndPixels) {
  compare(
      [](const GlFunctions& gl) {
        constexpr GLubyte bits[16] = {};
        gl.PassThrough(7);
        gl.Begin(GL_POINTS);
        gl.Vertex2f(0, 0);
        gl.End();
        gl.PassThrough(-0.5F);
        gl.Color4f(0.25F, 0.5F, 0.75F, 1);
        gl.TexCoord3f(0.5F, 0.25F, 2);
        perspective(gl);
        gl.RasterPos3f(0.1F, 0.2F, 0.3F);
        gl.Bitmap(8, 4, 1, 2, 3, 4, bits);
        gl.Bitmap(8, 4, 0, 0, 0, 0, bits);
        gl.DrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, bits);
        gl.CopyPixels(0, 0, 2, 2, GL_COLOR);
        gl.RasterPos2f(9, 9);  // not valid
        gl.Bitmap(8, 4, 0, 0, 3, 4, bits);
        gl.DrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, bits);
        gl.CopyPixels(0, 0, 2, 2, GL_COLOR);
      },
      7);
}

TEST_F(Feedback, OfListsAndArrays) {
  compare(
      [](const GlFunctions& gl) {
        gl.NewList(1, GL_COMPILE);
        gl.PassThrough(3);
        ring(gl, GL_QUADS, 4);
        gl.EndList();
        gl.CallList(1);
        static constexpr GLfloat vertices[] = {0, 0, 0.5F, 0, 0, 0.5F};
        static constexpr GLfloat colors[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        static constexpr GLubyte elements[] = {2, 1, 0};
        gl.EnableClientState(GL_VERTEX_ARRAY);
        gl.EnableClientState(GL_COLOR_ARRAY);
        gl.VertexPointer(2, GL_FLOAT, 0, vertices);
        gl.ColorPointer(3, GL_FLOAT, 0, colors);
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
        gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, elements);
      },
      5);
}

TEST_F(Feedback, OverflowIsMinusOne) {
  for (RenderContext* const context :
       {static_cast<RenderContext*>(&mesa_), static_cast<RenderContext*>(&ours_)}) {
    context->recreate();
    const Draw draw = [](const GlFunctions& gl) { ring(gl, GL_POINTS, 3); };
    const FedBack whole = feed_back(context->gl, GL_2D, draw, 9);
    EXPECT_EQ(whole.count, 9);
    const FedBack cut = feed_back(context->gl, GL_2D, draw, 8);
    EXPECT_EQ(cut.count, -1);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(cut.buffer[i], whole.buffer[i]) << i;
  }
}

// Row M20.
TEST_F(Feedback, LinesThatStartTheirStippleSaySo) {
  ours_.recreate();
  const Draw draw = [](const GlFunctions& gl) {
    ring(gl, GL_LINES, 4);
    ring(gl, GL_LINE_STRIP, 4);
    ring(gl, GL_LINE_LOOP, 3);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    ring(gl, GL_QUADS, 4);
    ring(gl, GL_TRIANGLE_STRIP, 4);
    ring(gl, GL_QUADS, 4, 1.3F);
  };
  std::string resets;
  for (const Token& token : tokens_of(feed_back(ours_.gl, GL_2D, draw), GL_2D))
    resets += token.name == GL_LINE_RESET_TOKEN ? 'R' : '-';
  EXPECT_EQ(resets.substr(0, 18), "RRR--R--R---R--R--");
  EXPECT_EQ(resets.substr(18), "R---");
}

// Row M20.
TEST_F(Feedback, FlatShadingGivesAPolygonOneColor) {
  ours_.recreate();
  const Draw draw = [](const GlFunctions& gl) {
    gl.ShadeModel(GL_FLAT);
    ring(gl, GL_TRIANGLES, 3);
    ring(gl, GL_POLYGON, 4);
    ring(gl, GL_TRIANGLES, 3, 1.4F);
  };
  const auto tokens = tokens_of(feed_back(ours_.gl, GL_3D_COLOR, draw), GL_3D_COLOR);
  ASSERT_GE(tokens.size(), 4U);
  for (std::size_t i = 0; i < tokens.size(); ++i)
    for (std::size_t vertex = 0; vertex < 3; ++vertex) {
      // Of the vertex that table 2.12 names: a triangle's last, a polygon's first.
      const float part = i == 1 || i == 2 ? 0 : 2.0F / 3;
      EXPECT_NEAR(tokens[i].values[1 + 7 * vertex + 3], part, 1e-6) << i;
      EXPECT_NEAR(tokens[i].values[1 + 7 * vertex + 4], 1 - part, 1e-6) << i;
    }
}

// Row M20: Mesa leaves such a polygon out.
TEST_F(Feedback, EdgeFlagsChooseTheEdges) {
  ours_.recreate();
  const Draw draw = [](const GlFunctions& gl) {
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gl.Begin(GL_QUADS);
    for (int i = 0; i < 4; ++i) {
      gl.EdgeFlag(i % 2 == 0);
      gl.Vertex2f(i == 0 || i == 3 ? -0.5F : 0.5F, i < 2 ? -0.5F : 0.5F);
    }
    gl.End();
  };
  const std::vector<Token> expected{{GL_LINE_RESET_TOKEN, {16, 12, 48, 12}},
                                    {GL_LINE_TOKEN, {48, 36, 16, 36}}};
  EXPECT_EQ(tokens_of(feed_back(ours_.gl, GL_2D, draw), GL_2D), expected);
}

// GL 2.1 spec 5.3: no depth offset; row M20.
TEST_F(Feedback, PolygonOffsetLeavesDepthsAlone) {
  ours_.recreate();
  const Draw plain = [](const GlFunctions& gl) { ring(gl, GL_TRIANGLES, 3); };
  const Draw offset = [](const GlFunctions& gl) {
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(3, 100);
    ring(gl, GL_TRIANGLES, 3);
  };
  EXPECT_EQ(tokens_of(feed_back(ours_.gl, GL_3D, plain), GL_3D),
            tokens_of(feed_back(ours_.gl, GL_3D, offset), GL_3D));
}

TEST_F(Feedback, DrawsAndClearsNothing) {
  ours_.recreate();
  const GlFunctions& gl = ours_.gl;
  gl.Rectf(-1, -1, 1, 1);
  const Image before = ours_.read();
  ours_.make_current();
  feed_back(gl, GL_2D, [](const GlFunctions& g) {
    g.ClearColor(1, 0, 0, 1);
    g.Clear(GL_COLOR_BUFFER_BIT);
    g.Color3f(0, 1, 0);
    ring(g, GL_POLYGON, 5);
    constexpr GLubyte bits[64] = {};
    g.RasterPos2f(0, 0);
    g.Bitmap(8, 4, 0, 0, 0, 0, bits);
    g.DrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, bits);
  });
  EXPECT_TRUE(legacy_gl::test::compare(before, ours_.read()).identical());
}

}  // namespace legacy_gl::test
