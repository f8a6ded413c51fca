// glPolygonStipple, glGetPolygonStipple and the pixel store (GL 2.1 spec 3.5.2, 6.1.5), beside
// Mesa's. tests/conformance/polygon_stipple.cpp has the pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

using Bytes = std::array<GLubyte, 1024>;

Bytes counted(unsigned step) {
  Bytes bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<GLubyte>(i * step + i / 16 * 5);
  return bytes;
}

class PolygonStipple : public testing::Test {
 protected:
  /// What the calls leave in memory on Mesa and here.
  void compare(void (*calls)(const GlFunctions&, Bytes&)) {
    const auto run = [&](RenderContext& context) {
      context.recreate();
      Bytes bytes;
      bytes.fill(0x5a);
      calls(context.gl, bytes);
      EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
      return bytes;
    };
    const Bytes mesa = run(mesa_), ours = run(ours_);
    EXPECT_EQ(ours, mesa);
    EXPECT_TRUE(std::any_of(ours.begin(), ours.end(), [](GLubyte b) { return b != 0x5a; }));
  }

  MesaContext mesa_{4, 4};
  CoreContext ours_{4, 4};
};

TEST_F(PolygonStipple, InitialState) {
  compare([](const GlFunctions& gl, Bytes& bytes) { gl.GetPolygonStipple(bytes.data()); });
  std::array<GLubyte, 128> mask{};
  ours_.gl.GetPolygonStipple(mask.data());
  EXPECT_TRUE(std::all_of(mask.begin(), mask.end(), [](GLubyte b) { return b == 0xff; }));
  EXPECT_FALSE(ours_.gl.IsEnabled(GL_POLYGON_STIPPLE));
}

TEST_F(PolygonStipple, SetAndGet) {
  compare([](const GlFunctions& gl, Bytes& bytes) {
    gl.PolygonStipple(counted(37).data());
    gl.GetPolygonStipple(bytes.data());
  });
}

TEST_F(PolygonStipple, PassesThePixelStoreOnItsWayIn) {
  compare([](const GlFunctions& gl, Bytes& bytes) {
    gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 75);
    gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 16);  // whole bytes: M24
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 3);
    gl.PixelStorei(GL_UNPACK_LSB_FIRST, 1);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 8);
    gl.PolygonStipple(counted(37).data());
    gl.GetPolygonStipple(bytes.data());
  });
}

// Mesa writes past the end of its pattern then (M24): the bits themselves are the judge.
TEST_F(PolygonStipple, BeginsBetweenBytes) {
  const GlFunctions& gl = ours_.gl;
  const Bytes mask = counted(37);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 64);
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 5);
  gl.PolygonStipple(mask.data());
  std::array<GLubyte, 128> got{};
  gl.GetPolygonStipple(got.data());
  const auto bit = [](const GLubyte* bytes, std::size_t i) {
    return bytes[i / 8] >> (7 - i % 8) & 1;
  };
  for (std::size_t y = 0; y < 32; ++y)
    for (std::size_t x = 0; x < 32; ++x)
      EXPECT_EQ(bit(got.data(), 32 * y + x), bit(mask.data(), 64 * y + x + 5)) << x << ", " << y;
}

TEST_F(PolygonStipple, PassesThePixelStoreOnItsWayOut) {
  compare([](const GlFunctions& gl, Bytes& bytes) {
    gl.PolygonStipple(counted(91).data());
    gl.PixelStorei(GL_PACK_ROW_LENGTH, 50);
    gl.PixelStorei(GL_PACK_SKIP_PIXELS, 8);
    gl.PixelStorei(GL_PACK_SKIP_ROWS, 2);
    gl.PixelStorei(GL_PACK_LSB_FIRST, 1);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 2);
    gl.GetPolygonStipple(bytes.data());
  });
}

// A list takes the pattern as memory and pixel store are when it is compiled.
TEST_F(PolygonStipple, IsRecordedInLists) {
  compare([](const GlFunctions& gl, Bytes& bytes) {
    Bytes mask = counted(37);
    gl.PixelStorei(GL_UNPACK_LSB_FIRST, 1);
    gl.NewList(1, GL_COMPILE);
    gl.PolygonStipple(mask.data());
    gl.EndList();
    gl.PixelStorei(GL_UNPACK_LSB_FIRST, 0);
    gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 1);
    mask.fill(0);
    gl.GetPolygonStipple(bytes.data() + 512);
    gl.CallList(1);
    gl.GetPolygonStipple(bytes.data());
  });
}

TEST_F(PolygonStipple, HasAnAttributeGroupOfItsOwn) {
  compare([](const GlFunctions& gl, Bytes& bytes) {
    gl.PolygonStipple(counted(37).data());
    gl.PushAttrib(GL_POLYGON_STIPPLE_BIT);
    gl.PolygonStipple(counted(3).data());
    gl.PushAttrib(GL_POLYGON_BIT);
    gl.PolygonStipple(counted(7).data());
    gl.PopAttrib();
    gl.GetPolygonStipple(bytes.data());
    gl.PopAttrib();
    gl.GetPolygonStipple(bytes.data() + 512);
  });
}

TEST_F(PolygonStipple, Errors) {
  const GlFunctions& gl = ours_.gl;
  std::array<GLubyte, 128> before{}, after{};
  gl.GetPolygonStipple(before.data());
  gl.Begin(GL_POINTS);
  gl.PolygonStipple(counted(3).data());
  gl.End();
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
  gl.GetPolygonStipple(after.data());
  EXPECT_EQ(after, before);
  gl.PolygonStipple(nullptr);
  gl.GetPolygonStipple(nullptr);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
}

}  // namespace

}  // namespace legacy_gl::test
