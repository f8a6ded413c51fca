#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "glu_calls.hpp"

namespace {

using glu_test::Call;
using glu_test::Calls;
using glu_test::calls_of;
using glu_test::expect_same;

struct Settings {
  GLenum normals;
  GLenum draw_style;
  GLenum orientation;
  GLboolean texture;
};

// The two libraries behind one interface, so that every case below is written once.
struct Ours {
  static constexpr auto make = lgluNewQuadric;
  static constexpr auto destroy = lgluDeleteQuadric;
  static constexpr auto normals = lgluQuadricNormals;
  static constexpr auto draw_style = lgluQuadricDrawStyle;
  static constexpr auto orientation = lgluQuadricOrientation;
  static constexpr auto texture = lgluQuadricTexture;
  static constexpr auto callback = lgluQuadricCallback;
  static constexpr auto sphere = lgluSphere;
  static constexpr auto cylinder = lgluCylinder;
  static constexpr auto disk = lgluDisk;
  static constexpr auto partial_disk = lgluPartialDisk;
};

struct LibGlu {
  static constexpr auto make = gluNewQuadric;
  static constexpr auto destroy = gluDeleteQuadric;
  static constexpr auto normals = gluQuadricNormals;
  static constexpr auto draw_style = gluQuadricDrawStyle;
  static constexpr auto orientation = gluQuadricOrientation;
  static constexpr auto texture = gluQuadricTexture;
  static constexpr auto callback = gluQuadricCallback;
  static constexpr auto sphere = gluSphere;
  static constexpr auto cylinder = gluCylinder;
  static constexpr auto disk = gluDisk;
  static constexpr auto partial_disk = gluPartialDisk;
};

// Errors are recorded among the calls, as the callback sees them.
Calls* error_log = nullptr;

void record_error(GLenum error) { error_log->push_back({"error", {static_cast<double>(error)}}); }

template <typename Library, typename Draw>
Calls calls_with(const Settings& settings, const Draw& draw) {
  Calls errors;
  error_log = &errors;
  GLUquadric* const quadric = Library::make();
  Library::callback(quadric, GLU_ERROR, reinterpret_cast<_GLUfuncptr>(record_error));
  Library::normals(quadric, settings.normals);
  Library::draw_style(quadric, settings.draw_style);
  Library::orientation(quadric, settings.orientation);
  Library::texture(quadric, settings.texture);
  Calls calls = calls_of([&] { draw(Library{}, quadric); });
  Library::destroy(quadric);
  calls.insert(calls.end(), errors.begin(), errors.end());
  return calls;
}

// libGLU takes the normal of a sphere's lower pole from the slice with the number of the stack,
// which may be none; x and y are some float of the size of sin(float(pi)) instead of 0.
void round_pole_normals(Calls& calls) {
  for (Call& call : calls) {
    if (call.name == "Normal3f" && std::abs(call.arguments[2]) == 1.0) {
      for (double& component : call.arguments) {
        component = std::abs(component) < 2e-7 ? 0.0 : component;
      }
    }
  }
}

void remove_normals(Calls& calls) {
  std::erase_if(calls, [](const Call& call) { return call.name == "Normal3f"; });
}

class GluQuadric : public testing::TestWithParam<std::tuple<GLenum, GLenum, GLenum, GLboolean>> {
 protected:
  template <typename Draw>
  void expect_lib_glus(const Draw& draw) const {
    const auto [normals, draw_style, orientation, texture] = GetParam();
    const Settings settings{normals, draw_style, orientation, texture};
    Calls ours = calls_with<Ours>(settings, draw);
    Calls theirs = calls_with<LibGlu>(settings, draw);
    ASSERT_FALSE(ours.empty());
    round_pole_normals(ours);
    round_pole_normals(theirs);
    if (normals == GLU_FLAT && (draw_style == GLU_POINT || draw_style == GLU_SILHOUETTE)) {
      // libGLU reads uninitialised memory for these normals.
      ASSERT_EQ(ours.size(), theirs.size());
      remove_normals(ours);
      remove_normals(theirs);
    }
    expect_same(ours, theirs);
  }
};

struct Segments {
  int slices;
  int stacks;
};

// The smallest counts, ordinary ones, and those at and beyond libGLU's limit.
constexpr Segments segment_counts[] = {{2, 1},  {2, 7},   {3, 2},   {4, 3},   {16, 1},
                                       {31, 7}, {17, 30}, {239, 2}, {300, 3}, {3, 300}};

TEST_P(GluQuadric, SphereIsLibGlus) {
  for (const Segments& count : segment_counts) {
    expect_lib_glus([&](auto glu, GLUquadric* quadric) {
      glu.sphere(quadric, 1.7, count.slices, count.stacks);
    });
  }
  expect_lib_glus([](auto glu, GLUquadric* quadric) { glu.sphere(quadric, 0.0, 5, 4); });
}

TEST_P(GluQuadric, CylinderIsLibGlus) {
  for (const Segments& count : segment_counts) {
    for (const double top : {0.0, 0.3, 1.0, 1.7}) {
      expect_lib_glus([&](auto glu, GLUquadric* quadric) {
        glu.cylinder(quadric, 1.0, top, 2.3, count.slices, count.stacks);
      });
    }
  }
  expect_lib_glus([](auto glu, GLUquadric* quadric) { glu.cylinder(quadric, 1.3, 0.1, 0, 5, 4); });
}

TEST_P(GluQuadric, DiskIsLibGlus) {
  for (const Segments& count : segment_counts) {
    for (const double inner : {0.0, 0.3, 1.7}) {
      expect_lib_glus([&](auto glu, GLUquadric* quadric) {
        glu.disk(quadric, inner, 1.7, count.slices, count.stacks);
      });
    }
  }
}

TEST_P(GluQuadric, PartialDiskIsLibGlus) {
  for (const double sweep : {0.0, 30.0, 200.0, 360.0, 400.0, -90.0, -360.0, -400.0}) {
    for (const double inner : {0.0, 0.3, 1.7}) {
      for (const int slices : {2, 5, 17}) {
        expect_lib_glus([&](auto glu, GLUquadric* quadric) {
          glu.partial_disk(quadric, inner, 1.7, slices, 3, 33.0, sweep);
        });
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Settings, GluQuadric,
    testing::Combine(testing::Values(GLU_SMOOTH, GLU_FLAT, GLU_NONE),
                     testing::Values(GLU_FILL, GLU_LINE, GLU_SILHOUETTE, GLU_POINT),
                     testing::Values(GLU_OUTSIDE, GLU_INSIDE),
                     testing::Values(GLboolean{GL_FALSE}, GLboolean{GL_TRUE})));

constexpr Settings defaults{GLU_SMOOTH, GLU_FILL, GLU_OUTSIDE, GL_FALSE};

template <typename Draw>
void expect_same_errors(const Draw& draw) {
  const Calls ours = calls_with<Ours>(defaults, draw);
  expect_same(ours, calls_with<LibGlu>(defaults, draw));
  ASSERT_EQ(ours.size(), 1U) << "one error and nothing drawn";
  EXPECT_EQ(ours[0].name, "error");
}

TEST(GluQuadricErrors, ArgumentsOfSphere) {
  struct Case {
    double radius;
    int slices, stacks;
  };
  for (const Case& c : {Case{-1, 4, 4}, {1, 1, 4}, {1, 4, 0}}) {
    expect_same_errors(
        [&](auto glu, GLUquadric* quadric) { glu.sphere(quadric, c.radius, c.slices, c.stacks); });
  }
}

TEST(GluQuadricErrors, ArgumentsOfCylinder) {
  struct Case {
    double base, top, height;
    int slices, stacks;
  };
  for (const Case& c : {Case{-1, 1, 1, 4, 4},
                        {1, -1, 1, 4, 4},
                        {1, 1, -1, 4, 4},
                        {1, 1, 1, 1, 4},
                        {1, 1, 1, 4, 0},
                        {1, 1, 0, 4, 4}}) {
    expect_same_errors([&](auto glu, GLUquadric* quadric) {
      glu.cylinder(quadric, c.base, c.top, c.height, c.slices, c.stacks);
    });
  }
}

TEST(GluQuadricErrors, ArgumentsOfDisks) {
  struct Case {
    double inner, outer;
    int slices, loops;
  };
  for (const Case& c :
       {Case{-1, 1, 4, 4}, {0, 0, 4, 4}, {2, 1, 4, 4}, {0, 1, 1, 4}, {0, 1, 4, 0}}) {
    expect_same_errors([&](auto glu, GLUquadric* quadric) {
      glu.disk(quadric, c.inner, c.outer, c.slices, c.loops);
    });
    expect_same_errors([&](auto glu, GLUquadric* quadric) {
      glu.partial_disk(quadric, c.inner, c.outer, c.slices, c.loops, 0.0, 90.0);
    });
  }
}

TEST(GluQuadricErrors, EnumsOfSetters) {
  expect_same_errors([](auto glu, GLUquadric* quadric) { glu.normals(quadric, GLU_FILL); });
  expect_same_errors([](auto glu, GLUquadric* quadric) { glu.draw_style(quadric, GLU_FLAT); });
  expect_same_errors([](auto glu, GLUquadric* quadric) { glu.orientation(quadric, GLU_FLAT); });
  expect_same_errors(
      [](auto glu, GLUquadric* quadric) { glu.callback(quadric, GLU_POINT, nullptr); });
}

TEST(GluQuadricErrors, WrongEnumChangesNothing) {
  const auto draw_after_errors = [](auto glu, GLUquadric* quadric) {
    glu.callback(quadric, GLU_ERROR, nullptr);
    glu.normals(quadric, GLU_FILL);
    glu.draw_style(quadric, GLU_FLAT);
    glu.orientation(quadric, GLU_FLAT);
    glu.sphere(quadric, 1.0, 5, 4);
  };
  const auto draw = [](auto glu, GLUquadric* quadric) { glu.sphere(quadric, 1.0, 5, 4); };
  expect_same(calls_with<Ours>(defaults, draw_after_errors), calls_with<Ours>(defaults, draw));
}

TEST(GluQuadricErrors, WithoutCallbackNothingHappens) {
  GLUquadric* const quadric = lgluNewQuadric();
  EXPECT_TRUE(calls_of([&] { lgluSphere(quadric, -1.0, 4, 4); }).empty());
  lgluDeleteQuadric(quadric);
  lgluDeleteQuadric(nullptr);
}

}  // namespace
