// Numbers of objects as no sane program has them, and contexts without end.
#include <gtest/gtest.h>
#include <malloc.h>
#include <legacy_gl/context.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "every_area.hpp"
#include "support/contexts.hpp"
#include "support/osmesa_context.hpp"

namespace legacy_gl::test {
namespace {

constexpr int kSize = 16;

GLubyte green(RenderContext& context) { return context.read_rgba8().bytes[1]; }

void compile_square(const GlFunctions& gl, GLuint list, float shade) {
  gl.NewList(list, GL_COMPILE);
  gl.Color3f(0, shade, 0);
  gl.Rectf(-1, -1, 1, 1);
  gl.EndList();
}

TEST(ManyObjects, AMillionLists) {
  constexpr GLuint kCount = 1'000'000;
  CoreContext context(kSize, kSize);
  const GlFunctions& gl = context.gl;
  GLuint first = 0, last = 0;
  for (GLuint i = 0; i < kCount; ++i) {
    last = gl.GenLists(1);
    ASSERT_GT(last, i);
    if (i == 0) first = last;
  }
  compile_square(gl, first, 0.2F);
  compile_square(gl, last, 1);
  gl.CallList(first);
  EXPECT_EQ(green(context), 51);
  gl.CallList(last);
  EXPECT_EQ(green(context), 255);
  gl.DeleteLists(first, static_cast<GLsizei>(last - first + 1));
  EXPECT_EQ(gl.IsList(last), GL_FALSE);
  EXPECT_EQ(gl.GenLists(2), first);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST(ManyObjects, AHundredThousandTextures) {
  constexpr GLsizei kCount = 100'000;
  CoreContext context(kSize, kSize);
  const GlFunctions& gl = context.gl;
  std::vector<GLuint> names(kCount);
  // One by one, as programs do that make a texture for each glyph.
  for (GLuint& name : names) gl.GenTextures(1, &name);
  EXPECT_EQ(std::set<GLuint>(names.begin(), names.end()).size(), names.size());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const auto shade = [](GLsizei i) { return static_cast<GLubyte>(i * 7 % 251); };
  for (GLsizei i = 0; i < kCount; ++i) {
    gl.BindTexture(GL_TEXTURE_2D, names[static_cast<std::size_t>(i)]);
    if (i % 1000 && i + 1 < kCount) continue;
    const GLubyte texel[3] = {0, shade(i), 0};
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, texel);
  }
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Enable(GL_TEXTURE_2D);
  for (const GLsizei i : {0, kCount / 2, kCount - 1}) {
    gl.BindTexture(GL_TEXTURE_2D, names[static_cast<std::size_t>(i)]);
    gl.Rectf(-1, -1, 1, 1);
    EXPECT_EQ(green(context), shade(i)) << i;
  }
  gl.DeleteTextures(kCount, names.data());
  GLuint again = 0;
  gl.GenTextures(1, &again);
  EXPECT_EQ(again, names[0]);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

// Each list adds a little green and calls the next; GL_MAX_LIST_NESTING of them do.
TEST(ManyObjects, ListsNestedBeyondTheLimit) {
  const auto nested = [](RenderContext& context) {
    context.make_current();
    const GlFunctions& gl = context.gl;
    for (GLuint list = 1; list <= 200; ++list) {
      gl.NewList(list, GL_COMPILE);
      gl.Rectf(-1, -1, 1, 1);
      gl.CallList(list == 200 ? 1 : list + 1);
      gl.EndList();
    }
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_ONE, GL_ONE);
    gl.Color3ub(0, 1, 0);
    gl.CallList(1);
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
    return green(context);
  };
  CoreContext ours(kSize, kSize);
  MesaContext mesa(kSize, kSize);
  EXPECT_EQ(nested(ours), 64);
  EXPECT_EQ(nested(mesa), 64);
}

std::size_t bytes_in_use() { return mallinfo2().uordblks; }

// All that a context takes is given back, in the driver too. 10,000 of them where
// LEGACY_GL_TEST_CONTEXTS says so. In one context of the driver's: Mesa's own leave some 200 bytes.
TEST(ManyObjects, ContextsWithoutEnd) {
  const char* const asked = std::getenv("LEGACY_GL_TEST_CONTEXTS");
  const int count = asked ? std::atoi(asked) : 500;
  OsmesaContext driver(kEveryAreaSize, kEveryAreaSize, PixelFormat::rgba8, Profile::core);
  driver.bind();
  const GlFunctions gl = load_gl_functions(legacy_gl_get_proc_address);
  const auto one = [&gl](bool draws) {
    OwnedContext context(OSMesaGetProcAddress, LEGACY_GL_OPTIONS_INIT);
    context.make_current();
    if (draws) draw_every_area(gl);
    else gl.Finish();
  };
  const auto many = [&] {
    for (int i = 0; i < count; ++i) one(i % 100 == 0);
  };
  const auto finish_driver = reinterpret_cast<void (*)()>(OSMesaGetProcAddress("glFinish"));
  const auto bytes_after_many = [&] {
    many();
    finish_driver();
    return static_cast<std::int64_t>(bytes_in_use());
  };
  // What is lost is lost in every round; the driver's own tables and its threads' work come and go.
  std::int64_t before = bytes_after_many();
  std::int64_t least_growth = std::numeric_limits<std::int64_t>::max();
  for (int round = 0; round < 4; ++round) {
    const std::int64_t after = bytes_after_many();
    least_growth = std::min(least_growth, after - before);
    before = after;
  }
  // Ten bytes a context: less than one pointer that each would leave, with what malloc itself
  // keeps.
  EXPECT_LT(least_growth, 10 * std::int64_t{count});
  OsmesaContext::release();
}

}  // namespace
}  // namespace legacy_gl::test
