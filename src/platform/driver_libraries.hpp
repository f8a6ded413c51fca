#pragma once
// The driver's own libraries below the drop-in. Each is loaded at the first call that needs it.

namespace legacy_gl::platform {

using Function = void (*)();

/// A function of the driver's libGLX.so.0, by name; nullptr when it has none.
Function find_glx(const char* name);

/// A function of the driver's libEGL.so.1 (not of the drop-in's, which has the same name).
Function find_egl(const char* name);

/// A gl function of the driver's. It serves the context that is current, by GLX or by EGL.
Function find_gl(const char* name);

/// A function that the drop-in exports itself; nullptr when it does not.
Function find_exported(const char* name);

/// Says once for each name that the driver's libraries lack it.
void report_missing(const char* name);

}  // namespace legacy_gl::platform
