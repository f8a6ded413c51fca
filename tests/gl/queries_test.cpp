// glGet: what Mesa's fixed function answers after the same calls, in all four types; on core and
// GLES.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <ostream>
#include <vector>

#include "gl/query_calls.hpp"
#include "gl/query_names.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

/// A query leaves the values that it does not write as they were: their number is compared, too.
constexpr int kUntouched = 77;

template <typename T>
struct Answer {
  GLenum error = GL_NO_ERROR;
  std::array<T, 20> values{};
  bool operator==(const Answer&) const = default;
};

template <typename T>
void PrintTo(const Answer<T>& answer, std::ostream* out) {
  *out << "error " << answer.error << ':';
  for (const T value : answer.values)
    if (value != T(kUntouched)) *out << ' ' << +value;
}

template <typename T, typename Get>
Answer<T> ask(const GlFunctions& gl, Get get, GLenum name) {
  Answer<T> answer;
  answer.values.fill(T(kUntouched));
  get(name, answer.values.data());
  answer.error = gl.GetError();
  return answer;
}

struct Answers {
  Answer<GLboolean> booleans;
  Answer<GLint> integers;
  Answer<GLfloat> floats;
  Answer<GLdouble> doubles;
};

Answers ask_all(const GlFunctions& gl, GLenum name) {
  return {ask<GLboolean>(gl, gl.GetBooleanv, name), ask<GLint>(gl, gl.GetIntegerv, name),
          ask<GLfloat>(gl, gl.GetFloatv, name), ask<GLdouble>(gl, gl.GetDoublev, name)};
}

bool is_matrix(GLenum name) {
  switch (name) {
    case GL_MODELVIEW_MATRIX:
    case GL_PROJECTION_MATRIX:
    case GL_TEXTURE_MATRIX:
    case GL_TRANSPOSE_MODELVIEW_MATRIX:
    case GL_TRANSPOSE_PROJECTION_MATRIX:
    case GL_TRANSPOSE_TEXTURE_MATRIX: return true;
    default: return false;
  }
}

/// Names whose answer is another one than Mesa's: six user clip planes, and of compressed formats
/// those that go to the driver.
bool is_ours_alone(GLenum name) {
  return name == GL_MAX_CLIP_PLANES || name == GL_NUM_COMPRESSED_TEXTURE_FORMATS ||
         name == GL_COMPRESSED_TEXTURE_FORMATS;
}

/// Names whose answer is the driver's own: OpenGL ES has other limits than Mesa's desktop driver.
bool is_drivers(GLenum name) {
  switch (name) {
    case GL_MAX_TEXTURE_SIZE:
    case GL_MAX_3D_TEXTURE_SIZE:
    case GL_MAX_CUBE_MAP_TEXTURE_SIZE:
    case GL_MAX_TEXTURE_LOD_BIAS:
    case GL_MAX_VIEWPORT_DIMS:
    case GL_MAX_ELEMENTS_VERTICES:
    case GL_MAX_ELEMENTS_INDICES:
    case GL_POINT_SIZE_RANGE:
    case GL_POINT_SIZE_GRANULARITY:
    case GL_ALIASED_POINT_SIZE_RANGE:
    case GL_LINE_WIDTH_RANGE:
    case GL_LINE_WIDTH_GRANULARITY:
    case GL_ALIASED_LINE_WIDTH_RANGE:
    case GL_SUBPIXEL_BITS:
    case GL_DOUBLEBUFFER:
    case GL_DRAW_BUFFER:
    case GL_READ_BUFFER: return true;
    default: return false;
  }
}

enum class Dialect { core, gles };

std::unique_ptr<RenderContext> make_context(Dialect dialect) {
  if (dialect == Dialect::core) return std::make_unique<CoreContext>(64, 48);
  return std::make_unique<GlesContext>(64, 48);
}

/// Every name after the same calls.
void compare_with_mesa(Dialect dialect, QueryCalls::Function calls) {
  MesaContext mesa(64, 48);
  calls(mesa.gl);
  EXPECT_EQ(mesa.gl.GetError(), GLenum{GL_NO_ERROR}) << "the calls are none to compare after";
  std::vector<Answers> expected;
  for (const QueryName& query : kQueryNames) expected.push_back(ask_all(mesa.gl, query.value));
  const std::unique_ptr<RenderContext> ours = make_context(dialect);
  calls(ours->gl);
  EXPECT_EQ(ours->gl.GetError(), GLenum{GL_NO_ERROR});
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const GLenum name = kQueryNames[i].value;
    if (is_ours_alone(name) || (dialect == Dialect::gles && is_drivers(name))) continue;
    SCOPED_TRACE(kQueryNames[i].name);
    const Answers answers = ask_all(ours->gl, name);
    EXPECT_EQ(answers.booleans, expected[i].booleans);
    // As integers Mesa scales matrices like colours, which the specification does not say (6.1.2).
    if (!is_matrix(name)) {
      EXPECT_EQ(answers.integers, expected[i].integers);
    }
    EXPECT_EQ(answers.floats, expected[i].floats);
    EXPECT_EQ(answers.doubles, expected[i].doubles);
  }
}

class Queries : public testing::TestWithParam<Dialect> {};
INSTANTIATE_TEST_SUITE_P(Dialects, Queries, testing::Values(Dialect::core, Dialect::gles),
                         [](const auto& parameter) {
                           return parameter.param == Dialect::core ? "core" : "gles";
                         });

TEST_P(Queries, InitialState) {
  compare_with_mesa(GetParam(), [](const GlFunctions&) {});
}

class QueriesAfterCalls : public testing::TestWithParam<std::tuple<Dialect, QueryCalls>> {};
INSTANTIATE_TEST_SUITE_P(
    Dialects, QueriesAfterCalls,
    testing::Combine(testing::Values(Dialect::core, Dialect::gles),
                     testing::ValuesIn(query_calls().begin(), query_calls().end())),
    [](const auto& parameter) {
      return std::string(std::get<0>(parameter.param) == Dialect::core ? "core_" : "gles_") +
             std::get<1>(parameter.param).name;
    });

TEST_P(QueriesAfterCalls, SetAndGet) {
  compare_with_mesa(std::get<0>(GetParam()), std::get<1>(GetParam()).calls);
}

TEST_P(Queries, MatricesAsIntegersAreRounded) {
  const auto context = make_context(GetParam());
  context->gl.Translatef(2.5F, -7.4F, 1e20F);
  std::array<GLint, 16> matrix{};
  context->gl.GetIntegerv(GL_MODELVIEW_MATRIX, matrix.data());
  EXPECT_EQ(matrix,
            (std::array<GLint, 16>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, -7, 2147483647, 1}));
}

// The three cases in which Mesa's answer is not the specification's, and ours is.

TEST_P(Queries, TransposedTextureMatrixIsTheActiveUnits) {
  const auto calls = [](const GlFunctions& gl) {
    std::array<GLfloat, 16> matrix{};
    gl.ActiveTexture(GL_TEXTURE3);
    gl.MatrixMode(GL_TEXTURE);
    gl.Translatef(5, 6, 7);
    gl.GetFloatv(GL_TRANSPOSE_TEXTURE_MATRIX, matrix.data());
    return matrix[3];
  };
  EXPECT_EQ(calls(MesaContext(8, 8).gl), 0) << "Mesa asks unit 0";
  EXPECT_EQ(calls(make_context(GetParam())->gl), 5);
}

/// "the nearest value representable using the requested type" (GL 2.1 spec 6.1.2)
TEST_P(Queries, ColorsAboveOneAreTheLargestInteger) {
  const auto calls = [](const GlFunctions& gl) {
    std::array<GLint, 4> color{};
    gl.Color4f(2.5F, -2.5F, 1, -1);
    gl.GetIntegerv(GL_CURRENT_COLOR, color.data());
    return color;
  };
  constexpr GLint kLargest = 2147483647;
  EXPECT_EQ(calls(MesaContext(8, 8).gl)[0], -kLargest - 1) << "Mesa's conversion overflows";
  EXPECT_EQ(calls(make_context(GetParam())->gl),
            (std::array<GLint, 4>{kLargest, -kLargest - 1, kLargest, -kLargest}));
}

/// A flag is true unless the value is zero (GL 2.1 spec 3.6.1).
TEST_P(Queries, PixelStoreFlagsAreNotRounded) {
  const auto calls = [](const GlFunctions& gl) {
    GLint flag = kUntouched;
    gl.PixelStoref(GL_UNPACK_SWAP_BYTES, 0.2F);
    gl.GetIntegerv(GL_UNPACK_SWAP_BYTES, &flag);
    return flag;
  };
  EXPECT_EQ(calls(MesaContext(8, 8).gl), 0) << "Mesa rounds";
  EXPECT_EQ(calls(make_context(GetParam())->gl), 1);
}

TEST_P(Queries, Errors) {
  const auto context = make_context(GetParam());
  const GlFunctions& gl = context->gl;
  const auto names_that_are_none = {GL_LIGHT0 + 8, GL_TRIANGLES, GL_SPOT_CUTOFF, 0xFFFFFFF};
  for (const auto name : names_that_are_none) {
    const Answers answers = ask_all(gl, static_cast<GLenum>(name));
    EXPECT_EQ(answers.booleans.error, GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(answers.integers.error, GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(answers.floats.error, GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(answers.doubles.error, GLenum{GL_INVALID_ENUM});
    EXPECT_EQ(answers.doubles.values[0], kUntouched);
  }
  GLint value = kUntouched;
  gl.Begin(GL_TRIANGLES);
  gl.GetIntegerv(GL_MATRIX_MODE, &value);
  gl.End();
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
  EXPECT_EQ(value, kUntouched);
}

TEST_P(Queries, MaxLightsIsTheOption) {
  legacy_gl_options options{};
  options.max_lights = 200;
  std::unique_ptr<RenderContext> context;
  if (GetParam() == Dialect::core)
    context = std::make_unique<CoreContext>(8, 8, PixelFormat::rgba8, options);
  else context = std::make_unique<GlesContext>(8, 8, PixelFormat::rgba8, options);
  GLint max_lights = 0;
  context->gl.GetIntegerv(GL_MAX_LIGHTS, &max_lights);
  EXPECT_EQ(max_lights, 200);
  context->gl.Enable(GL_LIGHT0 + 199);
  EXPECT_EQ(context->gl.IsEnabled(GL_LIGHT0 + 199), GL_TRUE);
  EXPECT_EQ(context->gl.GetError(), GLenum{GL_NO_ERROR});
}

}  // namespace

}  // namespace legacy_gl::test
