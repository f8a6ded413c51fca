#include "glu_calls.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using glu_test::calls_of;
using glu_test::expect_same;

// --- Matrices ------------------------------------------------------------------------------------

TEST(GluMatrix, PerspectiveIsLibGlus) {
  for (const double fov : {0.0, 1e-3, 30.0, 45.0, 60.0, 90.0, 179.0, 180.0, 360.0, -60.0}) {
    for (const double aspect : {1.0, 4.0 / 3.0, 0.1, 0.0, -1.0}) {
      for (const double far : {0.1, 10.0, 1e6}) {
        expect_same(calls_of([&] { lgluPerspective(fov, aspect, 0.1, far); }),
                    calls_of([&] { gluPerspective(fov, aspect, 0.1, far); }));
      }
    }
  }
}

TEST(GluMatrix, LookAtIsLibGlus) {
  for (const double x : {0.0, 1.0, -3.7, 1e6}) {
    for (const double up : {0.0, 1.0, 0.3, -1e-3}) {
      expect_same(calls_of([&] { lgluLookAt(x, 2, 3, 4, 5, 0.1, up, 1, 0.2); }),
                  calls_of([&] { gluLookAt(x, 2, 3, 4, 5, 0.1, up, 1, 0.2); }));
    }
  }
}

TEST(GluMatrix, LookAtWithoutADirectionIsLibGlus) {
  expect_same(calls_of([] { lgluLookAt(1, 2, 3, 1, 2, 3, 0, 1, 0); }),
              calls_of([] { gluLookAt(1, 2, 3, 1, 2, 3, 0, 1, 0); }));
  expect_same(calls_of([] { lgluLookAt(0, 0, 0, 0, 1, 0, 0, 1, 0); }),
              calls_of([] { gluLookAt(0, 0, 0, 0, 1, 0, 0, 1, 0); }));
}

TEST(GluMatrix, Ortho2DIsLibGlus) {
  expect_same(calls_of([] { lgluOrtho2D(-1, 2, -3, 4); }),
              calls_of([] { gluOrtho2D(-1, 2, -3, 4); }));
}

TEST(GluMatrix, PickMatrixIsLibGlus) {
  GLint viewport[4] = {3, 5, 640, 481};
  for (const double width : {-1.0, 0.0, 0.3, 5.0, 700.0}) {
    expect_same(calls_of([&] { lgluPickMatrix(100.3, 20.7, width, 3.3, viewport); }),
                calls_of([&] { gluPickMatrix(100.3, 20.7, width, 3.3, viewport); }));
  }
}

// --- Projection of points
// --------------------------------------------------------------------------

struct Projection {
  GLdouble modelview[16] = {0.8, 0.1, -0.5, 0, -0.2, 1.1, 0.3, 0, 0.6, 0.2, 0.7, 0, 1, -2, -9, 1};
  GLdouble projection[16] = {1.2, 0, 0, 0, 0, 1.7, 0, 0, 0, 0, -1.02, -1, 0, 0, -0.2, 0};
  GLint viewport[4] = {10, 20, 300, 200};
};

// Both sides round a few dozen double operations, in different orders; the inverse's condition
// number is about 1e3.
constexpr double rounding = 1e-11;

TEST(GluProject, WindowCoordinatesAreLibGlus) {
  const Projection p;
  GLdouble ours[3] = {};
  GLdouble theirs[3] = {};
  EXPECT_EQ(lgluProject(0.3, -0.4, 0.5, p.modelview, p.projection, p.viewport, &ours[0], &ours[1],
                        &ours[2]),
            GLU_TRUE);
  EXPECT_EQ(gluProject(0.3, -0.4, 0.5, p.modelview, p.projection, p.viewport, &theirs[0],
                       &theirs[1], &theirs[2]),
            GLU_TRUE);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(ours[i], theirs[i], rounding * std::abs(theirs[i]));
  }
}

TEST(GluProject, UnProjectFindsTheObjectCoordinatesAgain) {
  const Projection p;
  GLdouble window[3] = {};
  GLdouble object[3] = {};
  ASSERT_EQ(lgluProject(0.3, -0.4, 0.5, p.modelview, p.projection, p.viewport, &window[0],
                        &window[1], &window[2]),
            GLU_TRUE);
  ASSERT_EQ(lgluUnProject(window[0], window[1], window[2], p.modelview, p.projection, p.viewport,
                          &object[0], &object[1], &object[2]),
            GLU_TRUE);
  EXPECT_NEAR(object[0], 0.3, rounding);
  EXPECT_NEAR(object[1], -0.4, rounding);
  EXPECT_NEAR(object[2], 0.5, rounding);
}

TEST(GluProject, UnProject4IsLibGlus) {
  const Projection p;
  GLdouble ours[4] = {};
  GLdouble theirs[4] = {};
  EXPECT_EQ(lgluUnProject4(50, 60, 0.4, 2.0, p.modelview, p.projection, p.viewport, 0.25, 0.75,
                           &ours[0], &ours[1], &ours[2], &ours[3]),
            GLU_TRUE);
  EXPECT_EQ(gluUnProject4(50, 60, 0.4, 2.0, p.modelview, p.projection, p.viewport, 0.25, 0.75,
                          &theirs[0], &theirs[1], &theirs[2], &theirs[3]),
            GLU_TRUE);
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(ours[i], theirs[i], rounding * std::abs(theirs[i]));
  }
}

TEST(GluProject, FailureWritesNothing) {
  const Projection p;
  const GLdouble zero[16] = {};
  GLdouble out[4] = {7, 7, 7, 7};
  EXPECT_EQ(lgluProject(1, 2, 3, p.modelview, zero, p.viewport, &out[0], &out[1], &out[2]),
            GLU_FALSE);
  EXPECT_EQ(lgluUnProject(1, 2, 3, p.modelview, zero, p.viewport, &out[0], &out[1], &out[2]),
            GLU_FALSE);
  EXPECT_EQ(lgluUnProject4(1, 2, 3, 1, p.modelview, zero, p.viewport, 0, 1, &out[0], &out[1],
                           &out[2], &out[3]),
            GLU_FALSE);
  for (const GLdouble value : out) {
    EXPECT_EQ(value, 7.0);
  }
}

// --- Strings
// ---------------------------------------------------------------------------------------

TEST(GluStrings, ErrorTextsAreLibGlus) {
  for (const GLenum error : {0U, 0x0500U, 0x0501U, 0x0502U, 0x0503U, 0x0504U, 0x0505U, 0x0506U,
                             0x0507U, 0x8031U, 100900U, 100901U, 100902U, 100903U, 100904U, 7U}) {
    EXPECT_STREQ(reinterpret_cast<const char*>(lgluErrorString(error)),
                 reinterpret_cast<const char*>(gluErrorString(error)));
  }
}

TEST(GluStrings, Version) {
  EXPECT_STREQ(reinterpret_cast<const char*>(lgluGetString(GLU_VERSION)), "1.3");
  EXPECT_STREQ(reinterpret_cast<const char*>(lgluGetString(GLU_EXTENSIONS)), "");
  EXPECT_EQ(lgluGetString(GL_VERSION), nullptr);
}

}  // namespace
