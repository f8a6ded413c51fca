// glReadPixels: every format with every type under several pack modes, byte by byte as Mesa's fixed
// function.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

constexpr int kWidth = 16;
constexpr int kHeight = 12;

enum class Dialect { core, gles };

std::unique_ptr<RenderContext> make_context(Dialect dialect) {
  if (dialect == Dialect::core) return std::make_unique<CoreContext>(kWidth, kHeight);
  return std::make_unique<GlesContext>(kWidth, kHeight);
}

/// Every pixel of its own colour, without a primitive; depth and stencil in bands.
void fill(const GlFunctions& gl) {
  gl.Enable(GL_SCISSOR_TEST);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      gl.Scissor(x, y, 1, 1);
      gl.ClearColor(static_cast<float>(x) / 15.0F, static_cast<float>(y) / 11.0F,
                    static_cast<float>(x * y % 7) / 6.0F, static_cast<float>(x + y) / 26.0F);
      gl.ClearDepth(static_cast<double>(x) / 15.0);
      gl.ClearStencil(16 * y + x);
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }
  }
  gl.Disable(GL_SCISSOR_TEST);
}

constexpr GLenum kColorFormats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA,     GL_RGB,
                                    GL_BGR, GL_RGBA,  GL_BGRA, GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                                    0x8227 /* GL_RG */};
constexpr GLenum kDepthFormats[] = {GL_DEPTH_COMPONENT, GL_STENCIL_INDEX};
constexpr GLenum kTypes[] = {GL_BYTE,
                             GL_UNSIGNED_BYTE,
                             GL_SHORT,
                             GL_UNSIGNED_SHORT,
                             GL_INT,
                             GL_UNSIGNED_INT,
                             GL_FLOAT,
                             GL_UNSIGNED_BYTE_3_3_2,
                             GL_UNSIGNED_BYTE_2_3_3_REV,
                             GL_UNSIGNED_SHORT_5_6_5,
                             GL_UNSIGNED_SHORT_5_6_5_REV,
                             GL_UNSIGNED_SHORT_4_4_4_4,
                             GL_UNSIGNED_SHORT_4_4_4_4_REV,
                             GL_UNSIGNED_SHORT_5_5_5_1,
                             GL_UNSIGNED_SHORT_1_5_5_5_REV,
                             GL_UNSIGNED_INT_8_8_8_8,
                             GL_UNSIGNED_INT_8_8_8_8_REV,
                             GL_UNSIGNED_INT_10_10_10_2,
                             GL_UNSIGNED_INT_2_10_10_10_REV};

using PackModes = void (*)(const GlFunctions& gl);

struct NamedModes {
  const char* name;
  PackModes set;
};

constexpr NamedModes kPackModes[] = {
    {"initial", [](const GlFunctions&) {}},
    {"packed", [](const GlFunctions& gl) { gl.PixelStorei(GL_PACK_ALIGNMENT, 1); }},
    {"aligned_to_8", [](const GlFunctions& gl) { gl.PixelStorei(GL_PACK_ALIGNMENT, 8); }},
    {"swapped", [](const GlFunctions& gl) { gl.PixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE); }},
    {"into_an_image",
     [](const GlFunctions& gl) {
       gl.PixelStorei(GL_PACK_ALIGNMENT, 2);
       gl.PixelStorei(GL_PACK_ROW_LENGTH, 11);
       gl.PixelStorei(GL_PACK_SKIP_ROWS, 2);
       gl.PixelStorei(GL_PACK_SKIP_PIXELS, 3);
     }},
};

/// Bytes that are not written stay 0x5A.
std::vector<GLubyte> read(const GlFunctions& gl, GLenum format, GLenum type) {
  std::vector<GLubyte> bytes(4096, 0x5A);
  gl.ReadPixels(3, 2, 7, 8, format, type, bytes.data());
  return bytes;
}

std::uint32_t word_at(const std::vector<GLubyte>& bytes, std::size_t at, bool swapped) {
  std::array<GLubyte, 4> word{bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]};
  if (swapped) std::reverse(word.begin(), word.end());
  return std::bit_cast<std::uint32_t>(word);
}

double distance(std::uint32_t a, std::uint32_t b, unsigned shift, unsigned bits) {
  const std::uint32_t mask = bits == 32 ? ~0U : (1U << bits) - 1;
  return std::abs(static_cast<double>(a >> shift & mask) - static_cast<double>(b >> shift & mask));
}

/// How many units two words differ by: components of 32 bits pass through floats of 24, and Mesa
/// repeats the bits of an 8-bit component to make 10 of them, where we round.
bool words_agree(std::uint32_t a, std::uint32_t b, GLenum type) {
  if (a == b) return true;
  constexpr double kFloatUlps = 1 << 9;
  switch (type) {
    case GL_FLOAT:  // sums of three, up to 3: two ulps there
      return std::abs(std::bit_cast<float>(a) - std::bit_cast<float>(b)) <= 0x1p-21F;
    case GL_INT:
    case GL_UNSIGNED_INT: return distance(a, b, 0, 32) <= kFloatUlps;
    case GL_UNSIGNED_INT_10_10_10_2:
      return distance(a, b, 22, 10) <= 1 && distance(a, b, 12, 10) <= 1 &&
             distance(a, b, 2, 10) <= 1 && distance(a, b, 0, 2) == 0;
    case GL_UNSIGNED_INT_2_10_10_10_REV:
      return distance(a, b, 0, 10) <= 1 && distance(a, b, 10, 10) <= 1 &&
             distance(a, b, 20, 10) <= 1 && distance(a, b, 30, 2) == 0;
    default: return false;
  }
}

testing::AssertionResult agree(const std::vector<GLubyte>& bytes,
                               const std::vector<GLubyte>& expected, GLenum type, bool swapped) {
  for (std::size_t at = 0; at < bytes.size(); at += 4) {
    const std::uint32_t a = word_at(bytes, at, swapped), b = word_at(expected, at, swapped);
    if (!words_agree(a, b, type))
      return testing::AssertionFailure()
             << "byte " << at << std::hex << ": 0x" << a << ", Mesa 0x" << b;
  }
  return testing::AssertionSuccess();
}

/// LuminanceAboveOneIsTheLargestInteger has it.
bool overflows_in_mesa(GLenum format, GLenum type) {
  return type == GL_UNSIGNED_INT && (format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA);
}

class ReadPixels : public testing::TestWithParam<Dialect> {
 protected:
  void compare(const std::span<const GLenum> formats) {
    for (const NamedModes& modes : kPackModes) {
      for (const GLenum format : formats) {
        for (const GLenum type : kTypes) {
          if (overflows_in_mesa(format, type)) continue;
          SCOPED_TRACE(testing::Message()
                       << modes.name << std::hex << " format 0x" << format << " type 0x" << type);
          mesa_->make_current();
          mesa_->gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
          modes.set(mesa_->gl);
          const std::vector<GLubyte> expected = read(mesa_->gl, format, type);
          mesa_->gl.PopClientAttrib();
          const GLenum expected_error = mesa_->gl.GetError();
          ours_->make_current();
          ours_->gl.PushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
          modes.set(ours_->gl);
          const std::vector<GLubyte> bytes = read(ours_->gl, format, type);
          ours_->gl.PopClientAttrib();
          ASSERT_EQ(ours_->gl.GetError(), expected_error);
          EXPECT_TRUE(agree(bytes, expected, type, std::string(modes.name) == "swapped"));
        }
      }
    }
  }

  void SetUp() override {
    mesa_ = std::make_unique<MesaContext>(kWidth, kHeight);
    fill(mesa_->gl);
    ours_ = make_context(GetParam());
    fill(ours_->gl);
  }

  std::unique_ptr<MesaContext> mesa_;
  std::unique_ptr<RenderContext> ours_;
};

INSTANTIATE_TEST_SUITE_P(Dialects, ReadPixels, testing::Values(Dialect::core, Dialect::gles),
                         [](const auto& parameter) {
                           return parameter.param == Dialect::core ? "core" : "gles";
                         });

TEST_P(ReadPixels, Colors) { compare(kColorFormats); }

TEST_P(ReadPixels, DepthAndStencil) {
  if (GetParam() == Dialect::core) return compare(kDepthFormats);
  // OpenGL ES reads neither: an error that names it, and nothing written.
  for (const GLenum format : kDepthFormats) {
    EXPECT_EQ(read(ours_->gl, format, GL_UNSIGNED_BYTE), std::vector<GLubyte>(4096, 0x5A));
    EXPECT_EQ(ours_->gl.GetError(), GLenum{GL_INVALID_OPERATION});
  }
}

/// Red, green and blue are added, and the sum clamped (GL 2.1 spec 4.3.2).
TEST_P(ReadPixels, LuminanceAboveOneIsTheLargestInteger) {
  const auto read_one = [](const GlFunctions& gl) {
    gl.ClearColor(1, 0.5F, 0.25F, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    GLuint luminance = 77;
    gl.ReadPixels(5, 5, 1, 1, GL_LUMINANCE, GL_UNSIGNED_INT, &luminance);
    return luminance;
  };
  mesa_->make_current();
  EXPECT_EQ(read_one(mesa_->gl), 0U) << "Mesa's conversion overflows";
  ours_->make_current();
  EXPECT_EQ(read_one(ours_->gl), 0xFFFFFFFFU);
}

TEST_P(ReadPixels, SeesWhatIsRecorded) {
  ours_->gl.Color3f(0, 1, 0);
  ours_->gl.Rectf(-1, -1, 1, 1);
  std::array<GLubyte, 4> pixel{};
  ours_->gl.ReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  EXPECT_EQ(pixel, (std::array<GLubyte, 4>{0, 255, 0, 255}));
}

TEST_P(ReadPixels, Errors) {
  const struct {
    GLsizei width;
    GLenum format, type, error;
  } cases[] = {
      {-1, GL_RGBA, GL_UNSIGNED_BYTE, GL_INVALID_VALUE},
      {1, GL_POINTS, GL_UNSIGNED_BYTE, GL_INVALID_ENUM},
      {1, GL_RGBA, GL_DOUBLE, GL_INVALID_ENUM},
      {1, GL_RGBA, GL_BITMAP, GL_INVALID_ENUM},
      {1, GL_RGB, GL_UNSIGNED_INT_8_8_8_8, GL_INVALID_OPERATION},
      {1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, GL_INVALID_OPERATION},
      {1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, GL_INVALID_OPERATION},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(testing::Message() << std::hex << "format 0x" << c.format << " type 0x" << c.type);
    for (RenderContext* const context : {static_cast<RenderContext*>(mesa_.get()), ours_.get()}) {
      context->make_current();
      GLuint pixel = 0x5A5A5A5A;
      context->gl.ReadPixels(0, 0, c.width, 1, c.format, c.type, &pixel);
      EXPECT_EQ(context->gl.GetError(), c.error) << (context == mesa_.get() ? "Mesa" : "ours");
      EXPECT_EQ(pixel, 0x5A5A5A5A);
    }
  }
}

TEST_P(ReadPixels, DrawAndReadBuffer) {
  const GLenum modes[] = {GL_NONE,           GL_FRONT,       GL_BACK,    GL_LEFT,
                          GL_RIGHT,          GL_FRONT_LEFT,  GL_AUX0,    GL_BACK_RIGHT,
                          GL_FRONT_AND_BACK, GL_COLOR_INDEX, GL_AUX0 + 3};
  if (GetParam() == Dialect::gles) GTEST_SKIP() << "a framebuffer object: Mesa's is a window";
  for (const GLenum mode : modes) {
    SCOPED_TRACE(testing::Message() << std::hex << "mode 0x" << mode);
    std::array<GLenum, 2> draw_errors{}, read_errors{};
    std::array<GLint, 2> draw_buffers{}, read_buffers{};
    for (const bool ours : {false, true}) {
      RenderContext& context = ours ? *ours_ : *mesa_;
      context.make_current();
      context.gl.DrawBuffer(GL_FRONT);
      context.gl.ReadBuffer(GL_FRONT);
      context.gl.DrawBuffer(mode);
      draw_errors[ours] = context.gl.GetError();
      context.gl.ReadBuffer(mode);
      read_errors[ours] = context.gl.GetError();
      context.gl.GetIntegerv(GL_DRAW_BUFFER, &draw_buffers[ours]);
      context.gl.GetIntegerv(GL_READ_BUFFER, &read_buffers[ours]);
    }
    EXPECT_EQ(draw_errors[1], draw_errors[0]);
    EXPECT_EQ(draw_buffers[1], draw_buffers[0]);
    // Not among the buffers that glReadBuffer takes (GL 2.1 spec 4.3.2); Mesa takes both.
    if (mode == GL_NONE || mode == GL_FRONT_AND_BACK) {
      EXPECT_EQ(read_errors[0], GLenum{GL_NO_ERROR});
      EXPECT_EQ(read_errors[1], GLenum{GL_INVALID_ENUM});
    } else {
      EXPECT_EQ(read_errors[1], read_errors[0]);
      EXPECT_EQ(read_buffers[1], read_buffers[0]);
    }
  }
}

TEST_P(ReadPixels, DrawBufferNoneDrawsNothing) {
  ours_->gl.ClearColor(0.2F, 0.4F, 0.6F, 0.8F);
  ours_->gl.Clear(GL_COLOR_BUFFER_BIT);
  ours_->gl.PushAttrib(GL_COLOR_BUFFER_BIT);
  ours_->gl.DrawBuffer(GL_NONE);
  ours_->gl.Rectf(-1, -1, 1, 1);
  ours_->gl.PopAttrib();
  std::array<GLubyte, 4> pixel{};
  ours_->gl.ReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  EXPECT_EQ(pixel, (std::array<GLubyte, 4>{51, 102, 153, 204}));
  ours_->gl.Rectf(-1, -1, 1, 1);
  ours_->gl.ReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  EXPECT_EQ(pixel, (std::array<GLubyte, 4>{255, 255, 255, 255}));
}

}  // namespace

}  // namespace legacy_gl::test
