// What contexts that share see of each other: lists, textures and buffer objects, as GLX shares
// them (GL 2.1 spec D.3); queries are each context's own.
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "support/contexts.hpp"
#include "support/driver_shim.hpp"

namespace legacy_gl::test {
namespace {

constexpr int kSize = 16;

using Pixel = std::array<int, 3>;

Pixel middle(RenderContext& context) {
  const Image image = context.read_rgba8();
  const std::size_t at = (kSize / 2 * kSize + kSize / 2) * 4;
  return {image.bytes[at], image.bytes[at + 1], image.bytes[at + 2]};
}

constexpr Pixel kRed{255, 0, 0}, kGreen{0, 255, 0}, kBlack{0, 0, 0};

/// A square over the whole view, by whatever the name stands for.
struct Kind {
  const char* name;
  GLuint (*make)(const GlFunctions& gl, const Pixel& color);
  void (*change)(const GlFunctions& gl, GLuint name, const Pixel& color);
  void (*bind)(const GlFunctions& gl, GLuint name);
  void (*draw)(const GlFunctions& gl, GLuint name);
  void (*remove)(const GlFunctions& gl, GLuint name);
  GLboolean (*exists)(const GlFunctions& gl, GLuint name);
  bool bound_survives;  ///< a binding in another context keeps a deleted object
};

void compile(const GlFunctions& gl, GLuint name, const Pixel& color) {
  gl.NewList(name, GL_COMPILE);
  gl.Color3f(static_cast<float>(color[0]), static_cast<float>(color[1]), 0);
  gl.Rectf(-1, -1, 1, 1);
  gl.EndList();
}

void fill_texture(const GlFunctions& gl, GLuint name, const Pixel& color) {
  const std::array<GLubyte, 3> texel{static_cast<GLubyte>(color[0]), static_cast<GLubyte>(color[1]),
                                     0};
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, texel.data());
}

void fill_buffer(const GlFunctions& gl, GLuint name, const Pixel& color) {
  std::array<GLfloat, 4 * 5> vertices{};
  for (std::size_t i = 0; i < 4; ++i) {
    GLfloat* const vertex = &vertices[i * 5];
    vertex[0] = i == 0 || i == 3 ? -1.0F : 1.0F;
    vertex[1] = i < 2 ? -1.0F : 1.0F;
    vertex[2] = static_cast<float>(color[0]) / 255;
    vertex[3] = static_cast<float>(color[1]) / 255;
  }
  gl.BindBuffer(GL_ARRAY_BUFFER, name);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices.data(), GL_STATIC_DRAW);
}

const std::array<Kind, 3> kKinds{{
    {"lists",
     [](const GlFunctions& gl, const Pixel& color) {
       const GLuint name = gl.GenLists(1);
       compile(gl, name, color);
       return name;
     },
     compile, [](const GlFunctions&, GLuint) {},
     [](const GlFunctions& gl, GLuint name) { gl.CallList(name); },
     [](const GlFunctions& gl, GLuint name) { gl.DeleteLists(name, 1); },
     [](const GlFunctions& gl, GLuint name) { return gl.IsList(name); }, false},
    {"textures",
     [](const GlFunctions& gl, const Pixel& color) {
       GLuint name = 0;
       gl.GenTextures(1, &name);
       fill_texture(gl, name, color);
       return name;
     },
     fill_texture,
     [](const GlFunctions& gl, GLuint name) {
       gl.BindTexture(GL_TEXTURE_2D, name);
       gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
       gl.Enable(GL_TEXTURE_2D);
     },
     [](const GlFunctions& gl, GLuint) { gl.Rectf(-1, -1, 1, 1); },
     [](const GlFunctions& gl, GLuint name) { gl.DeleteTextures(1, &name); },
     [](const GlFunctions& gl, GLuint name) { return gl.IsTexture(name); }, true},
    {"buffers",
     [](const GlFunctions& gl, const Pixel& color) {
       GLuint name = 0;
       gl.GenBuffers(1, &name);
       fill_buffer(gl, name, color);
       return name;
     },
     fill_buffer,
     [](const GlFunctions& gl, GLuint name) {
       gl.BindBuffer(GL_ARRAY_BUFFER, name);
       gl.VertexPointer(2, GL_FLOAT, 5 * sizeof(GLfloat), nullptr);
       gl.ColorPointer(3, GL_FLOAT, 5 * sizeof(GLfloat),
                       reinterpret_cast<const void*>(2 * sizeof(GLfloat)));
       gl.EnableClientState(GL_VERTEX_ARRAY);
       gl.EnableClientState(GL_COLOR_ARRAY);
     },
     [](const GlFunctions& gl, GLuint) { gl.DrawArrays(GL_QUADS, 0, 4); },
     [](const GlFunctions& gl, GLuint name) { gl.DeleteBuffers(1, &name); },
     [](const GlFunctions& gl, GLuint name) { return gl.IsBuffer(name); }, true},
}};

Pixel drawn(CoreContext& context, const Kind& kind, GLuint name) {
  context.make_current();
  context.gl.Clear(GL_COLOR_BUFFER_BIT);
  kind.draw(context.gl, name);
  const Pixel pixel = middle(context);
  EXPECT_EQ(context.gl.GetError(), GLenum{GL_NO_ERROR}) << kind.name;
  return pixel;
}

CoreContext sharing(const CoreContext& other) {
  return CoreContext(kSize, kSize, PixelFormat::rgba8, {}, {.shares = &other});
}

// Two contexts that share, and what the first has made.
struct Pair {
  CoreContext maker{kSize, kSize};
  CoreContext user = sharing(maker);
  GLuint name = 0;

  explicit Pair(const Kind& kind) {
    maker.make_current();
    name = kind.make(maker.gl, kRed);
  }
};

TEST(Sharing, WhatOneMakesTheOtherDraws) {
  for (const Kind& kind : kKinds) {
    Pair pair(kind);
    auto& [maker, user, name] = pair;
    user.make_current();
    EXPECT_EQ(kind.exists(user.gl, name), GL_TRUE) << kind.name;
    kind.bind(user.gl, name);
    EXPECT_EQ(drawn(user, kind, name), kRed) << kind.name;
  }
}

TEST(Sharing, WhatOneChangesTheOtherSees) {
  for (const Kind& kind : kKinds) {
    Pair pair(kind);
    auto& [maker, user, name] = pair;
    user.make_current();
    kind.bind(user.gl, name);
    EXPECT_EQ(drawn(user, kind, name), kRed) << kind.name;
    maker.make_current();
    kind.change(maker.gl, name, kGreen);
    maker.gl.Finish();
    user.make_current();
    kind.bind(user.gl, name);
    EXPECT_EQ(drawn(user, kind, name), kGreen) << kind.name;
  }
}

// GL 2.1 spec D.3: the name is gone for both at once, the object when nobody has it bound.
TEST(Sharing, WhatOneDeletesLivesWhereItIsBound) {
  for (const Kind& kind : kKinds) {
    Pair pair(kind);
    auto& [maker, user, name] = pair;
    user.make_current();
    kind.bind(user.gl, name);
    maker.make_current();
    kind.remove(maker.gl, name);
    user.make_current();
    EXPECT_EQ(kind.exists(user.gl, name), GL_FALSE) << kind.name;
    EXPECT_EQ(drawn(user, kind, name), kind.bound_survives ? kRed : kBlack) << kind.name;
    maker.make_current();
    kind.make(maker.gl, kGreen);  // perhaps of the same name: another object
    EXPECT_EQ(drawn(user, kind, name), kind.bound_survives ? kRed : kGreen) << kind.name;
  }
}

TEST(Sharing, NamesOfOneAreNotGivenToTheOther) {
  for (const Kind& kind : kKinds) {
    Pair pair(kind);
    pair.user.make_current();
    EXPECT_NE(kind.make(pair.user.gl, kRed), pair.name) << kind.name;
  }
}

TEST(Sharing, ObjectsOutliveTheirMaker) {
  for (const Kind& kind : kKinds) {
    auto maker = std::make_unique<CoreContext>(kSize, kSize);
    CoreContext user = sharing(*maker);
    maker->make_current();
    const GLuint name = kind.make(maker->gl, kRed);
    maker->gl.Finish();
    maker.reset();
    user.make_current();
    kind.bind(user.gl, name);
    EXPECT_EQ(drawn(user, kind, name), kRed) << kind.name;
  }
}

TEST(Sharing, QueriesAreEachContextsOwn) {
  CoreContext maker(kSize, kSize), user = sharing(maker);
  maker.make_current();
  maker.gl.BeginQuery(GL_SAMPLES_PASSED, 5);
  maker.gl.EndQuery(GL_SAMPLES_PASSED);
  EXPECT_EQ(maker.gl.IsQuery(5), GL_TRUE);
  user.make_current();
  EXPECT_EQ(user.gl.IsQuery(5), GL_FALSE);
}

/// The driver's objects of one kind that were made and not deleted.
class Living : public DriverObserver {
 public:
  bool before(const DriverCall& call) override {
    const std::string name = call.name;
    if (name.starts_with("glDelete")) count(name.substr(8), call, -1);
    return true;
  }
  void after(const DriverCall& call) override {
    const std::string name = call.name;
    if (name.starts_with("glGen") && name != "glGenerateMipmap") count(name.substr(5), call, 1);
  }
  std::map<std::string, std::multiset<GLuint>> names;
  int outside_of_any_context = 0;
  bool expects_none = false;

 private:
  void count(const std::string& kind, const DriverCall& call, int sign) {
    if (kind == "Program" || kind == "Shader" || kind == "Sync") return;
    const auto* const list = reinterpret_cast<const GLuint*>(call.argument(1));
    for (std::uint64_t i = 0; i < call.argument(0); ++i) {
      if (sign > 0) names[kind].insert(list[i]);
      else if (list[i] && names[kind].erase(list[i]) == 0) ++unknown;
    }
    if (expects_none) ++outside_of_any_context;
  }

 public:
  int unknown = 0;  ///< deleted and not living
};

CoreContext shimmed(const CoreContext* shares = nullptr) {
  return CoreContext(kSize, kSize, PixelFormat::rgba8, {},
                     {.loader = shimmed_proc, .shares = shares});
}

TEST(Sharing, NothingIsLeftInTheDriver) {
  Living living;
  {
    CoreContext maker = shimmed(), user = shimmed(&maker);
    for (const Kind& kind : kKinds) {
      maker.make_current();
      const GLuint kept = kind.make(maker.gl, kRed), deleted = kind.make(maker.gl, kRed);
      user.make_current();
      for (const GLuint name : {deleted, kept}) {
        kind.bind(user.gl, name);
        drawn(user, kind, name);
      }
      kind.bind(user.gl, deleted);
      maker.make_current();
      kind.remove(maker.gl, deleted);
    }
  }
  for (const auto& [kind, names] : living.names) EXPECT_EQ(names.size(), 0u) << kind;
  EXPECT_EQ(living.unknown, 0);
}

// The last owner of a texture or buffer may be dropped where no driver context is current: nothing
// is deleted there, but by the next context that is.
TEST(Sharing, LastOwnerWithoutADriverContextDeletesNothing) {
  Living living;
  CoreContext maker = shimmed(), user = shimmed(&maker);
  maker.make_current();
  GLuint texture = kKinds[1].make(maker.gl, kRed);
  const std::size_t before = living.names["Textures"].size();
  user.make_current();
  user.gl.BindTexture(GL_TEXTURE_2D, texture);
  maker.make_current();
  maker.gl.DeleteTextures(1, &texture);
  EXPECT_EQ(living.names["Textures"].size(), before) << "it is bound in the other context";
  user.make_current();
  OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  living.expects_none = true;
  user.gl.BindTexture(GL_TEXTURE_2D, 0);
  living.expects_none = false;
  EXPECT_EQ(living.outside_of_any_context, 0);
  maker.make_current();
  maker.gl.Finish();
  EXPECT_EQ(living.names["Textures"].size(), before - 1);
}

// glDeleteLists frees what the driver has of the lists with the next flush, however many there are.
TEST(Sharing, DeletedListsAreFreedWithTheNextFlush) {
  Living living;
  CoreContext context = shimmed();
  const auto buffers = [&] { return living.names["Buffers"].size(); };
  for (const int count : {1, 60}) {
    drawn(context, kKinds[0], kKinds[0].make(context.gl, kRed));
    const GLuint first = context.gl.GenLists(count);
    const std::size_t before = buffers();
    for (GLuint list = first; list < first + static_cast<GLuint>(count); ++list) {
      context.gl.NewList(list, GL_COMPILE);
      context.gl.Begin(GL_TRIANGLES);
      for (int i = 0; i < 999; ++i)
        context.gl.Vertex2f(static_cast<float>(i) / 999, static_cast<float>(i % 5) / 5);
      context.gl.End();
      context.gl.EndList();
      context.gl.CallList(list);
    }
    context.gl.Finish();
    EXPECT_GE(buffers(), before + static_cast<std::size_t>(count));
    context.gl.DeleteLists(first, count);
    legacy_gl_flush();
    EXPECT_EQ(buffers(), before) << count;
  }
}

}  // namespace
}  // namespace legacy_gl::test
