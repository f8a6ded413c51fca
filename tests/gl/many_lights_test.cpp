// More than eight lights: those that do not reach a draw are left out of it, and nobody sees it.
// Draws from buffer objects, whose bounds are not known, take all of them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "support/contexts.hpp"
#include "support/library.hpp"

namespace legacy_gl::test {
namespace {

constexpr int kSize = 48;
constexpr unsigned kLights = 64;
constexpr unsigned kObjects = 12;
// Each light that is left out may take 1/1024 of a step; the rest is float32's.
constexpr float kToleranceSteps = static_cast<float>(kLights) / 1024 + 0.02F;

using Vector = std::array<float, 4>;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  float between(float low, float high) {
    return low + (high - low) * static_cast<float>(engine_() % 100003) / 100002.0F;
  }
  bool chance(unsigned one_in) { return engine_() % one_in == 0; }
  Vector color(float high) { return {between(0, high), between(0, high), between(0, high), 1}; }

 private:
  std::minstd_rand engine_;
};

legacy_gl_options many_lights(legacy_gl_programs programs = LEGACY_GL_PROGRAMS_GENERAL) {
  legacy_gl_options options = options_with(programs);
  options.max_lights = kLights;
  return options;
}

struct Vertex {
  std::array<float, 3> position, normal;
  Vector color;
};

// A patch of a sphere, so that a part of it faces each light. Powers of longer normals would leave
// the range of float32.
std::vector<Vertex> patch(Random& random, float normal_length) {
  std::vector<Vertex> vertices;
  const auto corner = [&](int i, int j) {
    const float u = 0.4F * static_cast<float>(i) - 0.8F, v = 0.4F * static_cast<float>(j) - 0.8F;
    const float w = std::sqrt(std::max(0.0F, 1 - 0.5F * (u * u + v * v)));
    const float length = std::sqrt(u * u + v * v + w * w) / normal_length;
    vertices.push_back(
        {{0.3F * u, 0.3F * v, 0.3F * w}, {u / length, v / length, w / length}, random.color(1.5F)});
  };
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
        corner(i + a, j + b);
  return vertices;
}

void set_up(const GlFunctions& gl, Random& random) {
  gl.Viewport(0, 0, kSize, kSize);
  gl.MatrixMode(GL_PROJECTION);
  gl.Ortho(-3, 3, -3, 3, -5, 5);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  const Vector none{0, 0, 0, 1};
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, none.data());
  for (unsigned i = 0; i < kLights; ++i) {
    const GLenum light = GL_LIGHT0 + i;
    const Vector position{random.between(-3, 3), random.between(-3, 3), random.between(-1, 2), 1};
    const Vector direction{random.between(-1, 1), random.between(-1, 1), random.between(-2, -0.2F),
                           0};
    gl.Lightfv(light, GL_POSITION, position.data());
    for (const int term : {GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT})
      gl.Lightfv(light, static_cast<GLenum>(term), random.color(0.3F).data());
    if (random.chance(2)) {
      gl.Lightfv(light, GL_SPOT_DIRECTION, direction.data());
      gl.Lightf(light, GL_SPOT_CUTOFF, random.between(1, 60));
      gl.Lightf(light, GL_SPOT_EXPONENT, random.chance(2) ? 0 : random.between(0, 128));
    }
    if (random.chance(3)) gl.Lightf(light, GL_QUADRATIC_ATTENUATION, random.between(1e3F, 1e6F));
    if (random.chance(5)) gl.Lightf(light, GL_LINEAR_ATTENUATION, random.between(0, 1e5F));
    if (!random.chance(8)) gl.Enable(light);
  }
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, random.color(1).data());
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, std::floor(random.between(0, 64)));
}

enum class Way { kList, kBeginEnd, kBufferObject };

void begin_end(const GlFunctions& gl, const std::vector<Vertex>& vertices) {
  gl.Begin(GL_TRIANGLES);
  for (const Vertex& vertex : vertices) {
    gl.Color4fv(vertex.color.data());
    gl.Normal3fv(vertex.normal.data());
    gl.Vertex3fv(vertex.position.data());
  }
  gl.End();
}

void draw_objects(const GlFunctions& gl, Random random, const std::vector<Vertex>& vertices,
                  Way way) {
  for (unsigned i = 0; i < kObjects; ++i) {
    gl.PushMatrix();
    gl.Translatef(random.between(-2.5F, 2.5F), random.between(-2.5F, 2.5F), 0);
    gl.Rotatef(random.between(-60, 60), 1, 0.5F, 0);
    const float scale = random.between(0.5F, 2);
    gl.Scalef(scale, random.chance(3) ? 1 : scale, scale);
    switch (way) {
      case Way::kList: gl.CallList(1); break;
      case Way::kBeginEnd: begin_end(gl, vertices); break;
      case Way::kBufferObject:
        gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
    }
    gl.PopMatrix();
  }
}

struct Result {
  Image image;
  legacy_gl_statistics statistics;
};

Result draw(CoreContext& context, unsigned seed, Way way) {
  context.recreate();
  const GlFunctions& gl = context.gl;
  Random random(seed);
  set_up(gl, random);
  if (random.chance(3)) gl.Enable(GL_COLOR_MATERIAL);
  if (random.chance(3)) gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  if (random.chance(3)) gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  if (random.chance(2)) gl.Enable(GL_NORMALIZE);
  const std::vector<Vertex> vertices = patch(random, random.chance(3) ? 1.5F : 1.0F);
  if (way == Way::kList) {
    gl.NewList(1, GL_COMPILE);
    begin_end(gl, vertices);
    gl.EndList();
  }
  if (way == Way::kBufferObject) {
    GLuint name = 0;
    gl.GenBuffers(1, &name);
    gl.BindBuffer(GL_ARRAY_BUFFER, name);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                  vertices.data(), GL_STATIC_DRAW);
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    gl.VertexPointer(3, GL_FLOAT, sizeof(Vertex), offset(offsetof(Vertex, position)));
    gl.NormalPointer(GL_FLOAT, sizeof(Vertex), offset(offsetof(Vertex, normal)));
    gl.ColorPointer(4, GL_FLOAT, sizeof(Vertex), offset(offsetof(Vertex, color)));
    for (const int array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY})
      gl.EnableClientState(static_cast<GLenum>(array));
  }
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_objects(gl, random, vertices, way);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  return {context.read_float(), statistics_now()};
}

void expect_unseen(legacy_gl_programs programs, unsigned seeds) {
  CoreContext context(kSize, kSize, PixelFormat::rgba32f, many_lights(programs));
  std::uint64_t culled = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Result all = draw(context, seed, Way::kBufferObject);
    EXPECT_EQ(all.statistics.lights_culled, 0u);
    for (const Way way : {Way::kList, Way::kBeginEnd}) {
      const Result some = draw(context, seed, way);
      EXPECT_LE(compare(some.image, all.image).max_difference(), kToleranceSteps)
          << "seed " << seed << (way == Way::kList ? " list" : " begin");
      culled += some.statistics.lights_culled;
    }
  }
  EXPECT_GT(culled, std::uint64_t{seeds} * 2 * kObjects * 5);  // of 56, five for each object
}

TEST(ManyLights, ThatDoNotReachADrawAreLeftOutUnseen) {
  expect_unseen(LEGACY_GL_PROGRAMS_GENERAL, 60);
}

TEST(ManyLights, ThatDoNotReachADrawAreLeftOutOfSpecialisedPrograms) {
  expect_unseen(LEGACY_GL_PROGRAMS_SPECIALISED, 3);
}

TEST(ManyLights, ThePreciseQualityTakesAll) {
  legacy_gl_options options = many_lights();
  options.quality = LEGACY_GL_QUALITY_PRECISE;
  CoreContext context(kSize, kSize, PixelFormat::rgba32f, options);
  EXPECT_EQ(draw(context, 8, Way::kList).statistics.lights_culled, 0u);
}

TEST(ManyLights, EightAreNotLookedAt) {
  CoreContext context(kSize, kSize, PixelFormat::rgba32f);
  const GlFunctions& gl = context.gl;
  Random random(3);
  gl.Enable(GL_LIGHTING);
  for (GLenum light = GL_LIGHT0; light <= GL_LIGHT7; ++light) {
    const Vector far{1e6F, 0, 0, 1};
    gl.Lightfv(light, GL_POSITION, far.data());
    gl.Lightf(light, GL_QUADRATIC_ATTENUATION, 1e6F);
    gl.Enable(light);
  }
  begin_end(gl, patch(random, 1));
  gl.Flush();
  EXPECT_EQ(statistics_now().lights_culled, 0u);
}

// How many lights reach an object differs from object to object; the programs are few, and no frame
// after the first ones makes another.
TEST(ManyLights, MakeFewPrograms) {
  CoreContext context(kSize, kSize, PixelFormat::rgba8,
                      many_lights(LEGACY_GL_PROGRAMS_SPECIALISED));
  const GlFunctions& gl = context.gl;
  Random random(21);
  set_up(gl, random);
  for (unsigned i = 0; i < kLights; ++i) {  // one kind, of which 0 to 64 reach
    gl.Lightf(GL_LIGHT0 + i, GL_QUADRATIC_ATTENUATION, 1e5F);
    gl.Lightf(GL_LIGHT0 + i, GL_LINEAR_ATTENUATION, 0);
    gl.Lightf(GL_LIGHT0 + i, GL_SPOT_CUTOFF, 180);
    gl.Enable(GL_LIGHT0 + i);
  }
  const std::vector<Vertex> vertices = patch(random, 1);
  for (int frame = 0; frame < 6; ++frame) {
    Random places(static_cast<unsigned>(frame % 3) + 50);
    for (int i = 0; i < 8; ++i) draw_objects(gl, places, vertices, Way::kBeginEnd);
    gl.Flush();
    if (frame == 2) {
      EXPECT_LE(statistics_now().programs_compiled,
                16u);  // 0, 1, 2, 4, ... 64 lights, in two spaces
      legacy_gl_reset_statistics();
    }
  }
  EXPECT_EQ(statistics_now().programs_compiled, 0u);
  EXPECT_GT(statistics_now().lights_culled, 0u);
}

}  // namespace
}  // namespace legacy_gl::test
