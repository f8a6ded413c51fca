// Windows and contexts of the drop-in for tests, made as old programs make them.
#pragma once

// X's macros (None, Bool) come after the headers that use these words.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>
#include <thread>

#include <GL/glx.h>

namespace legacy_gl::test {

// One connection to the X server for the whole process.
inline Display* display() {
  static Display* const connection = [] {
    XInitThreads();
    return XOpenDisplay(nullptr);
  }();
  return connection;
}

inline XVisualInfo* choose_visual() {
  int attributes[] = {
      GLX_RGBA, GLX_DOUBLEBUFFER, GLX_RED_SIZE, 8,   GLX_GREEN_SIZE, 8, GLX_BLUE_SIZE,
      8,        GLX_DEPTH_SIZE,   16,           None};
  return glXChooseVisual(display(), DefaultScreen(display()), attributes);
}

class Window {
 public:
  explicit Window(unsigned width = 64, unsigned height = 48) : visual(choose_visual()) {
    const ::Window root = RootWindow(display(), visual->screen);
    XSetWindowAttributes attributes{};
    attributes.colormap = XCreateColormap(display(), root, visual->visual, AllocNone);
    attributes.event_mask = StructureNotifyMask;
    name = XCreateWindow(display(), root, 0, 0, width, height, 0, visual->depth, InputOutput,
                         visual->visual, CWColormap | CWEventMask | CWBorderPixel, &attributes);
    XMapWindow(display(), name);
    XSync(display(), False);
  }
  ~Window() {
    XDestroyWindow(display(), name);
    XFree(visual);
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  XVisualInfo* visual;
  ::Window name = None;
};

// A context as glXCreateContext makes it, current in the window.
class OldContext {
 public:
  explicit OldContext(const Window& window, GLXContext share = nullptr)
      : name(glXCreateContext(display(), window.visual, share, True)) {
    EXPECT_NE(name, nullptr);
    EXPECT_TRUE(glXMakeCurrent(display(), window.name, name));
  }
  ~OldContext() {
    glXMakeCurrent(display(), None, nullptr);
    if (name) glXDestroyContext(display(), name);
  }
  OldContext(const OldContext&) = delete;
  OldContext& operator=(const OldContext&) = delete;

  GLXContext name;
};

inline std::string version() {
  const GLubyte* const text = glGetString(GL_VERSION);
  return text ? reinterpret_cast<const char*>(text) : "";
}

// Fills the whole view by fixed function: a lit square with an emission of that colour.
inline void draw_lit_square(float red, float green, float blue) {
  const GLfloat emission[] = {red, green, blue, 1};
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, emission);
  glEnable(GL_LIGHTING);
  glBegin(GL_QUADS);
  glVertex2f(-1, -1);
  glVertex2f(1, -1);
  glVertex2f(1, 1);
  glVertex2f(-1, 1);
  glEnd();
}

// The emission, with the light model's ambient light of 0.2 times the material's of 0.2 on top.
inline std::array<int, 3> lit(float red, float green, float blue) {
  const auto channel = [](float emission) {
    const float sum = emission + 0.04f;
    return static_cast<int>((sum < 1 ? sum : 1) * 255 + 0.5f);
  };
  return {channel(red), channel(green), channel(blue)};
}

inline std::array<int, 3> pixel(GLint x, GLint y) {
  std::array<GLubyte, 4> rgba{};
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return {rgba[0], rgba[1], rgba[2]};
}

}  // namespace legacy_gl::test
