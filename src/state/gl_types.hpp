#pragma once
// The GL types and enums inside the library. The driver's own headers are for src/backend alone.
#ifndef LEGACY_GL_NO_NAMES
#define LEGACY_GL_NO_NAMES
#endif
#include <legacy_gl/gl.h>
