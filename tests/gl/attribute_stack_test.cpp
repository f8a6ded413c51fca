// glPushAttrib, glPopAttrib and the client's stack (GL 2.1 spec 6.1.14). That each group brings
// back its state and no other is compared with Mesa by queries_test, and in pictures by the
// conformance scenes.
#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

enum class Implementation { mesa, core, gles };

const char* name_of(Implementation implementation) {
  switch (implementation) {
    case Implementation::mesa: return "mesa";
    case Implementation::core: return "core";
    case Implementation::gles: break;
  }
  return "gles";
}

std::unique_ptr<RenderContext> make_context(Implementation implementation) {
  switch (implementation) {
    case Implementation::mesa: return std::make_unique<MesaContext>(16, 16);
    case Implementation::core: return std::make_unique<CoreContext>(16, 16);
    case Implementation::gles: break;
  }
  return std::make_unique<GlesContext>(16, 16);
}

class AttributeStack : public testing::TestWithParam<Implementation> {
 protected:
  GLint get(GLenum name) {
    GLint value = -1;
    gl.GetIntegerv(name, &value);
    return value;
  }
  bool is_mesa() const { return GetParam() == Implementation::mesa; }

  std::unique_ptr<RenderContext> context = make_context(GetParam());
  const GlFunctions& gl = context->gl;
};

INSTANTIATE_TEST_SUITE_P(Implementations, AttributeStack,
                         testing::Values(Implementation::mesa, Implementation::core,
                                         Implementation::gles),
                         [](const auto& parameter) { return name_of(parameter.param); });

TEST_P(AttributeStack, InitialState) {
  EXPECT_EQ(get(GL_ATTRIB_STACK_DEPTH), 0);
  EXPECT_EQ(get(GL_CLIENT_ATTRIB_STACK_DEPTH), 0);
  EXPECT_EQ(get(GL_MAX_ATTRIB_STACK_DEPTH), 16);
  EXPECT_EQ(get(GL_MAX_CLIENT_ATTRIB_STACK_DEPTH), 16);
}

TEST_P(AttributeStack, Errors) {
  gl.PopAttrib();
  EXPECT_EQ(gl.GetError(), GLenum{GL_STACK_UNDERFLOW});
  gl.PopClientAttrib();
  EXPECT_EQ(gl.GetError(), GLenum{GL_STACK_UNDERFLOW});
  for (int i = 0; i < 16; ++i) {
    gl.PushAttrib(GL_LINE_BIT);
    gl.LineWidth(static_cast<float>(i + 2));
    gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  gl.PushAttrib(GL_LINE_BIT);
  EXPECT_EQ(gl.GetError(), GLenum{GL_STACK_OVERFLOW});
  gl.PushClientAttrib(0);
  EXPECT_EQ(gl.GetError(), GLenum{GL_STACK_OVERFLOW});
  EXPECT_EQ(get(GL_ATTRIB_STACK_DEPTH), 16);
  EXPECT_EQ(get(GL_CLIENT_ATTRIB_STACK_DEPTH), 16);
  for (int i = 15; i >= 0; --i) {
    gl.PopAttrib();
    EXPECT_EQ(get(GL_LINE_WIDTH), i == 0 ? 1 : i + 1);
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});

  gl.PushAttrib(GL_LINE_BIT);
  gl.Begin(GL_LINES);
  gl.PopAttrib();
  gl.End();
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
  EXPECT_EQ(get(GL_ATTRIB_STACK_DEPTH), 1);
}

TEST_P(AttributeStack, UnknownBitsAreNoError) {
  gl.PushAttrib(0xFFFFFFFF);
  gl.PushClientAttrib(0xFFFFFFFF);
  gl.PopClientAttrib();
  gl.PopAttrib();
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

/// GL 2.1 spec tables 6.8, 6.10 and 6.32: colour sum is of the groups FOG and ENABLE, a light's
/// enable of LIGHTING and ENABLE, the hint of HINT.
TEST_P(AttributeStack, BringsBackWhatMesaForgets) {
  for (const GLbitfield group :
       {GLbitfield{GL_FOG_BIT}, GLbitfield{GL_ENABLE_BIT}, GLbitfield{GL_ALL_ATTRIB_BITS}}) {
    gl.Disable(GL_COLOR_SUM);
    gl.PushAttrib(group);
    gl.Enable(GL_COLOR_SUM);
    gl.PopAttrib();
    EXPECT_EQ(gl.IsEnabled(GL_COLOR_SUM), is_mesa() ? GL_TRUE : GL_FALSE);
  }
  gl.PushAttrib(GL_ENABLE_BIT);
  gl.Enable(GL_LIGHT3);
  gl.PopAttrib();
  EXPECT_EQ(gl.IsEnabled(GL_LIGHT3), is_mesa() ? GL_TRUE : GL_FALSE);
  gl.PushAttrib(GL_HINT_BIT);
  gl.Hint(GL_GENERATE_MIPMAP_HINT, GL_NICEST);
  gl.PopAttrib();
  EXPECT_EQ(get(GL_GENERATE_MIPMAP_HINT), is_mesa() ? GL_NICEST : GL_DONT_CARE);
}

/// With both changed inside, Mesa brings back the lights alone.
TEST_P(AttributeStack, LightsAndMaterials) {
  const GLfloat red[] = {1, 0, 0, 1};
  const GLfloat green[] = {0, 1, 0, 1};
  gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, red);
  gl.Lightfv(GL_LIGHT2, GL_AMBIENT, red);
  gl.PushAttrib(GL_LIGHTING_BIT);
  gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, green);
  gl.Lightfv(GL_LIGHT2, GL_AMBIENT, green);
  gl.PopAttrib();
  std::array<GLfloat, 4> material{}, light{};
  gl.GetMaterialfv(GL_FRONT, GL_DIFFUSE, material.data());
  gl.GetLightfv(GL_LIGHT2, GL_AMBIENT, light.data());
  EXPECT_EQ(light, (std::array<GLfloat, 4>{1, 0, 0, 1}));
  if (!is_mesa()) {
    EXPECT_EQ(material, (std::array<GLfloat, 4>{1, 0, 0, 1}));
  }
}

/// What was tracked inside is gone after the pop; what is tracked after it follows the current
/// colour.
TEST_P(AttributeStack, TrackedMaterials) {
  gl.Color4f(0.25F, 0.5F, 0.75F, 1);
  gl.Enable(GL_COLOR_MATERIAL);
  gl.PushAttrib(GL_LIGHTING_BIT);
  gl.Disable(GL_COLOR_MATERIAL);
  gl.Color4f(1, 0.5F, 0, 1);
  gl.PopAttrib();
  std::array<GLfloat, 4> material{};
  gl.GetMaterialfv(GL_BACK, GL_DIFFUSE, material.data());
  EXPECT_EQ(gl.IsEnabled(GL_COLOR_MATERIAL), GL_TRUE);
  if (!is_mesa()) {
    EXPECT_EQ(material, (std::array<GLfloat, 4>{1, 0.5F, 0, 1}));
  }

  gl.Disable(GL_COLOR_MATERIAL);
  gl.PushAttrib(GL_LIGHTING_BIT);
  gl.Enable(GL_COLOR_MATERIAL);
  gl.Color4f(0, 0, 1, 1);
  gl.PopAttrib();
  gl.GetMaterialfv(GL_BACK, GL_DIFFUSE, material.data());
  if (!is_mesa()) {
    EXPECT_EQ(material, (std::array<GLfloat, 4>{1, 0.5F, 0, 1}));
  }
}

TEST_P(AttributeStack, DeletedBufferObjectsStayDeleted) {
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
  gl.PushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
  gl.DeleteBuffers(1, &buffer);
  gl.PopClientAttrib();
  // Mesa keeps the buffer for the stack's sake, and binds it again.
  EXPECT_EQ(gl.IsBuffer(buffer), is_mesa() ? GL_TRUE : GL_FALSE);
  if (!is_mesa()) {
    EXPECT_EQ(get(GL_ARRAY_BUFFER_BINDING), 0);
    EXPECT_EQ(get(GL_VERTEX_ARRAY_BUFFER_BINDING), 0);
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(AttributeStack, InDisplayLists) {
  gl.NewList(1, GL_COMPILE);
  gl.PushAttrib(GL_LINE_BIT);
  gl.LineWidth(4);
  gl.EndList();
  gl.NewList(2, GL_COMPILE);
  gl.PopAttrib();
  gl.EndList();
  EXPECT_EQ(get(GL_ATTRIB_STACK_DEPTH), 0);
  gl.CallList(1);
  EXPECT_EQ(get(GL_ATTRIB_STACK_DEPTH), 1);
  EXPECT_EQ(get(GL_LINE_WIDTH), 4);
  gl.CallList(2);
  EXPECT_EQ(get(GL_LINE_WIDTH), 1);
}

void draw_triangle(const GlFunctions& gl) {
  gl.Begin(GL_TRIANGLES);
  gl.Vertex2f(-1, -1);
  gl.Vertex2f(1, -1);
  gl.Vertex2f(0, 1);
  gl.End();
}

/// Popping what did not change neither ends the batch nor uploads anything.
TEST_P(AttributeStack, NothingChangedCostsNothing) {
  if (is_mesa()) GTEST_SKIP() << "counters of this library";
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  const auto frame = [&] {
    for (int i = 0; i < 10; ++i) {
      gl.PushAttrib(GL_ALL_ATTRIB_BITS);
      draw_triangle(gl);
      gl.PopAttrib();
    }
    gl.Finish();
  };
  frame();
  legacy_gl_reset_statistics();
  frame();
  legacy_gl_statistics statistics{};
  legacy_gl_get_statistics(&statistics);
  EXPECT_EQ(statistics.batches, 1U);
  EXPECT_EQ(statistics.begin_end_merged, 9U);
  EXPECT_EQ(statistics.uniform_block_updates, 0U);
  EXPECT_EQ(statistics.programs_compiled, 0U);
}

TEST_P(AttributeStack, DrawsWhatWasRecordedBeforeThePop) {
  gl.ClearColor(0, 0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.PushAttrib(GL_COLOR_BUFFER_BIT);
  gl.ColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl.Rectf(-1, -1, 1, 1);
  gl.PopAttrib();
  std::array<GLubyte, 4> pixel{};
  gl.ReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  EXPECT_EQ(pixel, (std::array<GLubyte, 4>{255, 0, 0, 255}));
}

/// Draws the whole window without texture coordinates, in the `way`-th of the ways that take the
/// current ones.
void draw_window(const GlFunctions& gl, int way) {
  static constexpr GLfloat kCorners[] = {-1, -1, 3, -1, -1, 3};
  static constexpr GLubyte kElements[] = {0, 1, 2};
  const auto by_begin_end = [&gl] {
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) gl.Vertex2fv(kCorners + 2 * i);
    gl.End();
  };
  if (way == 0) return by_begin_end();
  if (way == 1) {
    gl.NewList(1, GL_COMPILE);
    by_begin_end();
    gl.EndList();
    return gl.CallList(1);
  }
  GLuint buffer = 0;
  if (way == 4) {
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, sizeof kCorners, kCorners, GL_STATIC_DRAW);
  }
  gl.VertexPointer(2, GL_FLOAT, 0, buffer ? nullptr : kCorners);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  if (way == 3) gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, kElements);
  else gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.DisableClientState(GL_VERTEX_ARRAY);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
  if (buffer) gl.DeleteBuffers(1, &buffer);
}

/// Vertices that were recorded in between have s and t alone, and wait.
TEST_P(AttributeStack, BringsBackAllOfTextureCoordinates) {
  std::array<GLubyte, 16> texels{};
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<GLubyte>(16 * i + 8);
  for (const GLenum unit : {GLenum{GL_TEXTURE0}, GLenum{GL_TEXTURE3}})
    for (int way = 0; way < 5; ++way) {
      context->recreate();
      gl.ActiveTexture(unit);
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      gl.TexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 4, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE,
                    texels.data());
      gl.Enable(GL_TEXTURE_2D);
      gl.MultiTexCoord4f(unit, 1.25F, 0.75F, 0, 2);  // the texel (2, 1)
      gl.PushAttrib(GL_CURRENT_BIT);
      gl.MultiTexCoord2f(unit, 0, 0);
      draw_triangle(gl);
      gl.PopAttrib();
      draw_window(gl, way);
      std::array<GLubyte, 4> pixel{};
      gl.ReadPixels(8, 8, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
      EXPECT_EQ(pixel[0], 16 * 6 + 8) << "unit " << unit - GL_TEXTURE0 << ", way " << way;
    }
}

}  // namespace

}  // namespace legacy_gl::test
