// GLU in a context: the matrices it leaves behind and the pictures it draws, against libGLU on
// Mesa's fixed function. (tests/unit/glu_test.cpp compares the calls one by one.)
//
// libGLU calls gl* by name; this program is linked with OSMesa before libGLU, so that these are the
// functions of the MesaContext that is current.
#define LEGACY_GL_NO_NAMES
#include <GL/glu.h>
#include <gtest/gtest.h>
#include <legacy_gl/glu.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <tuple>

#include "support/contexts.hpp"
#include "support/image_matcher.hpp"

namespace {

using legacy_gl::test::CoreContext;
using legacy_gl::test::Image;
using legacy_gl::test::images_match;
using legacy_gl::test::MesaContext;
using legacy_gl::test::RenderContext;

constexpr int size = 128;

// One GLU: libGLU, which draws with the gl* names, or ours, which draws with the lgl* names.
struct Glu {
  decltype(&gluPerspective) perspective;
  decltype(&gluLookAt) look_at;
  decltype(&gluOrtho2D) ortho_2d;
  decltype(&gluPickMatrix) pick_matrix;
  decltype(&gluNewQuadric) new_quadric;
  decltype(&gluDeleteQuadric) delete_quadric;
  decltype(&gluQuadricNormals) normals;
  decltype(&gluQuadricDrawStyle) draw_style;
  decltype(&gluQuadricOrientation) orientation;
  decltype(&gluSphere) sphere;
  decltype(&gluCylinder) cylinder;
  decltype(&gluDisk) disk;
  decltype(&gluPartialDisk) partial_disk;
};

constexpr Glu lib_glu = {
    gluPerspective,   gluLookAt,         gluOrtho2D,          gluPickMatrix,         gluNewQuadric,
    gluDeleteQuadric, gluQuadricNormals, gluQuadricDrawStyle, gluQuadricOrientation, gluSphere,
    gluCylinder,      gluDisk,           gluPartialDisk};
constexpr Glu our_glu = {lgluPerspective,    lgluLookAt,           lgluOrtho2D,
                         lgluPickMatrix,     lgluNewQuadric,       lgluDeleteQuadric,
                         lgluQuadricNormals, lgluQuadricDrawStyle, lgluQuadricOrientation,
                         lgluSphere,         lgluCylinder,         lgluDisk,
                         lgluPartialDisk};

using Scene = std::function<void(const Glu& glu, const GlFunctions& gl)>;

// --- Matrices ------------------------------------------------------------------------------------

using Matrix = std::array<GLfloat, 16>;

Matrix projection_after(RenderContext& context, const Glu& glu, const Scene& scene) {
  context.make_current();
  context.gl.MatrixMode(GL_PROJECTION);
  scene(glu, context.gl);
  Matrix matrix = {};
  context.gl.GetFloatv(GL_PROJECTION_MATRIX, matrix.data());
  return matrix;
}

// tolerance_ulps: in units of the last place of the matrix's largest element.
void expect_same_matrix(const Scene& scene, float tolerance_ulps) {
  MesaContext mesa(size, size);
  const Matrix theirs = projection_after(mesa, lib_glu, scene);
  CoreContext core(size, size);
  const Matrix ours = projection_after(core, our_glu, scene);
  float largest = 0.0F;
  for (const float element : theirs) {
    largest = std::max(largest, std::abs(element));
  }
  ASSERT_GT(largest, 0.0F);
  const float tolerance = tolerance_ulps * largest * std::numeric_limits<float>::epsilon();
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_NEAR(ours[i], theirs[i], tolerance) << "element " << i;
  }
}

TEST(GluSetAndGet, PerspectiveIsTheSameFloatMatrix) {
  expect_same_matrix(
      [](const Glu& glu, const GlFunctions&) { glu.perspective(47.3, 1.7, 0.3, 70); }, 0.0F);
}

TEST(GluSetAndGet, Ortho2DIsTheSameFloatMatrix) {
  expect_same_matrix([](const Glu& glu, const GlFunctions&) { glu.ortho_2d(-1.3, 2.7, -0.4, 5); },
                     0.0F);
}

// Mesa multiplies matrices in float, one rounding for each product and sum of a chain of two.
TEST(GluSetAndGet, LookAtIsLibGlus) {
  expect_same_matrix(
      [](const Glu& glu, const GlFunctions&) { glu.look_at(1, 2, 3, -0.3, 0.2, -1, 0.1, 1, 0.2); },
      2.0F);
}

TEST(GluSetAndGet, PickMatrixIsLibGlus) {
  expect_same_matrix(
      [](const Glu& glu, const GlFunctions&) {
        GLint viewport[4] = {3, 4, 111, 95};
        glu.pick_matrix(40.5, 30.25, 5, 3, viewport);
        glu.perspective(60, 1, 1, 10);
      },
      2.0F);
}

// --- Pictures ------------------------------------------------------------------------------------

Image picture_of(RenderContext& context, const Glu& glu, const Scene& scene) {
  context.make_current();
  const GlFunctions& gl = context.gl;
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.MatrixMode(GL_PROJECTION);
  glu.perspective(40, 1, 1, 20);
  gl.MatrixMode(GL_MODELVIEW);
  glu.look_at(0.5, -3.1, 3.7, 0, 0, 0.2, 0, 0, 1);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  // A flat quadric leaves the first vertices of a sphere without a normal of their own.
  gl.Normal3f(0, 0, 1);
  scene(glu, gl);
  gl.Finish();
  return context.read_rgba8();
}

void expect_same_picture(const Scene& scene, const std::string& name) {
  MesaContext mesa(size, size);
  const Image theirs = picture_of(mesa, lib_glu, scene);
  CoreContext core(size, size);
  const Image ours = picture_of(core, our_glu, scene);
  ASSERT_GT(covered_pixels(theirs), 50);
  // One step: equal colours on either side of a rounding.
  EXPECT_TRUE(images_match(ours, theirs, {.max_difference_steps = 1.0F}, "glu-" + name));
}

using Settings = std::tuple<GLenum, GLenum, GLenum>;

class GluRenders : public testing::TestWithParam<Settings> {
 protected:
  void expect_same(const std::function<void(const Glu&, GLUquadric*)>& draw,
                   const std::string& shape) const {
    const auto [normals, draw_style, orientation] = GetParam();
    const std::string name = shape + "-" + std::to_string(normals) + "-" +
                             std::to_string(draw_style) + "-" + std::to_string(orientation);
    const Settings settings = GetParam();
    expect_same_picture(
        [&settings, &draw](const Glu& glu, const GlFunctions&) {
          GLUquadric* const quadric = glu.new_quadric();
          glu.normals(quadric, std::get<0>(settings));
          glu.draw_style(quadric, std::get<1>(settings));
          glu.orientation(quadric, std::get<2>(settings));
          draw(glu, quadric);
          glu.delete_quadric(quadric);
        },
        name);
  }
};

TEST_P(GluRenders, Sphere) {
  expect_same([](const Glu& glu, GLUquadric* quadric) { glu.sphere(quadric, 1.1, 20, 12); },
              "sphere");
}

TEST_P(GluRenders, Cylinder) {
  expect_same(
      [](const Glu& glu, GLUquadric* quadric) { glu.cylinder(quadric, 1.1, 0.4, 1.3, 20, 6); },
      "cylinder");
}

TEST_P(GluRenders, Disk) {
  expect_same([](const Glu& glu, GLUquadric* quadric) { glu.disk(quadric, 0.4, 1.3, 20, 5); },
              "disk");
}

TEST_P(GluRenders, PartialDisk) {
  expect_same([](const Glu& glu,
                 GLUquadric* quadric) { glu.partial_disk(quadric, 0.0, 1.3, 20, 5, 30, 250); },
              "partial-disk");
}

INSTANTIATE_TEST_SUITE_P(Filled, GluRenders,
                         testing::Combine(testing::Values(GLU_SMOOTH, GLU_FLAT, GLU_NONE),
                                          testing::Values(GLU_FILL),
                                          testing::Values(GLU_OUTSIDE, GLU_INSIDE)));

// Not GLU_POINT: where a point falls between two pixels, Mesa's core profile (points are sprites)
// takes the lower one and its fixed function the upper one, whoever draws it.
INSTANTIATE_TEST_SUITE_P(Lines, GluRenders,
                         testing::Combine(testing::Values(GLU_SMOOTH),
                                          testing::Values(GLU_LINE, GLU_SILHOUETTE),
                                          testing::Values(GLU_OUTSIDE)));

}  // namespace
