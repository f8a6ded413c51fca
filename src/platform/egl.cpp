// The egl names of the drop-in: contexts of OpenGL before 3.1 become core contexts with ours on
// top, everything else, OpenGL ES with it, is the driver's.
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <vector>

#include "platform/drop_in_context.hpp"
#include "platform/export.hpp"

using namespace legacy_gl::platform;

namespace {

template <typename Function>
Function driver(const char* name) {
  const auto function = reinterpret_cast<Function>(find_egl(name));
  if (!function) report_missing(name);
  return function;
}
#define DRIVER(name) driver<decltype(&(name))>(#name)

/// The attributes of eglCreateContext, pairs that EGL_NONE ends.
struct Attributes {
  std::vector<EGLint> others;
  EGLint major = 1, minor = 0;
  EGLint profile = EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT;

  explicit Attributes(const EGLint* list) {
    for (; list && list[0] != EGL_NONE; list += 2) {
      switch (list[0]) {
        case EGL_CONTEXT_MAJOR_VERSION: major = list[1]; break;
        case EGL_CONTEXT_MINOR_VERSION: minor = list[1]; break;
        case EGL_CONTEXT_OPENGL_PROFILE_MASK: profile = list[1]; break;
        default: others.insert(others.end(), {list[0], list[1]});
      }
    }
  }
  bool asks_for_legacy() const {
    if (major < 3 || (major == 3 && minor < 1)) return true;
    return profile == EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT;
  }
};

legacy_gl_proc load(const char* name) { return find_gl(name); }

}  // namespace

LEGACY_GL_EXPORT EGLContext eglCreateContext(EGLDisplay dpy, EGLConfig config,
                                             EGLContext share_context, const EGLint* attrib_list) {
  Attributes attributes(attrib_list);
  const auto create = DRIVER(eglCreateContext);
  if (!create) return EGL_NO_CONTEXT;
  if (DRIVER(eglQueryAPI)() != EGL_OPENGL_API || !attributes.asks_for_legacy())
    return create(dpy, config, share_context, attrib_list);
  attributes.others.insert(
      attributes.others.end(),
      {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
       EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE});
  const EGLContext context = create(dpy, config, share_context, attributes.others.data());
  if (context != EGL_NO_CONTEXT) adopt(context, share_context);
  else report_old_driver();
  return context;
}

LEGACY_GL_EXPORT EGLBoolean eglDestroyContext(EGLDisplay dpy, EGLContext ctx) {
  forget(ctx, [&](const std::function<void()>& destroy) {
    const auto bind = DRIVER(eglMakeCurrent);
    const EGLDisplay before_display = DRIVER(eglGetCurrentDisplay)();
    const EGLSurface draw = DRIVER(eglGetCurrentSurface)(EGL_DRAW);
    const EGLSurface read = DRIVER(eglGetCurrentSurface)(EGL_READ);
    const EGLContext before = DRIVER(eglGetCurrentContext)();
    if (bind(dpy, EGL_NO_SURFACE, EGL_NO_SURFACE, ctx)) destroy();
    bind(before != EGL_NO_CONTEXT ? before_display : dpy, draw, read, before);
  });
  LEGACY_GL_CALL_DRIVER(find_egl, EGLBoolean, eglDestroyContext, (dpy, ctx));
}

LEGACY_GL_EXPORT EGLBoolean eglMakeCurrent(EGLDisplay dpy, EGLSurface draw, EGLSurface read,
                                           EGLContext ctx) {
  const auto bind = DRIVER(eglMakeCurrent);
  if (!bind) return EGL_FALSE;
  const bool done = switch_to(ctx, &load, [&] { return bind(dpy, draw, read, ctx) != EGL_FALSE; });
  return done ? EGL_TRUE : EGL_FALSE;
}

LEGACY_GL_EXPORT EGLBoolean eglReleaseThread() {
  const auto release = DRIVER(eglReleaseThread);
  if (!release) return EGL_FALSE;
  return switch_to(nullptr, &load, [&] { return release() != EGL_FALSE; }) ? EGL_TRUE : EGL_FALSE;
}

LEGACY_GL_EXPORT EGLBoolean eglSwapBuffers(EGLDisplay dpy, EGLSurface surface) {
  legacy_gl_flush();
  LEGACY_GL_CALL_DRIVER(find_egl, EGLBoolean, eglSwapBuffers, (dpy, surface));
}

LEGACY_GL_EXPORT EGLBoolean eglCopyBuffers(EGLDisplay dpy, EGLSurface surface,
                                           EGLNativePixmapType target) {
  legacy_gl_flush();
  LEGACY_GL_CALL_DRIVER(find_egl, EGLBoolean, eglCopyBuffers, (dpy, surface, target));
}

LEGACY_GL_EXPORT EGLBoolean eglWaitGL() {
  legacy_gl_flush();
  LEGACY_GL_CALL_DRIVER(find_egl, EGLBoolean, eglWaitGL, ());
}

LEGACY_GL_EXPORT EGLBoolean eglWaitClient() {
  legacy_gl_flush();
  LEGACY_GL_CALL_DRIVER(find_egl, EGLBoolean, eglWaitClient, ());
}

LEGACY_GL_EXPORT __eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* procname) {
  if (const Function ours = find_exported(procname)) return ours;
  return find_egl(procname);
}

#define LEGACY_GL_PASSED(result, name, parameters, arguments) \
  LEGACY_GL_EXPORT result name parameters {                   \
    LEGACY_GL_CALL_DRIVER(find_egl, result, name, arguments); \
  }
#include "platform/exported_egl.inc"
