/* How the public functions are declared. */
#ifndef LEGACY_GL_EXPORT_H
#define LEGACY_GL_EXPORT_H

#if defined(_WIN32)
#define LEGACY_GL_APIENTRY __stdcall
#define LEGACY_GL_API
#else
#define LEGACY_GL_APIENTRY
#define LEGACY_GL_API __attribute__((visibility("default")))
#endif

#endif
