// legacy_gl_options.debug_labels: the labels and groups of KHR_debug that the driver gets.
#include <gtest/gtest.h>
#include <legacy_gl/context.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "support/contexts.hpp"

namespace legacy_gl::test {
namespace {

// What the driver is told, instead of telling it. Loaders are plain functions.
std::vector<std::string> told;

void object_label(GLenum, GLuint, GLsizei length, const GLchar* text) {
  told.emplace_back(text, static_cast<std::size_t>(length));
}
void push_group(GLenum, GLuint, GLsizei length, const GLchar* text) {
  told.push_back("group " + std::string(text, static_cast<std::size_t>(length)));
}
void pop_group() { told.emplace_back("end"); }

legacy_gl_proc telling_loader(const char* name) {
  if (std::strcmp(name, "glObjectLabel") == 0)
    return reinterpret_cast<legacy_gl_proc>(object_label);
  if (std::strcmp(name, "glPushDebugGroup") == 0)
    return reinterpret_cast<legacy_gl_proc>(push_group);
  if (std::strcmp(name, "glPopDebugGroup") == 0) return reinterpret_cast<legacy_gl_proc>(pop_group);
  return CoreContext::driver_proc(name);
}

TEST(DebugLabels, AreNotGivenUnasked) {
  CoreContext driver(16, 16);
  told.clear();
  legacy_gl_context* context = legacy_gl_create_context(telling_loader, nullptr, nullptr);
  ASSERT_NE(context, nullptr) << legacy_gl_status_detail();
  legacy_gl_make_current(context);
  driver.gl.Rectf(-1, -1, 1, 1);
  driver.gl.Finish();
  EXPECT_TRUE(told.empty());
  legacy_gl_destroy_context(context);
}

TEST(DebugLabels, NameObjectsAndTheCallOfADraw) {
  CoreContext driver(16, 16);
  told.clear();
  legacy_gl_options options{};
  options.debug_labels = 1;
  legacy_gl_context* context = legacy_gl_create_context(telling_loader, &options, nullptr);
  ASSERT_NE(context, nullptr) << legacy_gl_status_detail();
  legacy_gl_make_current(context);
  EXPECT_EQ(std::count(told.begin(), told.end(), "stream of vertices"), 1);
  driver.gl.Rectf(-1, -1, 1, 1);
  driver.gl.Finish();
  const auto group = std::find(told.begin(), told.end(), "group glFinish: batch");
  ASSERT_NE(group, told.end());
  EXPECT_NE(std::find(group, told.end(), "end"), told.end());
  // The program has the key in words.
  EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](const std::string& text) {
    return text.find("unlit") != std::string::npos;
  }));
  EXPECT_EQ(std::count_if(told.begin(), told.end(),
                          [](const std::string& text) { return text.starts_with("group"); }),
            std::count(told.begin(), told.end(), "end"));
  legacy_gl_destroy_context(context);
}

TEST(DebugLabels, GroupsEndWhereADrawEnds) {
  CoreContext driver(16, 16);
  legacy_gl_options options{};
  options.debug_labels = 1;
  legacy_gl_context* context = legacy_gl_create_context(telling_loader, &options, nullptr);
  ASSERT_NE(context, nullptr) << legacy_gl_status_detail();
  legacy_gl_make_current(context);
  const std::vector<GLfloat> positions(3 * 3000, 0.5f);
  driver.gl.EnableClientState(GL_VERTEX_ARRAY);
  driver.gl.VertexPointer(3, GL_FLOAT, 0, positions.data());
  told.clear();
  driver.gl.Rectf(-1, -1, 1, 1);
  driver.gl.DrawArrays(GL_TRIANGLES, 0, 3000);
  std::erase_if(
      told, [](const std::string& text) { return text != "end" && !text.starts_with("group"); });
  // What waits is drawn first, in a group of its own.
  EXPECT_EQ(told, (std::vector<std::string>{"group glDrawArrays: batch", "end",
                                            "group glDrawArrays: streamed arrays", "end"}));
  legacy_gl_destroy_context(context);
}

}  // namespace
}  // namespace legacy_gl::test
