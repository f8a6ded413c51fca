// LEGACY_GL_DEBUG: what the log says of a small scene, and that the picture is the same. The
// environment is set before the first context.
#include <gtest/gtest.h>
#include <legacy_gl/context.h>

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "scene_changes.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {
namespace {

std::filesystem::path log_file() {
  return std::filesystem::temp_directory_path() /
         ("legacy_gl_debug_" + std::to_string(::getpid()) + ".log");
}

class Environment : public testing::Environment {
 public:
  void SetUp() override {
    setenv("LEGACY_GL_DEBUG", "calls,state,paths,glsl,errors,labels", 1);
    setenv("LEGACY_GL_DEBUG_FILE", log_file().c_str(), 1);
  }
  void TearDown() override { std::filesystem::remove(log_file()); }
};
[[maybe_unused]] const auto* const environment = testing::AddGlobalTestEnvironment(new Environment);

std::string read_log() {
  std::ifstream file(log_file());
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What is logged while `work` runs.
template <typename Work>
std::string logged(Work work) {
  const std::size_t before = read_log().size();
  work();
  return read_log().substr(before);
}

class DebugLog : public testing::Test {
 protected:
  CoreContext context{64, 64};
  const GlFunctions& gl = context.gl;
};

TEST_F(DebugLog, TellsCallsWithTheirValues) {
  const GLfloat position[] = {0, 0, 1, 0};
  EXPECT_EQ(logged([&] { gl.Clear(GL_DEPTH_BUFFER_BIT); }), "glClear(GL_DEPTH_BUFFER_BIT)\n");
  EXPECT_EQ(logged([&] { gl.Vertex3f(1, 2, 0.5f); }), "glVertex3f(1, 2, 0.5)\n");
  const std::string light = logged([&] { gl.Lightfv(GL_LIGHT1, GL_POSITION, position); });
  EXPECT_EQ(light.substr(0, light.find('\n')), "glLightfv(GL_LIGHT1, GL_POSITION, {0, 0, 1, 0})");
  EXPECT_EQ(logged([&] { gl.IsEnabled(GL_FOG); }), "glIsEnabled(GL_FOG)\n  = GL_FALSE\n");
}

TEST_F(DebugLog, TellsWhatACallChanges) {
  const std::string text = logged([&] { gl.Enable(GL_LIGHTING); });
  EXPECT_NE(text.find("glEnable changes "), std::string::npos) << text;
  EXPECT_NE(text.find("program key"), std::string::npos) << text;
  EXPECT_EQ(logged([&] { gl.Enable(GL_LIGHTING); }), "glEnable(GL_LIGHTING)\n");
  EXPECT_NE(logged([&] { gl.Translatef(1, 0, 0); }).find("glTranslatef changes transform"),
            std::string::npos);
}

TEST_F(DebugLog, TellsWhatMaterialsAndTexturesChange) {
  const GLfloat red[] = {1, 0, 0, 1};
  const auto material = [&] { gl.Materialfv(GL_FRONT, GL_DIFFUSE, red); };
  EXPECT_NE(logged(material).find("glMaterialfv changes material"), std::string::npos);
  EXPECT_EQ(logged(material).find("changes"), std::string::npos);
  const std::string texture =
      logged([&] { gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_FLOAT, red); });
  EXPECT_NE(texture.find("glTexImage2D changes texture"), std::string::npos) << texture;
}

/// The line of `paths` in a log.
std::string path_line(const std::string& log) {
  const std::size_t at = log.find(" draws ");
  if (at == std::string::npos) return "";
  const std::size_t begin = log.rfind('\n', at) + 1;
  return log.substr(begin, log.find('\n', at) - begin);
}

TEST_F(DebugLog, TellsThePathOfABatchAndWhy) {
  const auto draw = [&] {
    gl.Rectf(-1, -1, 1, 1);
    gl.Finish();
  };
  EXPECT_EQ(
      path_line(logged(draw)),
      "  glFinish draws GL_POLYGON, 4 vertices: batch (the primitives are drawn as they are)");
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  EXPECT_EQ(path_line(logged(draw)),
            "  glFinish draws GL_POLYGON, 4 vertices: expanded batch (glPolygonMode makes lines or "
            "points of it)");
  GLfloat values[64];
  gl.FeedbackBuffer(64, GL_2D, values);
  gl.RenderMode(GL_FEEDBACK);
  EXPECT_EQ(
      path_line(logged(draw)),
      "  glFinish draws GL_POLYGON, 4 vertices: CPU pipeline (glRenderMode is not GL_RENDER)");
}

TEST_F(DebugLog, TellsThePathOfArraysAndWhy) {
  const std::vector<GLfloat> positions(3 * 3000, 0.5f);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, 0, positions.data());
  EXPECT_EQ(path_line(logged([&] { gl.DrawArrays(GL_TRIANGLES, 0, 3); })),
            "  glDrawArrays draws GL_TRIANGLES, 3 vertices: recorder (the vertices are few, or far "
            "apart in the arrays)");
  gl.Finish();
  EXPECT_EQ(path_line(logged([&] { gl.DrawArrays(GL_TRIANGLES, 0, 3000); })),
            "  glDrawArrays draws GL_TRIANGLES, 3000 vertices: streamed arrays (the vertices are "
            "many, and close together in the arrays)");
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(positions.size() * sizeof(GLfloat)),
                positions.data(), GL_STATIC_DRAW);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
  EXPECT_EQ(
      path_line(logged([&] { gl.DrawArrays(GL_TRIANGLES, 0, 3); })),
      "  glDrawArrays draws GL_TRIANGLES, 3 vertices: arrays in buffers (the driver reads the "
      "buffer objects as they are)");
}

TEST_F(DebugLog, TellsThePathOfAListsMesh) {
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3000; ++i) gl.Vertex3f(0.001f * static_cast<float>(i), i % 3 == 1, 0);
  gl.End();
  gl.EndList();
  const std::string line = path_line(logged([&] { gl.CallList(list); }));
  EXPECT_EQ(line.find("  glCallList draws GL_TRIANGLES, "), 0u) << line;
  EXPECT_NE(line.find(": mesh ("), std::string::npos) << line;
}

TEST_F(DebugLog, NamesTheCallThatRaisesAnError) {
  EXPECT_EQ(logged([&] { gl.Enable(GL_TRIANGLES); }),
            "glEnable(0x0004)\nerror: GL_INVALID_ENUM in glEnable\n");
  // The first error sticks for glGetError; the log has each.
  EXPECT_NE(logged([&] { gl.LineWidth(-1); }).find("error: GL_INVALID_VALUE in glLineWidth"),
            std::string::npos);
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_ENUM});
}

TEST_F(DebugLog, HasEachProgramOnce) {
  const auto draw = [&] {
    gl.Rectf(-1, -1, 1, 1);
    legacy_gl_flush();
  };
  EXPECT_NE(logged(draw).find("void main()"), std::string::npos);
  EXPECT_EQ(logged(draw).find("void main()"), std::string::npos);
}

TEST_F(DebugLog, ListsAreCompiledAndPlayed) {
  const GLuint list = gl.GenLists(1);
  const std::string compiled = logged([&] {
    gl.NewList(list, GL_COMPILE);
    gl.Color3f(0, 1, 0);
    gl.Rectf(-1, -1, 1, 1);
    gl.EndList();
  });
  EXPECT_NE(compiled.find("glColor3f(0, 1, 0)"), std::string::npos) << compiled;
  gl.CallList(list);
  EXPECT_EQ(context.read_rgba8().bytes[1], 255);
}

TEST_F(DebugLog, LeavesThePictureAsItIs) {
  MesaContext mesa(64, 64);
  set_up_scene(mesa.gl);
  draw_scene(mesa.gl);
  const Image expected = mesa.read_rgba8();
  context.make_current();
  set_up_scene(gl);
  draw_scene(gl);
  const Image drawn = context.read_rgba8();
  int largest = 0;
  for (std::size_t i = 0; i < drawn.bytes.size(); ++i)
    largest = std::max(largest, std::abs(int{drawn.bytes[i]} - int{expected.bytes[i]}));
  EXPECT_LE(largest, 1);  // two roundings of the same sum
}

/// The label that the driver has for some buffer is `text`.
bool driver_has_buffer_label(const std::string& text) {
  using GetObjectLabel = void(LEGACY_GL_APIENTRY*)(GLenum, GLuint, GLsizei, GLsizei*, char*);
  using IsBuffer = GLboolean(LEGACY_GL_APIENTRY*)(GLuint);
  const auto get_label =
      reinterpret_cast<GetObjectLabel>(CoreContext::driver_proc("glGetObjectLabel"));
  const auto is_buffer = reinterpret_cast<IsBuffer>(CoreContext::driver_proc("glIsBuffer"));
  constexpr GLenum kBuffer = 0x82E0;  // GL_BUFFER of KHR_debug
  for (GLuint name = 1; name < 64; ++name) {
    char label[256] = "";
    if (is_buffer(name)) get_label(kBuffer, name, sizeof label, nullptr, label);
    if (text == label) return true;
  }
  return false;
}

TEST_F(DebugLog, LabelsReachTheDriver) {
  EXPECT_TRUE(driver_has_buffer_label("stream of vertices"));
}

TEST(DebugLabels, AreNoErrorsOfTheDriver) {
  for (int i = 0; i < 2; ++i) {
    CoreContext context(16, 16);
    set_up_scene(context.gl);
    draw_scene(context.gl);
    legacy_gl_flush();
    const auto get_error =
        reinterpret_cast<GLenum(LEGACY_GL_APIENTRY*)()>(CoreContext::driver_proc("glGetError"));
    EXPECT_EQ(get_error(), GLenum{GL_NO_ERROR});
  }
  GlesContext es(16, 16);
  set_up_scene(es.gl);
  draw_scene(es.gl);
  legacy_gl_flush();
  const auto get_error =
      reinterpret_cast<GLenum(LEGACY_GL_APIENTRY*)()>(GlesContext::driver_proc("glGetError"));
  EXPECT_EQ(get_error(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace legacy_gl::test
