// GL 2.1 spec 2.5, beyond single calls; and entry points that are declared and not built.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "gl/error_cases.hpp"
#include "gl/state_snapshot.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {

TEST(Errors, TheFirstSticks) {
  CoreContext context(4, 4);
  const GlFunctions& gl = context.gl;
  gl.Enable(0xFFFF);
  gl.LineWidth(-1);
  gl.PopMatrix();
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_ENUM});
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  gl.LineWidth(-1);
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_VALUE});
}

// GL 2.1 spec 2.6.3: glGetError between glBegin and glEnd is itself an error, and answers 0.
TEST(Errors, OfGetErrorInsideBeginEnd) {
  CoreContext context(4, 4);
  const GlFunctions& gl = context.gl;
  gl.Begin(GL_POINTS);
  EXPECT_EQ(gl.GetError(), GLenum{0});
  gl.End();
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST(Errors, OfACompiledAndExecutedListComeTwice) {
  CoreContext context(4, 4);
  const GlFunctions& gl = context.gl;
  gl.NewList(1, GL_COMPILE_AND_EXECUTE);
  gl.LineWidth(-1);
  gl.EndList();
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_VALUE});
  gl.CallList(1);
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_VALUE});
}

// The tests of errors compare snapshots: a name that one does not know would be a hole.
TEST(Snapshot, KnowsEveryName) {
  EXPECT_EQ(unknown_names(take_snapshot(CoreContext(4, 4).gl)), "");
  EXPECT_EQ(unknown_names(take_snapshot(MesaContext(4, 4).gl)), "");
}

TEST(Snapshot, SeesAChange) {
  CoreContext context(4, 4);
  const StateSnapshot before = take_snapshot(context.gl);
  EXPECT_EQ(difference(before, take_snapshot(context.gl)), "");
  context.gl.Lightf(GL_LIGHT3, GL_SPOT_CUTOFF, 45);
  context.gl.Enable(GL_LIGHT2);
  EXPECT_EQ(difference(before, take_snapshot(context.gl)),
            "GL_LIGHT2: [0] 0 became 1\n"
            "GL_LIGHT3 GL_SPOT_CUTOFF: [0] 180 became 45\n");
}

namespace {

using Diagnostics = std::vector<std::string>;

legacy_gl_options options_with(Diagnostics& diagnostics) {
  legacy_gl_options options{};
  options.diagnostic_user = &diagnostics;
  options.diagnostic = [](const char* message, void* user) {
    static_cast<Diagnostics*>(user)->emplace_back(message);
  };
  return options;
}

}  // namespace

// Of OpenGL 1.5, among them those that the core profile has not.
TEST(EntryPoints, EveryCapabilityIsEnabledWithoutAWord) {
  constexpr GLenum kCapabilities[] = {GL_ALPHA_TEST,     GL_FOG,
                                      GL_TEXTURE_1D,     GL_TEXTURE_2D,
                                      GL_TEXTURE_3D,     GL_TEXTURE_CUBE_MAP,
                                      GL_TEXTURE_GEN_S,  GL_TEXTURE_GEN_T,
                                      GL_TEXTURE_GEN_R,  GL_TEXTURE_GEN_Q,
                                      GL_LINE_STIPPLE,   GL_POLYGON_STIPPLE,
                                      GL_POINT_SMOOTH,   GL_LINE_SMOOTH,
                                      GL_POLYGON_SMOOTH, GL_AUTO_NORMAL,
                                      GL_CLIP_PLANE0,    GL_CLIP_PLANE5,
                                      GL_MAP1_VERTEX_3,  GL_MAP2_NORMAL,
                                      GL_LIGHTING,       GL_COLOR_LOGIC_OP,
                                      GL_INDEX_LOGIC_OP, GL_SAMPLE_COVERAGE};
  Diagnostics diagnostics;
  CoreContext context(4, 4, PixelFormat::rgba8, options_with(diagnostics));
  const GlFunctions& gl = context.gl;
  for (const GLenum capability : kCapabilities) {
    diagnostics.clear();
    gl.Enable(capability);
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR}) << capability;
    EXPECT_TRUE(gl.IsEnabled(capability)) << capability;
    EXPECT_TRUE(diagnostics.empty()) << capability;
    gl.Disable(capability);
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR}) << capability;
    EXPECT_FALSE(gl.IsEnabled(capability)) << capability;
  }
}

// Both ways to an entry point: no name is missing from the table.
TEST(EntryPoints, EachHasAnAddress) {
  for (const ErrorCase& error : error_cases())
    EXPECT_NE(legacy_gl_get_proc_address(error.entry_point), nullptr) << error.entry_point;
  EXPECT_EQ(legacy_gl_get_proc_address("glUseProgram"), nullptr);
}

}  // namespace legacy_gl::test
