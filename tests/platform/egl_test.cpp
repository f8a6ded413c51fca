// The drop-in by EGL, on the surfaceless platform: OpenGL contexts are ours, OpenGL ES contexts the
// driver's.
#include "platform/window.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace legacy_gl::test {
namespace {

// With MESA_GL_VERSION_OVERRIDE=2.1.
TEST(OldDriver, GivesNoContextByEgl) {
  const EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  ASSERT_TRUE(eglInitialize(display, nullptr, nullptr));
  const EGLint attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  ASSERT_TRUE(eglChooseConfig(display, attributes, &config, 1, &count));
  eglBindAPI(EGL_OPENGL_API);
  EXPECT_EQ(eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr), EGL_NO_CONTEXT);
  EXPECT_NE(eglGetError(), EGL_SUCCESS);
}

class Egl : public testing::Test {
 protected:
  void SetUp() override {
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    ASSERT_TRUE(eglInitialize(display_, nullptr, nullptr));
    const EGLint attributes[] = {
        EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RED_SIZE, 8,       EGL_RENDERABLE_TYPE,
        EGL_OPENGL_BIT,   EGL_DEPTH_SIZE,  16,           EGL_NONE};
    EGLint count = 0;
    ASSERT_TRUE(eglChooseConfig(display_, attributes, &config_, 1, &count));
    ASSERT_EQ(count, 1);
    const EGLint size[] = {EGL_WIDTH, 32, EGL_HEIGHT, 24, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display_, config_, size);
    ASSERT_NE(surface_, EGL_NO_SURFACE);
  }
  void TearDown() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroySurface(display_, surface_);
  }
  EGLContext create(EGLenum api, const EGLint* attributes, EGLContext share = EGL_NO_CONTEXT) {
    eglBindAPI(api);
    const EGLContext context = eglCreateContext(display_, config_, share, attributes);
    EXPECT_NE(context, EGL_NO_CONTEXT);
    EXPECT_TRUE(eglMakeCurrent(display_, surface_, surface_, context));
    return context;
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLConfig config_ = nullptr;
  EGLSurface surface_ = EGL_NO_SURFACE;
};

TEST_F(Egl, OpenGlContextDrawsByFixedFunction) {
  const EGLContext context = create(EGL_OPENGL_API, nullptr);
  EXPECT_EQ(version().substr(0, 3), "1.5") << version();
  draw_lit_square(0.5f, 0.25f, 0.125f);
  EXPECT_EQ(pixel(10, 10), lit(0.5f, 0.25f, 0.125f));
  EXPECT_TRUE(eglSwapBuffers(display_, surface_));
  EXPECT_TRUE(eglDestroyContext(display_, context)) << "while it is current";
}

TEST_F(Egl, EsContextIsTheDriversOwn) {
  const EGLint version_2[] = {EGL_CONTEXT_MAJOR_VERSION, 2, EGL_NONE};
  const EGLContext context = create(EGL_OPENGL_ES_API, version_2);
  EXPECT_EQ(version().substr(0, 9), "OpenGL ES") << version();
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context);
}

TEST_F(Egl, ListsAreShared) {
  const EGLContext first = create(EGL_OPENGL_API, nullptr);
  glNewList(7, GL_COMPILE);
  draw_lit_square(0, 0.5f, 0);
  glEndList();
  const EGLContext second = create(EGL_OPENGL_API, nullptr, first);
  EXPECT_TRUE(eglDestroyContext(display_, first)) << "while another one is current";
  EXPECT_EQ(eglGetCurrentContext(), second);
  glCallList(7);
  EXPECT_EQ(pixel(3, 3), lit(0, 0.5f, 0));
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  EXPECT_TRUE(eglDestroyContext(display_, second));
}

TEST_F(Egl, FunctionsAreFoundByName) {
  create(EGL_OPENGL_API, nullptr);
  for (const char* const name : {"glLightfv", "glBegin", "eglSwapBuffers", "glUseProgram"})
    EXPECT_NE(eglGetProcAddress(name), nullptr) << name;
  EXPECT_TRUE(eglReleaseThread());
  EXPECT_EQ(glGetString(GL_VERSION), nullptr);
}

}  // namespace
}  // namespace legacy_gl::test
