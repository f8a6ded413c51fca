// The glX names of the drop-in: contexts of OpenGL before 3.1 become core contexts with ours on
// top, everything else is the driver's.
#include <GL/glx.h>
#include <GL/glxext.h>

#include <cstdio>
#include <cstring>
#include <vector>

#include "platform/drop_in_context.hpp"
#include "platform/export.hpp"

using namespace legacy_gl::platform;

namespace {

template <typename Function>
Function driver(const char* name) {
  const auto function = reinterpret_cast<Function>(find_glx(name));
  if (!function) report_missing(name);
  return function;
}
#define DRIVER(name) driver<decltype(&(name))>(#name)

int ignore_error(Display*, XErrorEvent*) { return 0; }

/// Errors of the X server while it lives are the caller's to see by another sign, and do not end
/// the program.
class ErrorTrap {
 public:
  explicit ErrorTrap(Display* display) : display_(display) {
    XSync(display, False);
    before_ = XSetErrorHandler(&ignore_error);
  }
  ~ErrorTrap() {
    XSync(display_, False);
    XSetErrorHandler(before_);
  }
  ErrorTrap(const ErrorTrap&) = delete;
  ErrorTrap& operator=(const ErrorTrap&) = delete;

 private:
  Display* display_;
  XErrorHandler before_;
};

/// The attributes of glXCreateContextAttribsARB, pairs that None ends.
struct Attributes {
  std::vector<int> others;
  int major = 1, minor = 0;
  int profile = GLX_CONTEXT_CORE_PROFILE_BIT_ARB;

  explicit Attributes(const int* list) {
    for (; list && list[0] != None; list += 2) {
      switch (list[0]) {
        case GLX_CONTEXT_MAJOR_VERSION_ARB: major = list[1]; break;
        case GLX_CONTEXT_MINOR_VERSION_ARB: minor = list[1]; break;
        case GLX_CONTEXT_PROFILE_MASK_ARB: profile = list[1]; break;
        default: others.insert(others.end(), {list[0], list[1]});
      }
    }
  }
  bool asks_for_legacy() const {
    if (profile & GLX_CONTEXT_ES2_PROFILE_BIT_EXT) return false;
    if (major < 3 || (major == 3 && minor < 1)) return true;
    return profile == GLX_CONTEXT_COMPATIBILITY_PROFILE_BIT_ARB;
  }
};

bool has_accumulation_buffer(Display* display, GLXFBConfig config) {
  int bits = 0;
  DRIVER(glXGetFBConfigAttrib)(display, config, GLX_ACCUM_RED_SIZE, &bits);
  return bits > 0;
}

GLXContext create_core(Display* display, GLXFBConfig config, GLXContext share, Bool direct,
                       std::vector<int> attributes = {}) {
  const auto create =
      reinterpret_cast<PFNGLXCREATECONTEXTATTRIBSARBPROC>(find_glx("glXCreateContextAttribsARB"));
  if (!create || !config) return nullptr;
  attributes.insert(attributes.end(),
                    {GLX_CONTEXT_MAJOR_VERSION_ARB, 3, GLX_CONTEXT_MINOR_VERSION_ARB, 3,
                     GLX_CONTEXT_PROFILE_MASK_ARB, GLX_CONTEXT_CORE_PROFILE_BIT_ARB, None});
  GLXContext context = nullptr;
  {
    const ErrorTrap trap(display);
    context = create(display, config, share, direct, attributes.data());
  }
  if (context) adopt(context, share, has_accumulation_buffer(display, config));
  else report_old_driver();
  return context;
}

GLXFBConfig config_of_visual(Display* display, const XVisualInfo& visual) {
  int count = 0;
  GLXFBConfig* const configs = DRIVER(glXGetFBConfigs)(display, visual.screen, &count);
  GLXFBConfig found = nullptr;
  for (int i = 0; i < count && !found; ++i) {
    int id = 0;
    DRIVER(glXGetFBConfigAttrib)(display, configs[i], GLX_VISUAL_ID, &id);
    if (static_cast<VisualID>(id) == visual.visualid) found = configs[i];
  }
  if (configs) XFree(configs);
  return found;
}

legacy_gl_proc load(const char* name) { return find_gl(name); }

bool make_current(Display* display, GLXDrawable draw, GLXDrawable read, GLXContext context) {
  const auto driver_function = DRIVER(glXMakeContextCurrent);
  return driver_function && switch_to(context, &load, [&] {
           return driver_function(display, draw, read, context) != False;
         });
}

Function find_function(const char* name) {
  if (const Function ours = find_exported(name)) return ours;
  return std::strncmp(name, "glX", 3) == 0 ? find_glx(name) : find_gl(name);
}

}  // namespace

LEGACY_GL_EXPORT GLXContext glXCreateContext(Display* dpy, XVisualInfo* vis, GLXContext shareList,
                                             Bool direct) {
  if (!vis) return nullptr;
  if (const GLXFBConfig config = config_of_visual(dpy, *vis))
    return create_core(dpy, config, shareList, direct);
  std::fprintf(stderr, "legacy_gl: glXCreateContext: visual 0x%lx is not one for OpenGL\n",
               vis->visualid);
  return nullptr;
}

LEGACY_GL_EXPORT GLXContext glXCreateNewContext(Display* dpy, GLXFBConfig config, int renderType,
                                                GLXContext shareList, Bool direct) {
  if (renderType != GLX_RGBA_TYPE)
    return DRIVER(glXCreateNewContext)(dpy, config, renderType, shareList, direct);
  return create_core(dpy, config, shareList, direct);
}

LEGACY_GL_EXPORT GLXContext glXCreateContextWithConfigSGIX(Display* dpy, GLXFBConfigSGIX config,
                                                           int render_type, GLXContext share_list,
                                                           Bool direct) {
  return glXCreateNewContext(dpy, config, render_type, share_list, direct);
}

LEGACY_GL_EXPORT GLXContext glXCreateContextAttribsARB(Display* dpy, GLXFBConfig config,
                                                       GLXContext share_context, Bool direct,
                                                       const int* attrib_list) {
  Attributes attributes(attrib_list);
  if (attributes.asks_for_legacy())
    return create_core(dpy, config, share_context, direct, std::move(attributes.others));
  LEGACY_GL_CALL_DRIVER(find_glx, GLXContext, glXCreateContextAttribsARB,
                        (dpy, config, share_context, direct, attrib_list));
}

LEGACY_GL_EXPORT void glXDestroyContext(Display* dpy, GLXContext ctx) {
  forget(ctx, [&](const std::function<void()>& destroy) {
    const auto bind = DRIVER(glXMakeContextCurrent);
    Display* const before_display = DRIVER(glXGetCurrentDisplay)();
    const GLXDrawable draw = DRIVER(glXGetCurrentDrawable)();
    const GLXDrawable read = DRIVER(glXGetCurrentReadDrawable)();
    const GLXContext before = DRIVER(glXGetCurrentContext)();
    const ErrorTrap trap(dpy);
    // Without a surface; where a driver cannot, what we hold for the context stays allocated.
    if (bind(dpy, None, None, ctx)) destroy();
    bind(before ? before_display : dpy, draw, read, before);
  });
  LEGACY_GL_CALL_DRIVER(find_glx, void, glXDestroyContext, (dpy, ctx));
}

LEGACY_GL_EXPORT Bool glXMakeCurrent(Display* dpy, GLXDrawable drawable, GLXContext ctx) {
  return make_current(dpy, drawable, drawable, ctx) ? True : False;
}

LEGACY_GL_EXPORT Bool glXMakeContextCurrent(Display* dpy, GLXDrawable draw, GLXDrawable read,
                                            GLXContext ctx) {
  return make_current(dpy, draw, read, ctx) ? True : False;
}

LEGACY_GL_EXPORT Bool glXMakeCurrentReadSGI(Display* dpy, GLXDrawable draw, GLXDrawable read,
                                            GLXContext ctx) {
  return make_current(dpy, draw, read, ctx) ? True : False;
}

LEGACY_GL_EXPORT void glXSwapBuffers(Display* dpy, GLXDrawable drawable) {
  legacy_gl_flush();
  LEGACY_GL_CALL_DRIVER(find_glx, void, glXSwapBuffers, (dpy, drawable));
}

LEGACY_GL_EXPORT void glXWaitGL() {
  legacy_gl_flush();
  LEGACY_GL_CALL_DRIVER(find_glx, void, glXWaitGL, ());
}

/// State groups do not pass from one core context to another.
LEGACY_GL_EXPORT void glXCopyContext(Display* dpy, GLXContext src, GLXContext dst,
                                     unsigned long mask) {
  legacy_gl_flush();
  LEGACY_GL_CALL_DRIVER(find_glx, void, glXCopyContext, (dpy, src, dst, mask));
}

LEGACY_GL_EXPORT __GLXextFuncPtr glXGetProcAddress(const GLubyte* procName) {
  return find_function(reinterpret_cast<const char*>(procName));
}

LEGACY_GL_EXPORT __GLXextFuncPtr glXGetProcAddressARB(const GLubyte* procName) {
  return find_function(reinterpret_cast<const char*>(procName));
}

#define LEGACY_GL_PASSED(result, name, parameters, arguments) \
  LEGACY_GL_EXPORT result name parameters {                   \
    LEGACY_GL_CALL_DRIVER(find_glx, result, name, arguments); \
  }
#include "platform/exported_glx.inc"
