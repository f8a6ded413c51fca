// Small objects with matrices and materials of their own join one batch; the picture is that of one
// draw each.
#include <gtest/gtest.h>

#include <array>

#include "scene_changes.hpp"
#include "support/contexts.hpp"
#include "support/image_matcher.hpp"
#include "support/library.hpp"

namespace legacy_gl::test {
namespace {

constexpr int kSize = 96;
constexpr int kObjects = 40;

using Change = void (*)(const GlFunctions& gl);
using Figure = void (*)(const GlFunctions& gl);

void vertex(const GlFunctions& gl, float x, float y, float z) {
  gl.Normal3f(x, y, z + 0.5F);
  gl.Color4f(0.5F + x, 0.5F + y, 0.5F, 0.7F);
  gl.Vertex3f(x, y, z);
}

void draw_figure(const GlFunctions& gl, GLenum mode, int count) {
  gl.Begin(mode);
  for (int i = 0; i < count; ++i)
    vertex(gl, 0.3F * static_cast<float>(i % 2) - 0.15F, 0.1F * static_cast<float>(i / 2) - 0.2F,
           0.1F * static_cast<float>(i % 3));
  gl.End();
}

void draw_strip(const GlFunctions& gl) { draw_figure(gl, GL_TRIANGLE_STRIP, 9); }
void draw_fan(const GlFunctions& gl) { draw_figure(gl, GL_TRIANGLE_FAN, 6); }
void draw_triangles(const GlFunctions& gl) { draw_figure(gl, GL_TRIANGLES, 9); }
void draw_quads(const GlFunctions& gl) { draw_figure(gl, GL_QUADS, 8); }
void draw_lines(const GlFunctions& gl) { draw_figure(gl, GL_LINE_STRIP, 8); }
void draw_points(const GlFunctions& gl) { draw_figure(gl, GL_POINTS, 8); }
void draw_list(const GlFunctions& gl) { gl.CallList(7); }
void draw_mixed(const GlFunctions& gl) {
  draw_list(gl);
  draw_strip(gl);
  draw_quads(gl);
}

void set_object(const GlFunctions& gl, int i, bool large_steps) {
  const float f = static_cast<float>(i);
  const float reach = large_steps ? 1.6F : 0.7F;  // over the border of the view, or within it
  gl.Translatef(reach * (f * 0.37F - static_cast<float>(static_cast<int>(f * 0.37F)) - 0.5F),
                reach * (f * 0.23F - static_cast<float>(static_cast<int>(f * 0.23F)) - 0.5F),
                0.02F * f - 0.4F);
  gl.Rotatef(37 * f, 0.3F, 0.5F, 0.8F);
  const std::array<float, 4> color{0.1F * static_cast<float>(i % 7), 0.4F, 0.02F * f, 0.8F};
  const std::array<float, 4> glow{0, 0.01F * static_cast<float>(i % 5), 0, 1};
  gl.Materialfv(GL_FRONT_AND_BACK, i % 3 ? GL_DIFFUSE : GL_AMBIENT_AND_DIFFUSE, color.data());
  gl.Materialfv(GL_FRONT, GL_SPECULAR, color.data());
  gl.Materialfv(GL_FRONT, GL_EMISSION, glow.data());
  gl.Materialf(GL_FRONT, GL_SHININESS, static_cast<float>(5 + i % 20));
}

struct Drawing {
  Image image;
  std::vector<float> depths;
};

// `between` is called after each object.
Drawing draw(RenderContext& context, Change set_up, Figure figure, bool large_steps,
             Change between) {
  context.recreate();
  const GlFunctions& gl = context.gl;
  set_up_scene(gl);
  gl.NewList(7, GL_COMPILE);
  draw_triangles(gl);
  draw_fan(gl);
  gl.EndList();
  gl.Enable(GL_DEPTH_TEST);
  gl.MatrixMode(GL_MODELVIEW);
  set_up(gl);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int i = 0; i < kObjects; ++i) {
    gl.PushMatrix();
    set_object(gl, i, large_steps);
    figure(gl);
    gl.PopMatrix();
    between(gl);
  }
  Drawing drawing{context.read_rgba8(), std::vector<float>(std::size_t{kSize} * kSize)};
  gl.ReadPixels(0, 0, kSize, kSize, GL_DEPTH_COMPONENT, GL_FLOAT, drawing.depths.data());
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  return drawing;
}

void nothing(const GlFunctions&) {}
void flush(const GlFunctions& gl) { gl.Flush(); }

void lights_with_positions(const GlFunctions& gl) {
  const std::array<float, 4> position{1, 1, 2, 1}, other{-2, 1, 1, 1}, white{0.7F, 0.6F, 0.5F, 1};
  gl.Lightfv(GL_LIGHT1, GL_POSITION, position.data());
  gl.Lightfv(GL_LIGHT1, GL_DIFFUSE, white.data());
  gl.Lightfv(GL_LIGHT1, GL_SPECULAR, white.data());
  gl.Lightfv(GL_LIGHT2, GL_POSITION, other.data());
  gl.Lightfv(GL_LIGHT2, GL_AMBIENT, white.data());
  gl.Lightfv(GL_LIGHT2, GL_DIFFUSE, white.data());
  gl.Lightf(GL_LIGHT2, GL_SPOT_CUTOFF, 60);
  gl.Lightf(GL_LIGHT2, GL_SPOT_EXPONENT, 3);
  gl.Lightf(GL_LIGHT2, GL_LINEAR_ATTENUATION, 0.3F);
  gl.Enable(GL_LIGHT1);
  gl.Enable(GL_LIGHT2);
}
void two_sides_and_near_viewer(const GlFunctions& gl) {
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
}
void normalize(const GlFunctions& gl) { gl.Enable(GL_NORMALIZE); }
void rescale(const GlFunctions& gl) {
  gl.Enable(GL_RESCALE_NORMAL);
  gl.Scalef(1.5F, 1.5F, 1.5F);
}
void squeeze(const GlFunctions& gl) { gl.Scalef(1, 0.5F, 1.5F); }
void track_colors(const GlFunctions& gl) {
  gl.ColorMaterial(GL_FRONT, GL_DIFFUSE);
  gl.Enable(GL_COLOR_MATERIAL);
}
void blend_without_lighting(const GlFunctions& gl) {
  gl.Disable(GL_LIGHTING);
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}
void flat(const GlFunctions& gl) { gl.ShadeModel(GL_FLAT); }
void separate_specular(const GlFunctions& gl) {
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
}
void perspective_modelview(const GlFunctions& gl) {
  const std::array<float, 16> m{1, 0, 0, 0, 0, 1, 0, 0.1F, 0, 0, 1, 0, 0, 0, 0, 1};
  gl.MultMatrixf(m.data());
}

// Small objects are lit on the processor where programs may have stand-ins, and by a program
// otherwise.
class SmallObjects : public testing::TestWithParam<legacy_gl_programs> {
 protected:
  SmallObjects() : ours(kSize, kSize, PixelFormat::rgba8, options_with(GetParam())) {}

  static bool lights_here() { return GetParam() == LEGACY_GL_PROGRAMS_GENERAL_FIRST; }

  CoreContext ours;
};

INSTANTIATE_TEST_SUITE_P(Programs, SmallObjects,
                         testing::Values(LEGACY_GL_PROGRAMS_SPECIALISED,
                                         LEGACY_GL_PROGRAMS_GENERAL_FIRST));

TEST_P(SmallObjects, LookAsByMesaUnderEveryState) {
  MesaContext mesa(kSize, kSize);
  constexpr std::array<Change, 10> kStates{
      nothing, lights_with_positions, two_sides_and_near_viewer, normalize, rescale,
      squeeze, track_colors,          blend_without_lighting,    flat,      separate_specular};
  constexpr std::array<Figure, 7> kFigures{draw_list,  draw_strip,  draw_fan,      draw_quads,
                                           draw_lines, draw_points, draw_triangles};
  for (std::size_t state = 0; state < kStates.size(); ++state)
    for (const std::size_t figure : {kFigures.size(), state % kFigures.size()}) {
      const bool over_the_border = figure == kFigures.size();
      const auto by = [&](RenderContext& context) {
        return draw(context, kStates[state],
                    figure < kFigures.size() ? kFigures[figure] : draw_mixed, over_the_border,
                    nothing);
      };
      const Drawing expected = by(mesa), actual = by(ours);
      const std::string name = "objects-" + std::to_string(state) + "-" + std::to_string(figure);
      EXPECT_TRUE(images_match(actual.image, expected.image, {.max_difference_steps = 1}, name));
      EXPECT_EQ(actual.depths, expected.depths) << name;
    }
}

// Drawn one by one, positions come from the vertex shader; in a batch, from the processor.
TEST_P(SmallObjects, LieWhereTheyLieWhenDrawnOneByOne) {
  for (const Change state : {nothing, lights_with_positions, squeeze, perspective_modelview}) {
    const Drawing together = draw(ours, state, draw_mixed, true, nothing);
    const Drawing apart = draw(ours, state, draw_mixed, true, flush);
    EXPECT_EQ(together.depths, apart.depths);
    EXPECT_TRUE(images_match(together.image, apart.image, {.max_difference_steps = 1}, "together"));
  }
}

TEST_P(SmallObjects, OfAListTakeFewDraws) {
  draw(ours, nothing, draw_list, false, nothing);
  const legacy_gl_statistics statistics = statistics_now();
  EXPECT_LE(statistics.batches, 5u);  // the first three are drawn alone, where a program lights
  EXPECT_LE(statistics.draws, 8u);
}

// Lighting many vertices costs more than the draw that it saves.
TEST_P(SmallObjects, OfManyVerticesAreLeftToTheDriver) {
  const auto draws_lit = [&](Figure figure) {
    draw(ours, nothing, figure, false, nothing);
    return statistics_now().draws_lit_on_cpu;
  };
  EXPECT_EQ(draws_lit([](const GlFunctions& gl) { draw_figure(gl, GL_TRIANGLE_STRIP, 64); }),
            lights_here() ? kObjects : 0u);
  EXPECT_EQ(draws_lit([](const GlFunctions& gl) { draw_figure(gl, GL_TRIANGLE_STRIP, 66); }), 0u);
}

TEST_P(SmallObjects, OutsideOfTheViewAreDropped) {
  draw(
      ours, [](const GlFunctions& gl) { gl.Translatef(0, 0, 50); }, draw_list, false, nothing);
  const legacy_gl_statistics statistics = statistics_now();
  EXPECT_GE(statistics.primitives_clipped, kObjects - 2u);
  EXPECT_LE(statistics.vertices, 2 * 15u);
}

TEST_P(SmallObjects, ThatAStateParts) {
  const Change toggle = [](const GlFunctions& gl) {
    gl.Enable(GL_LIGHT3);
    gl.Begin(GL_POINTS);
    gl.End();
    gl.Disable(GL_LIGHT3);
    gl.ShadeModel(GL_FLAT);
    gl.Flush();
    gl.ShadeModel(GL_SMOOTH);
  };
  MesaContext mesa(kSize, kSize);
  const Drawing expected = draw(mesa, nothing, draw_mixed, true, toggle);
  const Drawing actual = draw(ours, nothing, draw_mixed, true, toggle);
  EXPECT_TRUE(images_match(actual.image, expected.image, {.max_difference_steps = 1}, "parted"));
}

TEST_P(SmallObjects, WithVerticesOfOtherW) {
  const Figure figure = [](const GlFunctions& gl) {
    gl.Begin(GL_TRIANGLES);
    gl.Normal3f(0, 0, 1);
    gl.Vertex4f(-0.4F, -0.4F, 0, 2);
    gl.Vertex4f(0.3F, -0.2F, 0, 1.5F);
    gl.Vertex4f(0, 0.2F, 0.1F, 1);
    gl.End();
  };
  const Drawing together = draw(ours, lights_with_positions, figure, false, nothing);
  const Drawing apart = draw(ours, lights_with_positions, figure, false, flush);
  EXPECT_EQ(together.depths, apart.depths);
  EXPECT_TRUE(images_match(together.image, apart.image, {.max_difference_steps = 1}, "other-w"));
}

// Lights and modes that change between objects. The list is called under two-sided lighting too,
// where each triangle takes the colours of the face that is seen.
void set_modes(const GlFunctions& gl, int i, bool two_side) {
  for (unsigned light = 0; light < 3; ++light) {
    if ((i + static_cast<int>(light)) % 3) gl.Enable(GL_LIGHT0 + light);
    else gl.Disable(GL_LIGHT0 + light);
  }
  const std::array<float, 4> scene{0.03F * static_cast<float>(i % 4), 0.05F, 0.1F, 1};
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, scene.data());
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, i % 2);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, two_side && i % 3 == 1);
  gl.FrontFace(i < kObjects / 2 ? GL_CCW : GL_CW);
  if (i % 5 < 2) gl.Enable(GL_NORMALIZE);
  else gl.Disable(GL_NORMALIZE);
  gl.Lightf(GL_LIGHT2, GL_SPOT_EXPONENT, i % 4 == 3 ? 2.5F : static_cast<float>(i % 4));
  gl.Materialf(GL_FRONT, GL_SHININESS, i % 2 ? 7.5F : static_cast<float>(i));
}

Drawing draw_modes(RenderContext& context, Figure figure, bool two_side) {
  static int object;
  static bool both;
  static Figure drawn;
  object = 0;
  both = two_side;
  drawn = figure;
  return draw(
      context, lights_with_positions,
      [](const GlFunctions& gl) {
        set_modes(gl, object++, both);
        drawn(gl);
      },
      false, nothing);
}

TEST_P(SmallObjects, OfLightsAndModesOfTheirOwn) {
  MesaContext mesa(kSize, kSize);
  for (const Figure figure : {draw_list, draw_mixed, draw_quads, draw_strip})
    for (const bool two_side : {false, true}) {
      const Drawing expected = draw_modes(mesa, figure, two_side);
      const Drawing actual = draw_modes(ours, figure, two_side);
      EXPECT_TRUE(images_match(actual.image, expected.image, {.max_difference_steps = 1}, "modes"));
      EXPECT_EQ(actual.depths, expected.depths);
      const legacy_gl_statistics statistics = statistics_now();
      if (!lights_here()) {
        EXPECT_EQ(statistics.draws_lit_on_cpu, 0u);
      } else if (figure == draw_list) {
        EXPECT_EQ(statistics.draws_lit_on_cpu, kObjects + 0u);
        EXPECT_LE(statistics.batches, 3u);
        EXPECT_LE(statistics.programs_compiled, 1u);
      }
    }
}

TEST_P(SmallObjects, WithMaterialsInsideBeginEnd) {
  const Figure figure = [](const GlFunctions& gl) {
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 9; ++i) {
      const std::array<float, 4> color{0.1F * static_cast<float>(i), 0.5F, 0.3F, 1};
      if (i % 2) gl.Materialfv(GL_FRONT, GL_DIFFUSE, color.data());
      vertex(gl, 0.3F * static_cast<float>(i % 2) - 0.15F, 0.1F * static_cast<float>(i / 2) - 0.2F,
             0.1F * static_cast<float>(i % 3));
    }
    gl.End();
  };
  MesaContext mesa(kSize, kSize);
  const Drawing expected = draw(mesa, lights_with_positions, figure, false, draw_strip);
  const Drawing actual = draw(ours, lights_with_positions, figure, false, draw_strip);
  EXPECT_TRUE(images_match(actual.image, expected.image, {.max_difference_steps = 1}, "inside"));
  EXPECT_EQ(actual.depths, expected.depths);
}

// A long primitive in a batch that is lit here is drawn in parts.
TEST_P(SmallObjects, BeforeALongOne) {
  const Figure figure = [](const GlFunctions& gl) {
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 10000; ++i) {
      const std::array<float, 4> color{0.0001F * static_cast<float>(i), 0.5F, 0.3F, 1};
      if (i % 1000 == 1) gl.Materialfv(GL_FRONT, GL_DIFFUSE, color.data());
      vertex(gl, 0.3F * static_cast<float>(i % 2) - 0.15F, 0.0001F * static_cast<float>(i) - 0.2F,
             0.1F * static_cast<float>(i % 3));
    }
    gl.End();
  };
  const auto by = [&](RenderContext& context) {
    context.recreate();
    set_up_scene(context.gl);
    context.gl.MatrixMode(GL_MODELVIEW);
    draw_strip(context.gl);
    context.gl.Rotatef(20, 0, 0, 1);
    figure(context.gl);
    return context.read_rgba8();
  };
  MesaContext mesa(kSize, kSize);
  const Image expected = by(mesa), actual = by(ours);
  EXPECT_TRUE(images_match(actual, expected, {.max_difference_steps = 1}, "long"));
}

}  // namespace
}  // namespace legacy_gl::test
