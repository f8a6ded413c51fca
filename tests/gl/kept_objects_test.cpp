// Small objects that come again as they were are not lit again, and batches of them are drawn from
// the driver's memory. The picture is that of a context that draws for the first time, and Mesa's.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <vector>

#include "scene_changes.hpp"
#include "support/contexts.hpp"
#include "support/image_matcher.hpp"
#include "support/library.hpp"

namespace legacy_gl::test {
namespace {

constexpr int kSize = 64;
constexpr int kObjects = 40;
constexpr int kFramesUntilKept = 5;
enum List : GLuint { kCube = 1, kWedge };

// A strip around a cube whose corners at +z are moved by `bend`.
void draw_cube(const GlFunctions& gl, float bend) {
  gl.Begin(GL_TRIANGLE_STRIP);
  for (const int i : {3, 2, 7, 6, 4, 2, 0, 3, 1, 7, 5, 4, 1, 0}) {
    const auto side = [i](int axis) { return i >> axis & 1 ? 1.0F : -1.0F; };
    gl.Normal3f(0.6F * side(0), 0.48F * side(1), 0.64F * side(2));
    gl.Vertex3f(side(0) + (side(2) > 0 ? bend : 0), side(1), side(2));
  }
  gl.End();
}

void compile(const GlFunctions& gl, GLuint list, float bend) {
  gl.NewList(list, GL_COMPILE);
  draw_cube(gl, bend);
  gl.EndList();
}

struct Object {
  float x = 0, y = 0, degrees = 0, red = 0;
  GLuint list = kCube;  // 0: by Begin/End
};

std::vector<Object> objects(unsigned seed) {
  std::minstd_rand random(seed);
  const auto between = [&random](float low, float high) {
    return low + (high - low) * static_cast<float>(random() % 10007) / 10006.0F;
  };
  std::vector<Object> objects(kObjects);
  for (Object& object : objects)
    object = {between(-1.8F, 1.8F), between(-1.8F, 1.8F), between(0, 360), between(0, 1),
              static_cast<GLuint>(random() >> 8) % 3};
  return objects;
}

void draw_object(const GlFunctions& gl, const Object& object) {
  const std::array<float, 4> color{object.red, 0.5F, 1 - object.red, 1};
  gl.PushMatrix();
  gl.Translatef(object.x, object.y, 0);
  gl.Rotatef(object.degrees, 0.3F, 0.5F, 0.8F);
  gl.Scalef(0.2F, 0.2F, 0.2F);
  gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, color.data());
  if (object.list) gl.CallList(object.list);
  else draw_cube(gl, 0.4F);
  gl.PopMatrix();
}

void draw_frame(const GlFunctions& gl, const std::vector<Object>& objects) {
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (const Object& object : objects) draw_object(gl, object);
}

void set_up(const GlFunctions& gl) {
  set_up_scene(gl);
  compile(gl, kCube, 0);
  compile(gl, kWedge, 1.5F);
}

using Order = std::vector<std::size_t>;

Image drawn_once(const Order& changes) {
  CoreContext context(kSize, kSize, PixelFormat::rgba8,
                      options_with(LEGACY_GL_PROGRAMS_GENERAL_FIRST));
  set_up(context.gl);
  for (const std::size_t i : changes) scene_changes()[i].apply(context.gl);
  draw_frame(context.gl, objects(1));
  return context.read_rgba8();
}

// Normals of a kept mesh are known to be unit vectors, those of Begin/End are normalised: rounding
// may differ.
TEST(KeptObjects, AnyChangeOfStateIsSeen) {
  std::mt19937 random(5);
  for (int round = 0; round < 2; ++round) {
    Order order(scene_changes().size());
    std::iota(order.begin(), order.end(), 0);
    if (round) std::shuffle(order.begin(), order.end(), random);
    CoreContext context(kSize, kSize, PixelFormat::rgba8,
                        options_with(LEGACY_GL_PROGRAMS_GENERAL_FIRST));
    set_up(context.gl);
    Order so_far;
    for (const std::size_t i : order) {
      scene_changes()[i].apply(context.gl);
      so_far.push_back(i);
      const Image expected = drawn_once(so_far);
      context.make_current();
      for (int frame = 1; frame <= kFramesUntilKept; ++frame) {
        draw_frame(context.gl, objects(1));
        ASSERT_TRUE(
            images_match(context.read_rgba8(), expected, {.max_difference_steps = 1}, "kept"))
            << "round " << round << ", frame " << frame << " after " << scene_changes()[i].name;
      }
    }
    ASSERT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR});
  }
}

class KeptObjectsBesideMesa : public testing::Test {
 protected:
  KeptObjectsBesideMesa()
      : mesa(kSize, kSize),
        ours(kSize, kSize, PixelFormat::rgba8, options_with(LEGACY_GL_PROGRAMS_GENERAL_FIRST)) {
    for (RenderContext* context : contexts()) {
      context->make_current();
      set_up(context->gl);
    }
  }

  std::array<RenderContext*, 2> contexts() { return {&mesa, &ours}; }

  template <typename Draw>
  legacy_gl_statistics frame(Draw draw) {
    std::array<Image, 2> images;
    for (std::size_t i = 0; i < 2; ++i) {
      contexts()[i]->make_current();
      if (i == 1) legacy_gl_reset_statistics();
      draw(contexts()[i]->gl);
      images[i] = contexts()[i]->read_rgba8();
    }
    EXPECT_TRUE(images_match(images[1], images[0], {.max_difference_steps = 1}, "kept"));
    return statistics_now();
  }
  legacy_gl_statistics frame(const std::vector<Object>& objects) {
    return frame([&objects](const GlFunctions& gl) { draw_frame(gl, objects); });
  }

  MesaContext mesa;
  CoreContext ours;
};

TEST_F(KeptObjectsBesideMesa, AreDrawnFromTheDriversMemory) {
  for (int i = 0; i < kFramesUntilKept; ++i) frame(objects(2));
  const legacy_gl_statistics kept = frame(objects(2));
  EXPECT_EQ(kept.objects_kept, kept.objects_lit);
  EXPECT_GT(kept.objects_kept, kObjects * 3 / 4u);
  EXPECT_EQ(kept.vertex_bytes_uploaded, 0u);
  EXPECT_EQ(kept.index_bytes_uploaded, 0u);
  EXPECT_EQ(kept.normal_matrix_updates, 0u);
}

TEST_F(KeptObjectsBesideMesa, OneThatMovesIsLitAnew) {
  std::vector<Object> all = objects(3);
  for (const std::size_t moving : {std::size_t{0}, std::size_t{kObjects / 2}, all.size() - 1}) {
    for (int i = 0; i < kFramesUntilKept; ++i) frame(all);
    for (int i = 0; i < 4; ++i) {
      SCOPED_TRACE(moving);
      all[moving].degrees += 20;
      const legacy_gl_statistics drawn = frame(all);
      EXPECT_GE(drawn.objects_kept + 1, drawn.objects_lit);
      EXPECT_GT(drawn.objects_kept, kObjects * 3 / 4u);
    }
  }
}

TEST_F(KeptObjectsBesideMesa, TheirOrderMayChangeInAnyWay) {
  std::mt19937 random(4);
  std::vector<Object> all = objects(4);
  for (int change = 0; change < 40; ++change) {
    SCOPED_TRACE(change);
    for (int i = 0; i < (change % 4 ? 1 : kFramesUntilKept); ++i) frame(all);
    const std::size_t at = random() % all.size(), other = random() % all.size();
    switch (random() % 5) {
      case 0: std::swap(all[at], all[other]); break;
      case 1: all[at].red = 1 - all[at].red; break;
      case 2: all.erase(all.begin() + static_cast<std::ptrdiff_t>(at)); break;
      case 3:
        all.insert(all.begin() + static_cast<std::ptrdiff_t>(at), objects(99)[other % 40]);
        break;
      default: all[at].list = (all[at].list + 1) % 3;
    }
    frame(all);
  }
}

TEST_F(KeptObjectsBesideMesa, OthersMayComeBetween) {
  const std::vector<Object> all = objects(5);
  using Between = void (*)(const GlFunctions& gl);
  constexpr std::array<Between, 6> kBetween{
      [](const GlFunctions& gl) { gl.Flush(); },
      [](const GlFunctions& gl) { gl.Clear(GL_DEPTH_BUFFER_BIT); },
      [](const GlFunctions& gl) {
        gl.Begin(GL_TRIANGLES);
        gl.Vertex3f(-1, -1, 0);
        gl.Vertex3f(1, -1, 0.5F);
        gl.Vertex3f(0, 1, 0);
        gl.End();
      },
      [](const GlFunctions& gl) {
        gl.Disable(GL_LIGHTING);
        gl.Color3f(0.2F, 0.9F, 0.4F);
        gl.Begin(GL_LINES);
        gl.Vertex3f(-1, -1, 0);
        gl.Vertex3f(1, 1, 0);
        gl.End();
        gl.Enable(GL_LIGHTING);
      },
      [](const GlFunctions& gl) {
        static const std::array<float, 9> kCorners{-1, -1, 0, 1, -1, 0, 0, 1, 0};
        gl.EnableClientState(GL_VERTEX_ARRAY);
        gl.VertexPointer(3, GL_FLOAT, 0, kCorners.data());
        gl.DrawArrays(GL_TRIANGLES, 0, 3);
        gl.DisableClientState(GL_VERTEX_ARRAY);
      },
      [](const GlFunctions& gl) { gl.CullFace(GL_FRONT); },
  };
  for (std::size_t what = 0; what < kBetween.size(); ++what)
    for (const std::size_t where : std::initializer_list<std::size_t>{1, 20, 39}) {
      SCOPED_TRACE(testing::Message() << what << " before object " << where);
      const auto draw = [&](bool between) {
        return frame([&](const GlFunctions& gl) {
          gl.CullFace(GL_BACK);
          gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
          for (std::size_t i = 0; i < all.size(); ++i) {
            if (between && i == where) kBetween[what](gl);
            draw_object(gl, all[i]);
          }
        });
      };
      for (int i = 0; i < kFramesUntilKept; ++i) draw(false);
      draw(true);
      draw(true);
      draw(false);
    }
}

// Each object's matrix is the last one's, changed in the same way.
TEST_F(KeptObjectsBesideMesa, TheirMatricesMayBuildUp) {
  for (int i = 0; i < 2 * kFramesUntilKept; ++i)
    frame([](const GlFunctions& gl) {
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      gl.LoadIdentity();
      gl.Translatef(1.2F, 0, -4);
      for (int object = 0; object < 24; ++object) {
        gl.Rotatef(15, 0, 0, 1);
        gl.Translatef(0.3F, 0, 0.02F);
        gl.Scalef(0.2F, 0.2F, 0.2F);
        gl.CallList(kCube);
        gl.Scalef(5, 5, 5);
      }
    });
}

TEST_F(KeptObjectsBesideMesa, ListsMayBeCompiledAnew) {
  for (const float bend : {0.0F, 1.5F, -0.5F, 0.0F, 0.7F}) {
    for (RenderContext* context : contexts()) {
      context->make_current();
      context->gl.DeleteLists(kCube, 1);
      compile(context->gl, kCube, bend);
    }
    for (int i = 0; i < kFramesUntilKept; ++i) frame(objects(6));
  }
}

// What others hide is counted too.
TEST_F(KeptObjectsBesideMesa, AQueryCountsAllTheirSamples) {
  for (int i = 0; i < kFramesUntilKept; ++i) frame(objects(7));
  std::array<GLuint, 2> samples{};
  for (std::size_t i = 0; i < 2; ++i) {
    contexts()[i]->make_current();
    const GlFunctions& gl = contexts()[i]->gl;
    GLuint query = 0;
    gl.GenQueries(1, &query);
    gl.Disable(GL_DEPTH_TEST);
    gl.BeginQuery(GL_SAMPLES_PASSED, query);
    draw_frame(gl, objects(7));
    gl.EndQuery(GL_SAMPLES_PASSED);
    gl.Enable(GL_DEPTH_TEST);
    gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &samples[i]);
    gl.DeleteQueries(1, &query);
  }
  EXPECT_EQ(samples[1], samples[0]);
  frame(objects(7));
}

// More than there is room for: some are given up, all are drawn.
TEST_F(KeptObjectsBesideMesa, TheirNumberHasNoLimit) {
  std::vector<Object> many;
  for (unsigned seed = 100; many.size() < 24000; ++seed)
    for (const Object& object : objects(seed)) many.push_back(object);
  legacy_gl_statistics drawn{};
  for (int i = 0; i < kFramesUntilKept; ++i) drawn = frame(many);
  EXPECT_GT(drawn.objects_kept, 1000u);
  EXPECT_GT(drawn.objects_lit, 20000u);
}

}  // namespace
}  // namespace legacy_gl::test
