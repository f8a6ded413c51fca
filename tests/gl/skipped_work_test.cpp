// Work that a scene does not need is not done: a counter says so, and Mesa's fixed function says
// that the picture is the same.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "scene_changes.hpp"
#include "support/contexts.hpp"
#include "support/image_matcher.hpp"

namespace legacy_gl::test {
namespace {

using Change = void (*)(const GlFunctions& gl);
using Color = std::array<float, 4>;

constexpr Color kBlack{0, 0, 0, 1};

class SkippedWork : public testing::Test {
 protected:
  SkippedWork() : mesa(64, 64), ours(64, 64) {
    apply(set_up_scene);
    draw(draw_scene);
  }

  void apply(Change change) {
    mesa.make_current();
    change(mesa.gl);
    ours.make_current();
    change(ours.gl);
  }

  // What our frame cost; both pictures agree.
  legacy_gl_statistics draw(Change frame) {
    mesa.make_current();
    frame(mesa.gl);
    const Image expected = mesa.read_rgba8();
    ours.make_current();
    legacy_gl_reset_statistics();
    frame(ours.gl);
    EXPECT_TRUE(images_match(ours.read_rgba8(), expected, {.max_difference_steps = 1}, "skipped"));
    EXPECT_GT(covered_pixels(expected), 50);
    legacy_gl_statistics statistics;
    legacy_gl_get_statistics(&statistics);
    return statistics;
  }

  legacy_gl_statistics draw_with(Change change) {
    apply(change);
    return draw(draw_scene);
  }

  // What `frame` costs again, after `change`; the picture stays. Making a context current forgets
  // what is bound, and Mesa has none of this frame.
  legacy_gl_statistics draw_again(Change change, Change frame) {
    draw(frame);
    const Image before = ours.read_rgba8();
    legacy_gl_reset_statistics();
    change(ours.gl);
    frame(ours.gl);
    EXPECT_EQ(ours.read_rgba8().bytes, before.bytes);
    legacy_gl_statistics statistics;
    legacy_gl_get_statistics(&statistics);
    return statistics;
  }

  MesaContext mesa;
  CoreContext ours;
};

std::string program_text() {
  std::vector<char> text(legacy_gl_get_program_source(nullptr, 0) + 1);
  legacy_gl_get_program_source(text.data(), text.size());
  return text.data();
}

bool program_mentions(const char* word) { return program_text().find(word) != std::string::npos; }

TEST_F(SkippedWork, ForLightsThatAreOff) {
  const Change change = [](const GlFunctions& gl) {
    const Color position{1, 2, 3, 1};
    gl.Lightfv(GL_LIGHT3, GL_DIFFUSE, position.data());
    gl.Lightfv(GL_LIGHT3, GL_POSITION, position.data());
    gl.Lightf(GL_LIGHT3, GL_SPOT_CUTOFF, 20);
  };
  const legacy_gl_statistics statistics = draw_again(change, draw_scene);
  EXPECT_EQ(statistics.programs_generated, 0u);
  EXPECT_EQ(statistics.uniform_block_updates, 0u);
}

TEST_F(SkippedWork, ForLightsThatAreOffBetweenPrimitives) {
  const legacy_gl_statistics statistics = draw([](const GlFunctions& gl) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < 10; ++i) {
      gl.Lightf(GL_LIGHT5, GL_LINEAR_ATTENUATION, static_cast<float>(i));
      gl.Begin(GL_TRIANGLES);
      gl.Vertex3f(-1, -1, 0);
      gl.Vertex3f(1, -1, 0);
      gl.Vertex3f(0, 1 - 0.1F * static_cast<float>(i), 0);
      gl.End();
    }
  });
  EXPECT_EQ(statistics.draws, 1u);
}

TEST_F(SkippedWork, ForALightThatIsOffUntilItIsOn) {
  draw_with([](const GlFunctions& gl) {
    const Color green{0, 1, 0, 1}, position{-1, 1, 1, 0};
    gl.Lightfv(GL_LIGHT3, GL_DIFFUSE, green.data());
    gl.Lightfv(GL_LIGHT3, GL_POSITION, position.data());
  });
  EXPECT_GT(draw_with([](const GlFunctions& gl) { gl.Enable(GL_LIGHT3); }).uniform_block_updates,
            0u);
}

TEST_F(SkippedWork, ForLightsWhoseProductsAreZero) {
  const legacy_gl_statistics statistics = draw_with([](const GlFunctions& gl) {
    const Color red{1, 0, 0, 1}, cyan{0, 1, 1, 1};
    for (const int term : {GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT}) {
      gl.Lightfv(GL_LIGHT4, static_cast<GLenum>(term), red.data());
      gl.Materialfv(GL_FRONT_AND_BACK, static_cast<GLenum>(term), cyan.data());
    }
    gl.Enable(GL_LIGHT4);
  });
  EXPECT_EQ(statistics.lights_skipped, 1u);
  EXPECT_EQ(statistics.programs_generated, 0u);
}

TEST_F(SkippedWork, ForTermsThatAreZero) {
  EXPECT_TRUE(program_mentions("half_vector.xyz"));
  const legacy_gl_statistics statistics = draw_with(
      [](const GlFunctions& gl) { gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, kBlack.data()); });
  EXPECT_EQ(statistics.light_terms_skipped, 2u);  // and the ambient, which is black from the start
  EXPECT_FALSE(program_mentions("half_vector.xyz"));
}

TEST_F(SkippedWork, ForConstantAttenuation) {
  draw_with([](const GlFunctions& gl) {
    const Color position{0.5F, 0.5F, 2, 1};
    gl.Lightfv(GL_LIGHT0, GL_POSITION, position.data());
  });
  const legacy_gl_statistics statistics = draw_with(
      [](const GlFunctions& gl) { gl.Lightf(GL_LIGHT0, GL_CONSTANT_ATTENUATION, 1.75F); });
  EXPECT_EQ(statistics.attenuations_folded, 1u);
  EXPECT_EQ(statistics.programs_generated, 0u);
  EXPECT_FALSE(program_mentions("float distance"));
  EXPECT_EQ(draw_with([](const GlFunctions& gl) {
              gl.Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.25F);
            }).attenuations_folded,
            0u);
  EXPECT_TRUE(program_mentions("float distance"));
}

TEST_F(SkippedWork, ForSpotExponentsOfZero) {
  const legacy_gl_statistics statistics = draw_with([](const GlFunctions& gl) {
    const Color position{0.2F, 0.1F, 2, 1};
    gl.Lightfv(GL_LIGHT0, GL_POSITION, position.data());
    gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 40);
  });
  EXPECT_EQ(statistics.spot_exponents_skipped, 1u);
  EXPECT_FALSE(program_mentions("attenuation.w"));
  EXPECT_EQ(draw_with([](const GlFunctions& gl) {
              gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 3);
            }).spot_exponents_skipped,
            0u);
  EXPECT_TRUE(program_mentions("attenuation.w"));
}

// A dome of unit normals, each as float32 rounds it.
void draw_dome(const GlFunctions& gl, float length) {
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 4; ++j)
      for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
        const double u = 0.7854 * (i + a), v = 0.35 * (j + b);
        const std::array<float, 3> n{static_cast<float>(std::sin(v) * std::cos(u)),
                                     static_cast<float>(std::sin(v) * std::sin(u)),
                                     static_cast<float>(std::cos(v))};
        gl.Normal3f(length * n[0], length * n[1], length * n[2]);
        gl.Vertex3f(1.5F * n[0], 1.5F * n[1], n[2]);
      }
  gl.End();
}

void call_lists(const GlFunctions& gl, GLuint list) {
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.PushMatrix();
  gl.Rotatef(25, 0.3F, 1, 0.2F);
  gl.Scalef(0.8F, 0.8F, 0.8F);
  gl.CallList(list);
  gl.PopMatrix();
}

void compile_domes(const GlFunctions& gl) {
  gl.NewList(1, GL_COMPILE);
  draw_dome(gl, 1);
  gl.EndList();
  gl.NewList(2, GL_COMPILE);
  draw_dome(gl, 1.5F);
  gl.EndList();
  gl.Enable(GL_NORMALIZE);
}

TEST_F(SkippedWork, ForUnitNormalsThatAreNormalized) {
  apply(compile_domes);
  const legacy_gl_statistics unit = draw([](const GlFunctions& gl) { call_lists(gl, 1); });
  EXPECT_EQ(unit.normalizations_skipped, 1u);
  const legacy_gl_statistics longer = draw([](const GlFunctions& gl) { call_lists(gl, 2); });
  EXPECT_EQ(longer.normalizations_skipped, 0u);
  // Both kinds in turns, by list and by glBegin.
  draw([](const GlFunctions& gl) {
    call_lists(gl, 1);
    gl.Translatef(0.3F, 0, 0);
    gl.CallList(2);
    gl.Translatef(-0.6F, 0, 0);
    gl.CallList(1);
    gl.Translatef(0.3F, 0, 0);
    draw_dome(gl, 2);
    draw_dome(gl, 1);
  });
}

TEST_F(SkippedWork, ForUnitNormalsUnderEveryLightAndMatrix) {
  apply(compile_domes);
  const auto check = [this](Change change, std::uint64_t skipped) {
    apply(change);
    EXPECT_EQ(draw([](const GlFunctions& gl) { call_lists(gl, 1); }).normalizations_skipped,
              skipped);
  };
  check(
      [](const GlFunctions& gl) {
        const Color position{1, 2, 2, 1};
        gl.Lightfv(GL_LIGHT1, GL_POSITION, position.data());
        gl.Lightfv(GL_LIGHT1, GL_SPECULAR, position.data());
        gl.Enable(GL_LIGHT1);
        gl.Materialf(GL_FRONT, GL_SHININESS, 100);
      },
      1);
  check([](const GlFunctions& gl) { gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1); }, 1);
  check([](const GlFunctions& gl) { gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); }, 1);
  check([](const GlFunctions& gl) { gl.Enable(GL_RESCALE_NORMAL); }, 1);
  check([](const GlFunctions& gl) { gl.Disable(GL_LIGHT1); }, 1);
  check([](const GlFunctions& gl) { gl.Scalef(1, 0.7F, 1.2F); }, 0);  // no angle is kept
}

TEST_F(SkippedWork, ForBackFacesThatAreCulled) {
  apply([](const GlFunctions& gl) { gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1); });
  EXPECT_EQ(draw(draw_scene).back_faces_skipped, 0u);
  EXPECT_TRUE(program_mentions("back_lit"));
  EXPECT_EQ(draw_with([](const GlFunctions& gl) { gl.Enable(GL_CULL_FACE); }).back_faces_skipped,
            1u);
  EXPECT_FALSE(program_mentions("back_lit"));
  EXPECT_EQ(draw_with([](const GlFunctions& gl) { gl.CullFace(GL_FRONT); }).back_faces_skipped, 0u);
  EXPECT_TRUE(program_mentions("back_lit"));
}

void project(const GlFunctions& gl, float perspective) {
  const float columns[] = {0.4F, 0, 0,     0,           0, 0.4F, 0,     0,  //
                           0,    0, -0.2F, perspective, 0, 0,    -0.5F, 1};
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadMatrixf(columns);
  gl.MatrixMode(GL_MODELVIEW);
}

TEST_F(SkippedWork, ForTheWOfParallelProjections) {
  draw_with([](const GlFunctions& gl) { project(gl, 0); });
  EXPECT_TRUE(program_mentions("parallel projection"));
  draw_with([](const GlFunctions& gl) { project(gl, -0.05F); });
  EXPECT_FALSE(program_mentions("parallel projection"));
  draw_with([](const GlFunctions& gl) {
    project(gl, 0);
    gl.Scalef(1, 1.2F, 0.9F);
  });
  EXPECT_TRUE(program_mentions("parallel projection"));
  // Not drawn: Mesa leaves the modelview's w out of lighting (docs/deviations.md, M3).
  apply([](const GlFunctions& gl) {
    const float columns[] = {1, 0, 0, 0.1F, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    gl.MultMatrixf(columns);
  });
  EXPECT_FALSE(program_mentions("parallel projection"));
}

TEST_F(SkippedWork, ForAttributesThatNobodyReads) {
  const Change frame = [](const GlFunctions& gl) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw_dome(gl, 1);
  };
  const std::uint64_t vertices = 8 * 4 * 6;
  EXPECT_EQ(draw(frame).vertex_bytes_uploaded, vertices * 6 * sizeof(float));  // no colour
  apply([](const GlFunctions& gl) {
    gl.Disable(GL_LIGHTING);
    gl.TexCoord2f(0.5F, 0.5F);
    gl.SecondaryColor3f(1, 0, 0);
    gl.FogCoordf(3);
  });
  EXPECT_EQ(draw(frame).vertex_bytes_uploaded, vertices * 7 * sizeof(float));  // no normal
}

TEST_F(SkippedWork, ForStateThatDidNotChange) {
  const Change frame = [](const GlFunctions& gl) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < 10; ++i) {
      const Color specular{0.6F, 0.5F, 0.4F, 0.75F};
      gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, specular.data());
      gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 12);
      gl.Enable(GL_LIGHT0);
      gl.ShadeModel(GL_SMOOTH);
      gl.DepthFunc(GL_LESS);
      draw_dome(gl, 1);
    }
  };
  const legacy_gl_statistics statistics = draw_again([](const GlFunctions&) {}, frame);
  EXPECT_EQ(statistics.draws, 1u);
  EXPECT_EQ(statistics.uniform_block_updates, 0u);
}

TEST_F(SkippedWork, ForListsOutsideOfTheView) {
  apply(compile_domes);
  const Change frame = [](const GlFunctions& gl) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.CallList(1);
    gl.PushMatrix();
    gl.Translatef(50, 0, 0);
    gl.CallList(2);
    gl.PopMatrix();
    gl.PushMatrix();
    gl.Translatef(0, 0, 30);
    gl.CallList(1);
    gl.PopMatrix();
  };
  const legacy_gl_statistics statistics = draw(frame);
  EXPECT_EQ(statistics.primitives_clipped, 2u);
  EXPECT_EQ(statistics.draws, 1u);
}

}  // namespace
}  // namespace legacy_gl::test
