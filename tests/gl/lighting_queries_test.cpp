// glGetLight, glGetMaterial (GL 2.1 spec 6.1.3): Mesa's answers after the same calls.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <vector>

#include "support/contexts.hpp"

namespace legacy_gl::test {

namespace {

enum class Dialect { core, gles };

std::unique_ptr<RenderContext> make_context(Dialect dialect) {
  if (dialect == Dialect::core) return std::make_unique<CoreContext>(16, 16);
  return std::make_unique<GlesContext>(16, 16);
}

constexpr GLenum kLightNames[] = {GL_AMBIENT,
                                  GL_DIFFUSE,
                                  GL_SPECULAR,
                                  GL_POSITION,
                                  GL_SPOT_DIRECTION,
                                  GL_SPOT_EXPONENT,
                                  GL_SPOT_CUTOFF,
                                  GL_CONSTANT_ATTENUATION,
                                  GL_LINEAR_ATTENUATION,
                                  GL_QUADRATIC_ATTENUATION};
constexpr GLenum kMaterialNames[] = {GL_AMBIENT,  GL_DIFFUSE,   GL_SPECULAR,
                                     GL_EMISSION, GL_SHININESS, GL_COLOR_INDEXES};

/// The untouched values of an array that is filled before tell how many were written.
struct Values {
  std::array<GLfloat, 6> floats;
  std::array<GLint, 6> integers;
  Values() {
    floats.fill(77);
    integers.fill(77);
  }
  bool operator==(const Values&) const = default;
};

Values get_light(const GlFunctions& gl, GLenum light, GLenum name) {
  Values values;
  gl.GetLightfv(light, name, values.floats.data());
  gl.GetLightiv(light, name, values.integers.data());
  return values;
}

Values get_material(const GlFunctions& gl, GLenum face, GLenum name) {
  Values values;
  gl.GetMaterialfv(face, name, values.floats.data());
  gl.GetMaterialiv(face, name, values.integers.data());
  return values;
}

class LightingQueries : public testing::TestWithParam<Dialect> {
 protected:
  void compare_after(void (*calls)(const GlFunctions& gl)) {
    mesa_.make_current();
    calls(mesa_.gl);
    std::vector<Values> expected;
    visit(mesa_.gl, [&](const Values& values, GLenum, GLenum) { expected.push_back(values); });
    ours_->make_current();
    calls(ours_->gl);
    std::size_t i = 0;
    visit(ours_->gl, [&](const Values& values, GLenum of, GLenum name) {
      SCOPED_TRACE(testing::Message() << std::hex << "0x" << of << " 0x" << name);
      expect_near(values.floats, expected[i].floats);
      EXPECT_EQ(values.integers, expected[i].integers);
      ++i;
    });
    EXPECT_EQ(ours_->gl.GetError(), GLenum{GL_NO_ERROR});
  }

  /// Lights are kept in eye coordinates, which come here from a product in double and in Mesa from
  /// one in float.
  static void expect_near(const std::array<GLfloat, 6>& values,
                          const std::array<GLfloat, 6>& expected) {
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], expected[i], 1e-6F);
  }

  template <typename Visitor>
  static void visit(const GlFunctions& gl, Visitor visitor) {
    for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 8; ++light)
      for (const GLenum name : kLightNames) visitor(get_light(gl, light, name), light, name);
    for (const GLenum face : {GLenum{GL_FRONT}, GLenum{GL_BACK}})
      for (const GLenum name : kMaterialNames) visitor(get_material(gl, face, name), face, name);
  }

  MesaContext mesa_{16, 16};
  std::unique_ptr<RenderContext> ours_ = make_context(GetParam());
};

INSTANTIATE_TEST_SUITE_P(Dialects, LightingQueries, testing::Values(Dialect::core, Dialect::gles),
                         [](const auto& parameter) {
                           return parameter.param == Dialect::core ? "core" : "gles";
                         });

TEST_P(LightingQueries, InitialState) {
  compare_after([](const GlFunctions&) {});
}

TEST_P(LightingQueries, LightsSetAndGet) {
  compare_after([](const GlFunctions& gl) {
    const GLfloat color[] = {0.1F, 0.7F, -0.25F, 0.3F};
    const GLint integer_color[] = {2147483647, 0, -2147483647 - 1, 1000000000};
    const GLfloat position[] = {1, -2, 3, 1};
    const GLint integer_position[] = {5, -6, 7, 0};
    const GLfloat direction[] = {3, -4, 2};
    gl.Translatef(1, 2, 3);
    gl.Lightfv(GL_LIGHT6, GL_SPOT_DIRECTION, direction);
    gl.Rotatef(90, 0, 0, 1);
    gl.Lightfv(GL_LIGHT0, GL_AMBIENT, color);
    gl.Lightfv(GL_LIGHT1, GL_DIFFUSE, color);
    gl.Lightfv(GL_LIGHT2, GL_SPECULAR, color);
    gl.Lightiv(GL_LIGHT3, GL_SPECULAR, integer_color);
    gl.Lightfv(GL_LIGHT4, GL_POSITION, position);
    gl.Lightiv(GL_LIGHT5, GL_POSITION, integer_position);
    gl.Lightf(GL_LIGHT7, GL_SPOT_EXPONENT, 12.25F);
    gl.Lightf(GL_LIGHT7, GL_SPOT_CUTOFF, 33.4F);
    gl.Lightf(GL_LIGHT1, GL_CONSTANT_ATTENUATION, 1.25F);
    gl.Lightf(GL_LIGHT2, GL_LINEAR_ATTENUATION, 0.49F);
    gl.Lighti(GL_LIGHT3, GL_QUADRATIC_ATTENUATION, 3);
    gl.Translatef(9, 9, 9);
  });
}

TEST_P(LightingQueries, MaterialsSetAndGet) {
  compare_after([](const GlFunctions& gl) {
    const GLfloat color[] = {0.1F, 0.7F, -0.25F, 0.3F};
    const GLint integer_color[] = {2147483647, 0, -2147483647 - 1, 1000000000};
    const GLfloat indexes[] = {1.25F, 2.5F, 3};
    gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color);
    gl.Materialfv(GL_BACK, GL_SPECULAR, color);
    gl.Materialiv(GL_FRONT_AND_BACK, GL_EMISSION, integer_color);
    gl.Materialf(GL_FRONT, GL_SHININESS, 12.5F);
    gl.Materiali(GL_BACK, GL_SHININESS, 128);
    gl.Materialfv(GL_BACK, GL_COLOR_INDEXES, indexes);
  });
}

TEST_P(LightingQueries, TrackedMaterialsFollowTheCurrentColor) {
  compare_after([](const GlFunctions& gl) {
    gl.ColorMaterial(GL_FRONT, GL_SPECULAR);
    gl.Enable(GL_COLOR_MATERIAL);
    gl.Color4f(0.25F, 0.5F, 0.75F, 0.5F);
    // Tracked: ignored.
    const GLfloat color[] = {0.1F, 0.7F, 0.25F, 0.3F};
    gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, color);
    gl.Begin(GL_POINTS);
    gl.Color3f(0, 1, 0.5F);
    gl.Vertex2f(0, 0);
    gl.End();
  });
}

TEST_P(LightingQueries, TrackedMaterialsStay) {
  compare_after([](const GlFunctions& gl) {
    gl.Enable(GL_COLOR_MATERIAL);
    gl.Color4f(0.25F, 0.5F, 0.75F, 0.5F);
    // Asked before each change, since Mesa lets the material follow no earlier.
    get_material(gl, GL_FRONT, GL_DIFFUSE);
    gl.ColorMaterial(GL_BACK, GL_EMISSION);
    gl.Color4f(0.1F, 0.2F, 0.3F, 0.4F);
    get_material(gl, GL_FRONT, GL_DIFFUSE);
    gl.Disable(GL_COLOR_MATERIAL);
    gl.Color4f(1, 1, 1, 1);
  });
}

TEST_P(LightingQueries, MaterialsInsideBeginEnd) {
  compare_after([](const GlFunctions& gl) {
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) {
      const auto t = static_cast<GLfloat>(i);
      const GLfloat color[] = {t / 4, 1 - t / 4, 0, 1};
      gl.Materialfv(GL_FRONT, GL_DIFFUSE, color);
      gl.Vertex2f(t, t * t);
    }
    gl.End();
  });
}

/// Rounded, as other queries are (GL 2.1 spec 6.1.2, 6.1.3); Mesa truncates.
TEST_P(LightingQueries, IntegersAreRounded) {
  const auto calls = [](const GlFunctions& gl) {
    const GLfloat direction[] = {-0.75F, 2.25F, 3.5F};
    gl.Lightfv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
    return get_light(gl, GL_LIGHT0, GL_SPOT_DIRECTION).integers;
  };
  mesa_.make_current();
  EXPECT_EQ(calls(mesa_.gl), (std::array<GLint, 6>{0, 2, 3, 77, 77, 77}));
  ours_->make_current();
  EXPECT_EQ(calls(ours_->gl), (std::array<GLint, 6>{-1, 2, 4, 77, 77, 77}));
}

/// At glEnable the tracked properties take the current colour at once. Mesa keeps the old material
/// when glMaterial, glColor, glColorMaterial and glEnable follow each other and nothing is drawn
/// between.
TEST_P(LightingQueries, TrackingBeginsAtEnable) {
  const auto calls = [](const GlFunctions& gl) {
    const GLfloat red[] = {1, 0, 0, 1};
    gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, red);
    gl.Color4f(0, 1, 0, 1);
    gl.ColorMaterial(GL_FRONT_AND_BACK, GL_DIFFUSE);
    gl.Enable(GL_COLOR_MATERIAL);
    std::array<GLfloat, 4> diffuse{};
    gl.GetMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse.data());
    return diffuse;
  };
  mesa_.make_current();
  EXPECT_EQ(calls(mesa_.gl), (std::array<GLfloat, 4>{1, 0, 0, 1})) << "Mesa departs no more";
  ours_->make_current();
  EXPECT_EQ(calls(ours_->gl), (std::array<GLfloat, 4>{0, 1, 0, 1}));
}

TEST_P(LightingQueries, Errors) {
  for (RenderContext* const context : {static_cast<RenderContext*>(&mesa_), ours_.get()}) {
    context->make_current();
    const GlFunctions& gl = context->gl;
    const auto expect = [&](const Values& values, GLenum error) {
      EXPECT_EQ(gl.GetError(), error);
      EXPECT_EQ(values, Values{});
    };
    expect(get_light(gl, GL_LIGHT0 + 8, GL_AMBIENT), GL_INVALID_ENUM);
    expect(get_light(gl, GL_LIGHT0 - 1, GL_AMBIENT), GL_INVALID_ENUM);
    expect(get_light(gl, GL_LIGHT0, GL_SHININESS), GL_INVALID_ENUM);
    expect(get_material(gl, GL_FRONT_AND_BACK, GL_AMBIENT), GL_INVALID_ENUM);
    expect(get_material(gl, GL_LIGHT0, GL_AMBIENT), GL_INVALID_ENUM);
    expect(get_material(gl, GL_FRONT, GL_AMBIENT_AND_DIFFUSE), GL_INVALID_ENUM);
    gl.Begin(GL_POINTS);
    const Values light = get_light(gl, GL_LIGHT0, GL_AMBIENT);
    const Values material = get_material(gl, GL_FRONT, GL_AMBIENT);
    gl.End();
    expect(light, GL_INVALID_OPERATION);
    expect(material, GL_NO_ERROR);
  }
}

// legacy_gl_options.scalars_for_vectors: the first value is set, the others are 0. Mesa leaves
// those of materials as they come, and takes a border colour in lists alone.
TEST(ScalarsForVectors, AreTakenAsMesaTakesThem) {
  const auto values_of = [](RenderContext& context) {
    context.make_current();
    const GlFunctions& gl = context.gl;
    gl.Materialf(GL_FRONT, GL_AMBIENT, 0.5F);
    gl.Materiali(GL_BACK, GL_DIFFUSE, 1);
    gl.Lightf(GL_LIGHT1, GL_SPECULAR, 0.25F);
    gl.Lighti(GL_LIGHT2, GL_POSITION, 3);
    gl.LightModelf(GL_LIGHT_MODEL_AMBIENT, 0.75F);
    gl.Fogf(GL_FOG_COLOR, 0.5F);
    gl.TexGend(GL_S, GL_OBJECT_PLANE, 2);
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
    gl.NewList(1, GL_COMPILE);
    gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 0.5F);
    gl.EndList();
    gl.CallList(1);
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
    std::array<std::array<GLfloat, 4>, 8> values{};
    gl.GetMaterialfv(GL_FRONT, GL_AMBIENT, values[0].data());
    gl.GetMaterialfv(GL_BACK, GL_DIFFUSE, values[1].data());
    gl.GetLightfv(GL_LIGHT1, GL_SPECULAR, values[2].data());
    gl.GetLightfv(GL_LIGHT2, GL_POSITION, values[3].data());
    gl.GetFloatv(GL_LIGHT_MODEL_AMBIENT, values[4].data());
    gl.GetFloatv(GL_FOG_COLOR, values[5].data());
    gl.GetTexGenfv(GL_S, GL_OBJECT_PLANE, values[6].data());
    gl.GetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, values[7].data());
    return values;
  };
  legacy_gl_options options{};
  options.scalars_for_vectors = 1;
  MesaContext mesa(16, 16);
  CoreContext ours(16, 16, PixelFormat::rgba8, options);
  const auto values = values_of(ours), of_mesa = values_of(mesa);
  for (std::size_t i = 0; i < values.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(values[i], (std::array<GLfloat, 4>{of_mesa[i][0], 0, 0, 0}));
    EXPECT_GT(values[i][0], 0);
  }
}

}  // namespace

}  // namespace legacy_gl::test
