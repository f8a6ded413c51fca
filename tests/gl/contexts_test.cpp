// Contexts: creation over good and bad drivers, several at once, threads, sharing.
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <thread>

#include "scene_changes.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {
namespace {

// Loaders are plain functions: what they leave out is said here.
std::string missing_function;
const char* pretended_version = nullptr;

const GLubyte* pretended_get_string(GLenum) {
  return reinterpret_cast<const GLubyte*>(pretended_version);
}

legacy_gl_proc faulty_loader(const char* name) {
  if (missing_function == name) return nullptr;
  if (pretended_version && std::strcmp(name, "glGetString") == 0)
    return reinterpret_cast<legacy_gl_proc>(pretended_get_string);
  return CoreContext::driver_proc(name);
}

class ContextCreation : public testing::Test {
 protected:
  void TearDown() override {
    missing_function.clear();
    pretended_version = nullptr;
  }

  void expect_refused(legacy_gl_loader loader, legacy_gl_status expected, const char* detail,
                      const legacy_gl_options* options = nullptr) {
    legacy_gl_status status = LEGACY_GL_OK;
    EXPECT_EQ(legacy_gl_create_context(loader, options, &status), nullptr);
    EXPECT_EQ(status, expected) << legacy_gl_status_string(status);
    EXPECT_NE(std::string(legacy_gl_status_detail()).find(detail), std::string::npos)
        << legacy_gl_status_detail();
  }

  CoreContext driver{16, 16};
};

TEST_F(ContextCreation, WithoutALoaderIsRefused) {
  expect_refused(nullptr, LEGACY_GL_INVALID_ARGUMENT, "loader");
}

TEST_F(ContextCreation, NamesTheFunctionThatTheLoaderMisses) {
  for (const char* name : {"glGetString", "glMapBufferRange", "glBindBufferRange"}) {
    missing_function = name;
    expect_refused(faulty_loader, LEGACY_GL_MISSING_FUNCTION, name);
  }
}

TEST_F(ContextCreation, SaysTheVersionOfADriverThatIsTooOld) {
  for (const char* version : {"2.1 Mesa 22.3.6", "3.2 (Core Profile)", "OpenGL ES 2.0 Mesa", "?"}) {
    pretended_version = version;
    expect_refused(faulty_loader, LEGACY_GL_DRIVER_TOO_OLD, version);
  }
}

TEST_F(ContextCreation, NeedsACurrentDriverContext) {
  legacy_gl_loader no_version = [](const char* name) {
    return std::strcmp(name, "glGetString") == 0
               ? reinterpret_cast<legacy_gl_proc>(+[](GLenum) -> const GLubyte* { return nullptr; })
               : CoreContext::driver_proc(name);
  };
  expect_refused(no_version, LEGACY_GL_NO_DRIVER_CONTEXT, "glGetString");
}

TEST_F(ContextCreation, RefusesANumberOfLightsOutOfRange) {
  for (const unsigned lights : {1u, 7u, 257u}) {
    legacy_gl_options options{};
    options.max_lights = lights;
    expect_refused(CoreContext::driver_proc, LEGACY_GL_INVALID_ARGUMENT,
                   std::to_string(lights).c_str(), &options);
  }
}

TEST_F(ContextCreation, RefusesOptionsWithoutASize) {
  legacy_gl_options options{};
  options.size = 0;
  expect_refused(CoreContext::driver_proc, LEGACY_GL_INVALID_ARGUMENT, "LEGACY_GL_OPTIONS_INIT",
                 &options);
}

TEST_F(ContextCreation, TakesOptionsOfAnOlderProgram) {
  struct {
    std::size_t size = sizeof(std::size_t) + sizeof(unsigned);
    unsigned max_lights = 16;
  } older;
  legacy_gl_status status = LEGACY_GL_OK;
  legacy_gl_context* context = legacy_gl_create_context(
      CoreContext::driver_proc, reinterpret_cast<const legacy_gl_options*>(&older), &status);
  ASSERT_NE(context, nullptr) << legacy_gl_status_detail();
  legacy_gl_make_current(context);
  GLint lights = 0;
  lglGetIntegerv(GL_MAX_LIGHTS, &lights);
  EXPECT_EQ(lights, 16);
  legacy_gl_destroy_context(context);
}

TEST_F(ContextCreation, TwoHundredFiftySixLightsWork) {
  legacy_gl_options options{};
  options.max_lights = 256;
  CoreContext many(64, 64, PixelFormat::rgba8, options);
  set_up_scene(many.gl);
  GLint lights = 0;
  many.gl.GetIntegerv(GL_MAX_LIGHTS, &lights);
  EXPECT_EQ(lights, 256);
  // 256 lights of one 256th of white are one white light.
  for (GLenum i = 0; i < 256; ++i) {
    const float part[] = {1.0f / 256, 1.0f / 256, 1.0f / 256, 1};
    const float position[] = {0, 0, 1, 0};
    many.gl.Enable(GL_LIGHT0 + i);
    many.gl.Lightfv(GL_LIGHT0 + i, GL_DIFFUSE, part);
    many.gl.Lightfv(GL_LIGHT0 + i, GL_SPECULAR, part);
    many.gl.Lightfv(GL_LIGHT0 + i, GL_POSITION, position);
  }
  draw_scene(many.gl);
  EXPECT_EQ(many.gl.GetError(), GLenum{GL_NO_ERROR});
  const Image sum = many.read_rgba8();

  CoreContext one(64, 64);
  set_up_scene(one.gl);
  const float position[] = {0, 0, 1, 0};
  one.gl.LoadIdentity();
  one.gl.Lightfv(GL_LIGHT0, GL_POSITION, position);
  one.gl.Translatef(0, 0, -4);
  draw_scene(one.gl);
  const Image white = one.read_rgba8();
  // 256 roundings of a float32 sum stay far below half a step; a value near .5 may go either way.
  int largest = 0;
  for (std::size_t i = 0; i < white.bytes.size(); ++i)
    largest = std::max(largest, std::abs(int{white.bytes[i]} - int{sum.bytes[i]}));
  EXPECT_LE(largest, 1);
}

TEST(Contexts, SeveralKeepTheirOwnState) {
  CoreContext red(16, 16), blue(16, 16);
  red.make_current();
  red.gl.ClearColor(1, 0, 0, 1);
  blue.make_current();
  blue.gl.ClearColor(0, 0, 1, 1);
  red.make_current();
  red.gl.Clear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(red.read_rgba8().bytes[0], 255);
  blue.make_current();
  blue.gl.Clear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(blue.read_rgba8().bytes[0], 0);
  EXPECT_EQ(blue.read_rgba8().bytes[2], 255);
}

TEST(Contexts, OneIsCurrentInOneThread) {
  CoreContext context(16, 16);
  std::thread([&] {
    EXPECT_EQ(legacy_gl_get_current(), nullptr);
    EXPECT_EQ(legacy_gl_make_current(context.handle()), LEGACY_GL_CURRENT_ELSEWHERE);
  }).join();
}

TEST(Contexts, StatisticsFillWhatTheProgramKnows) {
  legacy_gl_statistics statistics{};
  EXPECT_EQ(legacy_gl_get_statistics(&statistics), LEGACY_GL_NO_CURRENT);
  CoreContext context(16, 16);
  context.gl.Rectf(-1, -1, 1, 1);
  legacy_gl_flush();
  statistics.size = offsetof(legacy_gl_statistics, vertices);
  EXPECT_EQ(legacy_gl_get_statistics(&statistics), LEGACY_GL_OK);
  EXPECT_EQ(statistics.draws, 1u);
  EXPECT_EQ(statistics.vertices, 0u);
  statistics.size = 0;
  EXPECT_EQ(legacy_gl_get_statistics(&statistics), LEGACY_GL_INVALID_ARGUMENT);
}

TEST(Contexts, ThreadsDrawSideBySide) {
  const auto picture = [] {
    CoreContext context(64, 64);
    set_up_scene(context.gl);
    for (int frame = 0; frame < 20; ++frame) draw_scene(context.gl);
    return context.read_rgba8().bytes;
  };
  const auto expected = picture();
  std::vector<std::uint8_t> first, second;
  std::thread a([&] { first = picture(); });
  std::thread b([&] { second = picture(); });
  a.join();
  b.join();
  EXPECT_EQ(first, expected);
  EXPECT_EQ(second, expected);
}

TEST(Contexts, SharedListsAreSeenByBothAndOutliveTheirMaker) {
  auto maker = std::make_unique<CoreContext>(16, 16);
  legacy_gl_options options{};
  options.share = maker->handle();
  CoreContext user(16, 16, PixelFormat::rgba8, options);
  maker->make_current();
  const GLuint list = maker->gl.GenLists(1);
  maker->gl.NewList(list, GL_COMPILE);
  maker->gl.Color3f(0, 1, 0);
  maker->gl.Rectf(-1, -1, 1, 1);
  maker->gl.EndList();
  user.make_current();
  EXPECT_EQ(user.gl.IsList(list), GL_TRUE);
  user.gl.CallList(list);
  EXPECT_EQ(user.read_rgba8().bytes[1], 255);
  maker.reset();
  user.make_current();
  user.gl.Clear(GL_COLOR_BUFFER_BIT);
  user.gl.CallList(list);
  EXPECT_EQ(user.read_rgba8().bytes[1], 255);
}

TEST(Contexts, CallsWithoutOneAreHarmless) {
  ASSERT_EQ(legacy_gl_make_current(nullptr), LEGACY_GL_OK);
  const GlFunctions gl = load_gl_functions(legacy_gl_get_proc_address);
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(0, 0, 0);
  gl.End();
  gl.Enable(GL_LIGHTING);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  legacy_gl_flush();
}

TEST(ProcAddress, KnowsTheNamesOfOpenGl15AndNoOther) {
  EXPECT_NE(legacy_gl_get_proc_address("glLightfv"), nullptr);
  EXPECT_NE(legacy_gl_get_proc_address("glGetBufferSubData"), nullptr);
  EXPECT_EQ(legacy_gl_get_proc_address("glActiveTextureARB"),
            legacy_gl_get_proc_address("glActiveTexture"));
  for (const char* name : {"", "gl", "Lightfv", "glLightfvx", "glCreateShader", "glZ"})
    EXPECT_EQ(legacy_gl_get_proc_address(name), nullptr) << name;
  EXPECT_EQ(legacy_gl_get_proc_address(nullptr), nullptr);
}

TEST(ProgramSource, TellsTheKeyAndBothStages) {
  CoreContext context(16, 16);
  set_up_scene(context.gl);
  const std::size_t length = legacy_gl_get_program_source(nullptr, 0);
  ASSERT_GT(length, 0u);
  std::string text(length + 1, 'x');
  EXPECT_EQ(legacy_gl_get_program_source(text.data(), text.size()), length);
  EXPECT_NE(text.find("1 directional"), std::string::npos) << text;
  EXPECT_NE(text.find("gl_Position"), std::string::npos);
  EXPECT_NE(text.find("fragment_color"), std::string::npos);
  char shortened[8];
  EXPECT_EQ(legacy_gl_get_program_source(shortened, sizeof shortened), length);
  EXPECT_EQ(std::strlen(shortened), sizeof shortened - 1);
}

}  // namespace
}  // namespace legacy_gl::test
