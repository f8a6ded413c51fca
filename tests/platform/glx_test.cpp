// The drop-in libGL.so.1 by GLX, as an old program uses it. The driver is told to have no fixed
// function (MESA_GL_VERSION_OVERRIDE=4.5FC), so whatever is drawn is ours.
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>

#include "platform/window.hpp"

#include <GL/glxext.h>

namespace legacy_gl::test {
namespace {

GLXFBConfig config_of(const Window& window) {
  int count = 0;
  GLXFBConfig* const configs = glXGetFBConfigs(display(), window.visual->screen, &count);
  GLXFBConfig found = nullptr;
  for (int i = 0; i < count && !found; ++i) {
    int id = 0;
    glXGetFBConfigAttrib(display(), configs[i], GLX_VISUAL_ID, &id);
    if (static_cast<VisualID>(id) == window.visual->visualid) found = configs[i];
  }
  XFree(configs);
  return found;
}

GLXContext create_with(const Window& window, const int* attributes) {
  const auto create = reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(
      glXGetProcAddress(reinterpret_cast<const GLubyte*>("glXCreateContextAttribsARB")));
  return create(display(), config_of(window), nullptr, True, attributes);
}

template <typename Function>
Function function(const char* name) {
  return reinterpret_cast<Function>(glXGetProcAddressARB(reinterpret_cast<const GLubyte*>(name)));
}

TEST(Glx, ContextOfAVisualDrawsByFixedFunction) {
  const Window window;
  const OldContext context(window);
  EXPECT_EQ(version().substr(0, 3), "1.5") << version();
  draw_lit_square(0.5f, 0.25f, 0);
  EXPECT_EQ(pixel(10, 10), lit(0.5f, 0.25f, 0));
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST(Glx, ViewportStartsAsTheWindow) {
  const Window window(80, 30);
  const OldContext context(window);
  std::array<GLint, 4> box{};
  glGetIntegerv(GL_VIEWPORT, box.data());
  EXPECT_EQ(box, (std::array<GLint, 4>{0, 0, 80, 30}));
}

TEST(Glx, ResizedWindowIsDrawnWhole) {
  const Window window(40, 40);
  const OldContext context(window);
  draw_lit_square(0.5f, 0, 0);
  glXSwapBuffers(display(), window.name);
  XResizeWindow(display(), window.name, 90, 70);
  XSync(display(), False);
  glViewport(0, 0, 90, 70);
  draw_lit_square(0, 0.5f, 0);
  glXSwapBuffers(display(), window.name);
  glClear(GL_COLOR_BUFFER_BIT);
  draw_lit_square(0, 0, 0.5f);
  EXPECT_EQ(pixel(88, 68), lit(0, 0, 0.5f));
}

TEST(Glx, SwapShowsWhatWasRecorded) {
  const Window window;
  const OldContext context(window);
  draw_lit_square(0.75f, 0, 0);
  glXSwapBuffers(display(), window.name);
  XImage* const image = XGetImage(display(), window.name, 5, 5, 1, 1, AllPlanes, ZPixmap);
  ASSERT_NE(image, nullptr);
  EXPECT_EQ((XGetPixel(image, 0, 0) >> 16) & 255u, static_cast<unsigned long>(lit(0.75f, 0, 0)[0]));
  XDestroyImage(image);
}

TEST(Glx, FrontBufferIsDrawnAtFlush) {
  const Window window;
  const OldContext context(window);
  glDrawBuffer(GL_FRONT);
  draw_lit_square(0, 0.75f, 0);
  glFlush();
  glXWaitGL();
  XImage* const image = XGetImage(display(), window.name, 5, 5, 1, 1, AllPlanes, ZPixmap);
  ASSERT_NE(image, nullptr);
  EXPECT_EQ((XGetPixel(image, 0, 0) >> 8) & 255u, static_cast<unsigned long>(lit(0, 0.75f, 0)[1]));
  XDestroyImage(image);
}

TEST(Glx, NewContextAndOldVersionsAreOurs) {
  const Window window;
  const int asks_for_2_1[] = {GLX_CONTEXT_MAJOR_VERSION_ARB, 2, GLX_CONTEXT_MINOR_VERSION_ARB, 1,
                              None};
  const int asks_for_compatibility[] = {GLX_CONTEXT_MAJOR_VERSION_ARB,
                                        3,
                                        GLX_CONTEXT_MINOR_VERSION_ARB,
                                        3,
                                        GLX_CONTEXT_PROFILE_MASK_ARB,
                                        GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB,
                                        None};
  for (const GLXContext context :
       {glXCreateNewContext(display(), config_of(window), GLX_RGBA_TYPE, nullptr, True),
        create_with(window, asks_for_2_1), create_with(window, asks_for_compatibility)}) {
    ASSERT_NE(context, nullptr);
    ASSERT_TRUE(glXMakeContextCurrent(display(), window.name, window.name, context));
    EXPECT_EQ(version().substr(0, 3), "1.5");
    draw_lit_square(0.5f, 0.5f, 0);
    EXPECT_EQ(pixel(3, 3), lit(0.5f, 0.5f, 0));
    glXMakeCurrent(display(), None, nullptr);
    glXDestroyContext(display(), context);
  }
}

TEST(Glx, CoreContextIsTheDriversOwn) {
  const Window window;
  const int asks_for_core[] = {GLX_CONTEXT_MAJOR_VERSION_ARB,
                               3,
                               GLX_CONTEXT_MINOR_VERSION_ARB,
                               3,
                               GLX_CONTEXT_PROFILE_MASK_ARB,
                               GLX_CONTEXT_CORE_PROFILE_BIT_ARB,
                               None};
  const GLXContext context = create_with(window, asks_for_core);
  ASSERT_NE(context, nullptr);
  ASSERT_TRUE(glXMakeCurrent(display(), window.name, context));
  EXPECT_NE(version().find("Mesa"), std::string::npos) << version();
  EXPECT_EQ(version().find("legacy_gl"), std::string::npos);
  glBegin(GL_TRIANGLES);  // which it does not have
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
  glXMakeCurrent(display(), None, nullptr);
  glXDestroyContext(display(), context);
}

TEST(Glx, ListsAreSharedAndOutliveTheirContext) {
  const Window window;
  GLuint list = 0;
  auto first = std::make_unique<OldContext>(window);
  list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  draw_lit_square(0.25f, 0.5f, 0.75f);
  glEndList();
  const OldContext second(window, first->name);
  // `first` is not current: what we hold for it goes, and `second` stays current.
  glXDestroyContext(display(), first->name);
  first->name = nullptr;
  EXPECT_TRUE(glIsList(list));
  glCallList(list);
  EXPECT_EQ(pixel(10, 10), lit(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(glXGetCurrentContext(), second.name);
}

TEST(Glx, ContextDestroyedWhileCurrentDrawsOn) {
  const Window window;
  const GLXContext context = glXCreateContext(display(), window.visual, nullptr, True);
  ASSERT_TRUE(glXMakeCurrent(display(), window.name, context));
  glXDestroyContext(display(), context);
  draw_lit_square(0, 0.5f, 0.5f);
  EXPECT_EQ(pixel(1, 1), lit(0, 0.5f, 0.5f));
  EXPECT_TRUE(glXMakeCurrent(display(), None, nullptr));
  EXPECT_EQ(glGetString(GL_VERSION), nullptr);
}

TEST(Glx, TwoContextsTakeTurns) {
  const Window window_a, window_b;
  const OldContext a(window_a);
  draw_lit_square(0.5f, 0, 0);
  const OldContext b(window_b);
  draw_lit_square(0, 0, 0.5f);
  EXPECT_EQ(pixel(2, 2), lit(0, 0, 0.5f));
  ASSERT_TRUE(glXMakeCurrent(display(), window_a.name, a.name));
  EXPECT_EQ(pixel(2, 2), lit(0.5f, 0, 0)) << "drawn when the context was left";
}

TEST(Glx, ThreadsDrawSideBySide) {
  const auto work = [](float blue) {
    const Window window;
    const OldContext context(window);
    for (int i = 0; i < 50; ++i) {
      draw_lit_square(0, 0, blue);
      EXPECT_EQ(pixel(4, 4), lit(0, 0, blue));
    }
  };
  std::thread other(work, 0.25f);
  work(0.75f);
  other.join();
}

TEST(Glx, FunctionsAreFoundByName) {
  const Window window;
  const OldContext context(window);
  const auto find = [](const char* name) {
    return glXGetProcAddressARB(reinterpret_cast<const GLubyte*>(name));
  };
  for (const char* const name :
       {"glLightfv", "glActiveTextureARB", "glMultiTexCoord2fARB", "glBindBufferARB",
        "glUseProgram", "glXSwapBuffers", "glXCreateContextAttribsARB", "glXSwapIntervalSGI"})
    EXPECT_NE(find(name), nullptr) << name;
  const auto begin = reinterpret_cast<void (*)(GLenum)>(find("glBegin"));
  begin(GL_TRIANGLES);
  glVertex2f(0, 0);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

// Programs of OpenGL 1.5 know framebuffer objects by their first extension.
TEST(Glx, FramebufferObjectsOfTheFirstExtension) {
  const Window window;
  const OldContext context(window);
  const std::string extensions = reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS));
  for (const char* const name :
       {"GL_EXT_framebuffer_object", "GL_EXT_framebuffer_blit", "GL_EXT_packed_depth_stencil"})
    EXPECT_NE(extensions.find(name), std::string::npos) << name;
  std::array<GLuint, 2> textures{};
  glGenTextures(2, textures.data());
  const GLuint texture = textures[1];  // the driver's first
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  const auto bind_framebuffer = function<PFNGLBINDFRAMEBUFFEREXTPROC>("glBindFramebufferEXT");
  const auto bind_renderbuffer = function<PFNGLBINDRENDERBUFFEREXTPROC>("glBindRenderbufferEXT");
  GLuint generated = 0;
  function<PFNGLGENFRAMEBUFFERSEXTPROC>("glGenFramebuffersEXT")(1, &generated);
  bind_framebuffer(GL_FRAMEBUFFER_EXT, generated);
  // Names that nobody generated are as good.
  const GLuint chosen = generated + 7;
  bind_framebuffer(GL_FRAMEBUFFER_EXT, chosen);
  GLint bound = 0;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING_EXT, &bound);
  EXPECT_EQ(static_cast<GLuint>(bound), chosen);
  bind_renderbuffer(GL_RENDERBUFFER_EXT, 5);
  function<PFNGLRENDERBUFFERSTORAGEEXTPROC>("glRenderbufferStorageEXT")(GL_RENDERBUFFER_EXT,
                                                                        GL_DEPTH_COMPONENT, 16, 16);
  function<PFNGLFRAMEBUFFERRENDERBUFFEREXTPROC>("glFramebufferRenderbufferEXT")(
      GL_FRAMEBUFFER_EXT, GL_DEPTH_ATTACHMENT_EXT, GL_RENDERBUFFER_EXT, 5);
  function<PFNGLFRAMEBUFFERTEXTURE2DEXTPROC>("glFramebufferTexture2DEXT")(
      GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D, texture, 0);
  EXPECT_EQ(function<PFNGLCHECKFRAMEBUFFERSTATUSEXTPROC>("glCheckFramebufferStatusEXT")(
                GL_FRAMEBUFFER_EXT),
            static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE_EXT));
  GLint attached = 0;
  function<PFNGLGETFRAMEBUFFERATTACHMENTPARAMETERIVEXTPROC>(
      "glGetFramebufferAttachmentParameterivEXT")(GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT,
                                                  GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME_EXT,
                                                  &attached);
  EXPECT_EQ(static_cast<GLuint>(attached), texture);
  draw_lit_square(0.25f, 0.5f, 0.75f);
  EXPECT_EQ(pixel(10, 10), lit(0.25f, 0.5f, 0.75f));
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  // Where alpha lies in another channel than a fragment's, nothing can be drawn.
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE_ALPHA, 16, 16, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  function<PFNGLFRAMEBUFFERTEXTURE2DEXTPROC>("glFramebufferTexture2DEXT")(
      GL_FRAMEBUFFER_EXT, GL_COLOR_ATTACHMENT0_EXT, GL_TEXTURE_2D, texture, 0);
  EXPECT_EQ(function<PFNGLCHECKFRAMEBUFFERSTATUSEXTPROC>("glCheckFramebufferStatusEXT")(
                GL_FRAMEBUFFER_EXT),
            static_cast<GLenum>(GL_FRAMEBUFFER_UNSUPPORTED_EXT));
  bind_framebuffer(GL_FRAMEBUFFER_EXT, 0);
}

TEST(Faults, CallsWithoutAContextDoNothing) {
  ASSERT_EQ(glXGetCurrentContext(), nullptr);
  const GLfloat color[] = {1, 1, 1, 1};
  glLightfv(GL_LIGHT0, GL_DIFFUSE, color);
  glBegin(GL_TRIANGLES);
  glVertex3f(0, 0, 0);
  glEnd();
  glClear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(glGetString(GL_VERSION), nullptr);
}

TEST(Faults, CallsInsideBeginEndRaiseAnError) {
  const Window window;
  const OldContext context(window);
  glBegin(GL_TRIANGLES);
  glEnable(GL_LIGHTING);
  glXSwapBuffers(display(), window.name);
  glFlush();
  glEnd();
  EXPECT_EQ(glGetError(), GLenum{GL_INVALID_OPERATION});
  glDisable(GL_LIGHTING);
  draw_lit_square(0.5f, 0.5f, 0.5f);
  EXPECT_EQ(pixel(10, 10), lit(0.5f, 0.5f, 0.5f));
}

// As Mesa, which programs were written on, takes it.
TEST(Glx, ScalarsForVectorsRaiseNoError) {
  const Window window;
  const OldContext context(window);
  glMaterialf(GL_FRONT, GL_AMBIENT, 0.5f);
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

TEST(Faults, TenThousandLists) {
  const Window window;
  const OldContext context(window);
  const GLuint first = glGenLists(10000);
  ASSERT_NE(first, 0u);
  for (GLuint i = 0; i < 10000; ++i) {
    glNewList(first + i, GL_COMPILE);
    draw_lit_square(0, static_cast<float>(i) / 10000, 0);
    glEndList();
  }
  for (GLuint i = 0; i < 10000; i += 100) glCallList(first + i);
  glCallList(first + 9999);
  EXPECT_EQ(pixel(10, 10), lit(0, 0.9999f, 0));
  glDeleteLists(first, 10000);
  EXPECT_FALSE(glIsList(first));
}

TEST(Faults, ForkedChildMayExit) {
  const Window window;
  const OldContext context(window);
  draw_lit_square(0.5f, 0, 0.5f);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    glColor3f(1, 0, 0);
    _exit(glGetError() == GL_NO_ERROR ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(pixel(10, 10), lit(0.5f, 0, 0.5f));
}

TEST(Faults, ContextOfAnotherThreadIsRefused) {
  const Window window;
  const OldContext context(window);
  std::thread([&] {
    const Window own_window;
    const OldContext own(own_window);
    EXPECT_FALSE(glXMakeCurrent(display(), own_window.name, context.name));
    draw_lit_square(0, 0.5f, 0);
    EXPECT_EQ(pixel(10, 10), lit(0, 0.5f, 0)) << "its own stays current";
  }).join();
  draw_lit_square(0.5f, 0, 0);
  EXPECT_EQ(pixel(10, 10), lit(0.5f, 0, 0));
}

TEST(Faults, ContextsThatShareGoInAnyOrder) {
  const Window window;
  auto first = std::make_unique<OldContext>(window);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  const std::array<GLubyte, 4> texel{255, 0, 255, 255};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
  const auto second = std::make_unique<OldContext>(window, first->name);
  first.reset();  // which makes none current
  ASSERT_TRUE(glXMakeCurrent(display(), window.name, second->name));
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glEnable(GL_TEXTURE_2D);
  draw_lit_square(0, 0, 0);
  EXPECT_EQ(pixel(10, 10), (std::array<int, 3>{255, 0, 255}));
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

// LEGACY_GL_CACHE_DIR: compiled programs outlive the process.
TEST(Glx, ProgramsAreKeptInTheDirectoryOfTheEnvironment) {
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("legacy_gl_cache_" + std::to_string(getpid()));
  setenv("LEGACY_GL_CACHE_DIR", directory.c_str(), 1);
  {
    const Window window;
    const OldContext context(window);
    draw_lit_square(0.5f, 0.25f, 0);
    EXPECT_EQ(pixel(10, 10), lit(0.5f, 0.25f, 0));
  }
  unsetenv("LEGACY_GL_CACHE_DIR");
  EXPECT_FALSE(std::filesystem::is_empty(directory));
  std::filesystem::remove_all(directory);
}

// With MESA_GL_VERSION_OVERRIDE=2.1.
TEST(OldDriver, GivesNoContextAndSaysWhy) {
  const Window window;
  testing::internal::CaptureStderr();
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(glXCreateContext(display(), window.visual, nullptr, True), nullptr);
  const std::string said = testing::internal::GetCapturedStderr();
  const std::size_t at = said.find("no OpenGL 3.3 core context");
  EXPECT_NE(at, std::string::npos) << said;
  EXPECT_EQ(said.find("no OpenGL 3.3 core context", at + 1), std::string::npos) << "once";
  glColor3f(1, 0, 0);  // programs that do not look at what they got
}

}  // namespace
}  // namespace legacy_gl::test
