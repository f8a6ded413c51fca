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

TEST(Unbuilt, SaysSoOnceByNameAndIsAnInvalidOperation) {
  std::vector<std::string> diagnostics;
  legacy_gl_options options{};
  options.diagnostic_user = &diagnostics;
  options.diagnostic = [](const char* message, void* user) {
    static_cast<std::vector<std::string>*>(user)->emplace_back(message);
  };
  CoreContext context(4, 4, PixelFormat::rgba8, options);
  for (const UnbuiltCall& unbuilt : unbuilt_calls()) {
    diagnostics.clear();
    for (int i = 0; i < 2; ++i) {
      unbuilt.call(context.gl);
      EXPECT_EQ(context.gl.GetError(), GLenum{GL_INVALID_OPERATION}) << unbuilt.entry_point;
    }
    EXPECT_EQ(diagnostics, std::vector{unbuilt.entry_point + std::string(" is not built yet")});
  }
}

// Both ways to an entry point: no name is missing from the table.
TEST(Unbuilt, EveryEntryPointHasAnAddress) {
  for (const UnbuiltCall& unbuilt : unbuilt_calls())
    EXPECT_NE(legacy_gl_get_proc_address(unbuilt.entry_point), nullptr) << unbuilt.entry_point;
  for (const ErrorCase& error : error_cases())
    EXPECT_NE(legacy_gl_get_proc_address(error.entry_point), nullptr) << error.entry_point;
  EXPECT_EQ(legacy_gl_get_proc_address("glUseProgram"), nullptr);
}

}  // namespace legacy_gl::test
