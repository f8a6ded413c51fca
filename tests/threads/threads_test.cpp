// Lists, textures and buffer objects that are changed in one thread and drawn in others, each with
// a context of its own (GL 2.1 spec D.3). What the specification leaves to the program is done: it
// waits until a change is finished before others draw with it.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <barrier>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "support/contexts.hpp"

namespace legacy_gl::test {
namespace {

constexpr int kSize = 32, kThreads = 3;

struct Names {
  GLuint list = 0, texture = 0, vertices = 0, elements = 0;
};

Names make_names(const GlFunctions& gl) {
  Names names;
  names.list = gl.GenLists(1);
  gl.GenTextures(1, &names.texture);
  gl.GenBuffers(1, &names.vertices);
  gl.GenBuffers(1, &names.elements);
  return names;
}

// A mesh large enough to be kept in the driver, a texture, and quads by elements with normals that
// drivers do not fetch as OpenGL 1.x reads them.
void fill(const GlFunctions& gl, const Names& names, GLubyte shade) {
  gl.NewList(names.list, GL_COMPILE);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 150; ++i) {
    gl.Color3ub(shade, 0, 0);
    gl.Vertex2f(-1, -1);
    gl.Vertex2f(0, -1);
    gl.Vertex2f(0, 1);
    gl.Vertex2f(-1, -1);
    gl.Vertex2f(0, 1);
    gl.Vertex2f(-1, 1);
  }
  gl.End();
  gl.EndList();
  const std::array<GLubyte, 3> texel{0, shade, 0};
  gl.BindTexture(GL_TEXTURE_2D, names.texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, shade % 2 ? GL_NEAREST : GL_LINEAR);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, texel.data());
  struct Vertex {
    std::array<GLfloat, 2> position;
    std::array<GLubyte, 4> color;
    std::array<GLbyte, 4> normal;
  };
  std::array<Vertex, 4> vertices{};
  for (std::size_t i = 0; i < 4; ++i)
    vertices[i] = {
        {i == 0 || i == 3 ? 0.0F : 1.0F, i < 2 ? 0.0F : 1.0F}, {0, 0, shade, 255}, {0, 0, 127, 0}};
  const std::array<GLushort, 4> elements{0, 1, 2, 3};
  gl.BindBuffer(GL_ARRAY_BUFFER, names.vertices);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, names.elements);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof elements, elements.data(), GL_STATIC_DRAW);
  gl.Finish();
}

const void* at(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

// The list in the left half, the texture in the right lower quarter, the buffers above it.
void draw(const GlFunctions& gl, const Names& names) {
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.CallList(names.list);
  gl.BindTexture(GL_TEXTURE_2D, names.texture);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  gl.Enable(GL_TEXTURE_2D);
  gl.Rectf(0, -1, 1, 0);
  gl.Disable(GL_TEXTURE_2D);
  constexpr GLsizei kStride = 2 * sizeof(GLfloat) + 8;
  gl.BindBuffer(GL_ARRAY_BUFFER, names.vertices);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, names.elements);
  gl.VertexPointer(2, GL_FLOAT, kStride, nullptr);
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, kStride, at(2 * sizeof(GLfloat)));
  gl.NormalPointer(GL_BYTE, kStride, at(2 * sizeof(GLfloat) + 4));
  for (const GLenum array :
       {GLenum{GL_VERTEX_ARRAY}, GLenum{GL_COLOR_ARRAY}, GLenum{GL_NORMAL_ARRAY}})
    gl.EnableClientState(array);
  gl.DrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, nullptr);
}

std::array<int, 3> shades(CoreContext& context) {
  const Image image = context.read_rgba8();
  const auto value = [&](int x, int y, std::size_t channel) {
    return image.bytes[static_cast<std::size_t>(y * kSize + x) * 4 + channel];
  };
  return {value(kSize / 4, kSize / 2, 0), value(kSize * 3 / 4, kSize / 4, 1),
          value(kSize * 3 / 4, kSize * 3 / 4, 2)};
}

std::unique_ptr<CoreContext> sharing(const CoreContext& maker) {
  return std::make_unique<CoreContext>(kSize, kSize, PixelFormat::rgba8, legacy_gl_options{},
                                       CoreDriver{.shares = &maker});
}

template <typename Work>
void in_threads(Work work) {
  std::vector<std::thread> threads;
  for (int i = 0; i < kThreads; ++i) threads.emplace_back(work, i);
  for (std::thread& thread : threads) thread.join();
}

TEST(Threads, WhatOneChangesAllDraw) {
  constexpr int kRounds = 12;
  CoreContext maker(kSize, kSize);
  const Names names = make_names(maker.gl);
  fill(maker.gl, names, 1);
  std::barrier changed(kThreads), drawn(kThreads);
  std::mutex making;  // of contexts, which a program does in one thread
  in_threads([&](int self) {
    std::unique_lock lock(making);
    const std::unique_ptr<CoreContext> context = sharing(maker);
    lock.unlock();
    for (int round = 0; round < kRounds; ++round) {
      const auto shade = static_cast<GLubyte>(40 + 15 * round + round % 2);
      if (round % kThreads == self) fill(context->gl, names, shade);
      changed.arrive_and_wait();
      draw(context->gl, names);
      EXPECT_EQ(shades(*context), (std::array<int, 3>{shade, shade, shade})) << round;
      EXPECT_EQ(context->gl.GetError(), GLenum{GL_NO_ERROR});
      drawn.arrive_and_wait();
    }
    lock.lock();
  });
}

TEST(Threads, NamesAreGivenOnce) {
  CoreContext maker(kSize, kSize);
  std::mutex mutex;
  std::array<std::multiset<GLuint>, 3> given;
  in_threads([&](int) {
    std::unique_lock lock(mutex);
    const std::unique_ptr<CoreContext> context = sharing(maker);
    lock.unlock();
    const GlFunctions& gl = context->gl;
    for (int round = 0; round < 50; ++round) {
      const Names kept = make_names(gl), passing = make_names(gl);
      fill(gl, passing, 200);
      draw(gl, passing);
      gl.DeleteLists(passing.list, 1);
      gl.DeleteTextures(1, &passing.texture);
      gl.DeleteBuffers(1, &passing.vertices);
      gl.DeleteBuffers(1, &passing.elements);
      const std::lock_guard guard(mutex);
      given[0].insert(kept.list);
      given[1].insert(kept.texture);
      given[2].insert({kept.vertices, kept.elements});
    }
    lock.lock();
  });
  for (const auto& names : given)
    EXPECT_EQ(std::set<GLuint>(names.begin(), names.end()).size(), names.size());
}

TEST(Threads, WhatOneDeletesOthersDrawOn) {
  CoreContext maker(kSize, kSize);
  for (int round = 0; round < 5; ++round) {
    maker.make_current();
    const Names names = make_names(maker.gl);
    fill(maker.gl, names, 77);
    std::barrier bound(kThreads + 1);
    std::mutex making;
    std::thread deleting([&] {
      std::unique_lock lock(making);
      const std::unique_ptr<CoreContext> context = sharing(maker);
      lock.unlock();
      bound.arrive_and_wait();
      context->gl.DeleteTextures(1, &names.texture);
      context->gl.DeleteBuffers(1, &names.vertices);
      context->gl.DeleteBuffers(1, &names.elements);
      context->gl.DeleteLists(names.list, 1);
      lock.lock();
    });
    in_threads([&](int) {
      std::unique_lock lock(making);
      const std::unique_ptr<CoreContext> context = sharing(maker);
      lock.unlock();
      draw(context->gl, names);
      bound.arrive_and_wait();
      for (int frame = 0; frame < 5; ++frame) {
        context->gl.DrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, nullptr);
        context->gl.Enable(GL_TEXTURE_2D);
        context->gl.Rectf(0, -1, 1, 0);
        context->gl.Disable(GL_TEXTURE_2D);
      }
      const auto now = shades(*context);
      EXPECT_EQ(now[1], 77);
      EXPECT_EQ(now[2], 77);
      lock.lock();
    });
    deleting.join();
  }
}

// A context that several threads ask for is current in one of them at a time.
TEST(Threads, OneIsCurrentInOneThread) {
  CoreContext context(kSize, kSize);
  ASSERT_EQ(legacy_gl_make_current(nullptr), LEGACY_GL_OK);
  std::atomic<int> holders = 0, wins = 0;
  std::barrier start(kThreads);
  in_threads([&](int) {
    start.arrive_and_wait();
    for (int i = 0; i < 300; ++i) {
      const GlFunctions& gl = context.gl;
      if (legacy_gl_make_current(context.handle()) != LEGACY_GL_OK) continue;
      EXPECT_EQ(++holders, 1);
      gl.Color3f(1, 0, 0);
      ++wins;
      --holders;
      EXPECT_EQ(legacy_gl_make_current(nullptr), LEGACY_GL_OK);
    }
  });
  EXPECT_GT(wins, 0);
  EXPECT_EQ(legacy_gl_make_current(context.handle()), LEGACY_GL_OK);
}

}  // namespace
}  // namespace legacy_gl::test
