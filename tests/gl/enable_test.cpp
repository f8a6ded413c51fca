// glEnable, glDisable, glIsEnabled and glHint, glPixelStore: what each takes, and what it refuses.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

enum class Dialect { core, gles };

struct Diagnostics {
  std::vector<std::string> messages;
  static void take(const char* message, void* user) {
    static_cast<Diagnostics*>(user)->messages.emplace_back(message);
  }
};

std::unique_ptr<RenderContext> make_context(Dialect dialect, Diagnostics& diagnostics) {
  legacy_gl_options options{};
  options.diagnostic = Diagnostics::take;
  options.diagnostic_user = &diagnostics;
  if (dialect == Dialect::core)
    return std::make_unique<CoreContext>(8, 8, PixelFormat::rgba8, options);
  return std::make_unique<GlesContext>(8, 8, PixelFormat::rgba8, options);
}

constexpr GLenum kCapabilities[] = {GL_BLEND,
                                    GL_COLOR_LOGIC_OP,
                                    GL_COLOR_MATERIAL,
                                    GL_COLOR_SUM,
                                    GL_CULL_FACE,
                                    GL_DEPTH_TEST,
                                    GL_DITHER,
                                    GL_INDEX_LOGIC_OP,
                                    GL_LIGHTING,
                                    GL_LIGHT0,
                                    GL_LIGHT7,
                                    GL_LINE_SMOOTH,
                                    GL_LINE_STIPPLE,
                                    GL_MULTISAMPLE,
                                    GL_NORMALIZE,
                                    GL_POINT_SMOOTH,
                                    GL_POLYGON_OFFSET_FILL,
                                    GL_POLYGON_SMOOTH,
                                    GL_POLYGON_OFFSET_LINE,
                                    GL_POLYGON_OFFSET_POINT,
                                    GL_POLYGON_STIPPLE,
                                    GL_RESCALE_NORMAL,
                                    GL_SAMPLE_ALPHA_TO_ONE,
                                    GL_SAMPLE_ALPHA_TO_COVERAGE,
                                    GL_SAMPLE_COVERAGE,
                                    GL_SCISSOR_TEST,
                                    GL_STENCIL_TEST,
                                    GL_TEXTURE_1D,
                                    GL_TEXTURE_2D,
                                    GL_TEXTURE_3D,
                                    GL_TEXTURE_CUBE_MAP,
                                    GL_TEXTURE_GEN_S,
                                    GL_TEXTURE_GEN_T,
                                    GL_TEXTURE_GEN_R,
                                    GL_TEXTURE_GEN_Q};

class Enable : public testing::TestWithParam<Dialect> {
 protected:
  Diagnostics diagnostics;
  std::unique_ptr<RenderContext> context = make_context(GetParam(), diagnostics);
  const GlFunctions& gl = context->gl;
};

INSTANTIATE_TEST_SUITE_P(Dialects, Enable, testing::Values(Dialect::core, Dialect::gles),
                         [](const auto& parameter) {
                           return parameter.param == Dialect::core ? "core" : "gles";
                         });

TEST_P(Enable, InitialState) {
  for (const GLenum capability : kCapabilities) {
    const bool initially = capability == GL_DITHER || capability == GL_MULTISAMPLE;
    EXPECT_EQ(gl.IsEnabled(capability), initially ? GL_TRUE : GL_FALSE) << std::hex << capability;
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

/// Each alone: none moves another.
TEST_P(Enable, SetAndGet) {
  const auto all = [&] {
    std::vector<GLboolean> enabled;
    for (const GLenum capability : kCapabilities) enabled.push_back(gl.IsEnabled(capability));
    return enabled;
  };
  for (std::size_t i = 0; i < std::size(kCapabilities); ++i) {
    std::vector<GLboolean> expected = all();
    for (const bool enable : {true, false, true}) {
      if (enable) gl.Enable(kCapabilities[i]);
      else gl.Disable(kCapabilities[i]);
      expected[i] = enable;
      EXPECT_EQ(all(), expected);
    }
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(Enable, Errors) {
  constexpr GLenum kNames[] = {GL_LIGHT0 + 8, GL_TRIANGLES, GL_AMBIENT, GL_CLIP_PLANE0 + 6};
  for (const GLenum name : kNames) {
    gl.Enable(name);
    EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_ENUM});
    gl.Disable(name);
    EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(gl.IsEnabled(name), GL_FALSE);
    EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_ENUM});
  }
  gl.Begin(GL_POINTS);
  gl.Enable(GL_LIGHTING);
  gl.End();
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
  EXPECT_EQ(gl.IsEnabled(GL_LIGHTING), GL_FALSE);
}

// EXT_vertex_array enabled arrays by glEnable, and programs of its time still do.
TEST(EnableArrays, AreClientStateAsInMesa) {
  MesaContext mesa(8, 8);
  CoreContext ours(8, 8);
  for (RenderContext* const context :
       {static_cast<RenderContext*>(&mesa), static_cast<RenderContext*>(&ours)}) {
    context->make_current();
    const GlFunctions& gl = context->gl;
    for (const GLenum array : std::initializer_list<GLenum>{
             GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY,
             GL_EDGE_FLAG_ARRAY, GL_FOG_COORD_ARRAY, GL_SECONDARY_COLOR_ARRAY}) {
      gl.Enable(array);
      EXPECT_TRUE(gl.IsEnabled(array)) << array;
      gl.DisableClientState(array);
      EXPECT_FALSE(gl.IsEnabled(array)) << array;
      gl.EnableClientState(array);
      gl.Disable(array);
      EXPECT_FALSE(gl.IsEnabled(array)) << array;
    }
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  }
}

/// Kept, asked for and without effect there: that is said once.
TEST_P(Enable, WhatOpenGlEsLacksIsSaidOnce) {
  constexpr GLenum kMissing[] = {GL_LINE_SMOOTH, GL_POLYGON_SMOOTH, GL_COLOR_LOGIC_OP,
                                 GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT};
  for (const GLenum capability : kMissing) {
    SCOPED_TRACE(testing::Message() << std::hex << "0x" << capability);
    diagnostics.messages.clear();
    gl.Enable(capability);
    gl.Disable(capability);
    EXPECT_TRUE(diagnostics.messages.empty() || GetParam() == Dialect::gles);
    gl.Enable(capability);
    EXPECT_EQ(diagnostics.messages.size(), GetParam() == Dialect::gles ? 1U : 0U);
    EXPECT_EQ(gl.IsEnabled(capability), GL_TRUE);
  }
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST_P(Enable, StringsAreOurs) {
  const auto text = [&](GLenum name) {
    const GLubyte* const value = gl.GetString(name);
    return std::string(value ? reinterpret_cast<const char*>(value) : "(null)");
  };
  EXPECT_EQ(text(GL_VENDOR), "legacy_gl");
  EXPECT_EQ(text(GL_RENDERER).rfind("legacy_gl on ", 0), 0U) << text(GL_RENDERER);
  EXPECT_EQ(text(GL_VERSION).rfind("1.5 ", 0), 0U) << text(GL_VERSION);
  // What extends lighting is built; programs of their own are not.
  const std::string extensions = ' ' + text(GL_EXTENSIONS) + ' ';
  EXPECT_NE(extensions.find(" GL_EXT_separate_specular_color "), std::string::npos) << extensions;
  EXPECT_NE(extensions.find(" GL_WIN_phong_shading "), std::string::npos) << extensions;
  EXPECT_EQ(extensions.find("GL_ARB_vertex_program"), std::string::npos) << extensions;
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  EXPECT_EQ(gl.GetString(GL_LIGHTING), nullptr);
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_ENUM});
}

}  // namespace

}  // namespace legacy_gl::test
