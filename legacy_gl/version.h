/* The version of legacy_gl. CMake reads the three numbers from here. */
#ifndef LEGACY_GL_VERSION_H
#define LEGACY_GL_VERSION_H

#define LEGACY_GL_VERSION_MAJOR 0
#define LEGACY_GL_VERSION_MINOR 1
#define LEGACY_GL_VERSION_PATCH 0

/** One number to compare versions by; minor and patch are below 1000. */
#define LEGACY_GL_MAKE_VERSION(major, minor, patch) ((major)*1000000 + (minor)*1000 + (patch))

/** The version of these headers. legacy_gl_version() is that of the library that is linked. */
#define LEGACY_GL_VERSION \
  LEGACY_GL_MAKE_VERSION(LEGACY_GL_VERSION_MAJOR, LEGACY_GL_VERSION_MINOR, LEGACY_GL_VERSION_PATCH)

#endif
