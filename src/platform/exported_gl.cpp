// The gl names of the drop-in. While a context of ours is current they are ours; otherwise (a core
// profile that the program asked for itself, OpenGL ES, none at all) they are the driver's.
#define LEGACY_GL_NO_NAMES
#include <GL/gl.h>
#include <GL/glext.h>
#include <legacy_gl/context.h>
#include <legacy_gl/gl.h>

#include "platform/beside_ours.hpp"
#include "platform/export.hpp"

using legacy_gl::platform::BesideOurs;
using legacy_gl::platform::find_gl;

#define LEGACY_GL_NAME(result, name, parameters, arguments, ours) \
  LEGACY_GL_EXPORT result APIENTRY name parameters {              \
    if (legacy_gl_get_current()) return ours arguments;           \
    LEGACY_GL_CALL_DRIVER(find_gl, result, name, arguments);      \
  }
// Some aliases name an enum's type where the command they stand for has an integer's.
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include "api/gl_names.inc"

#define LEGACY_GL_PASSED(result, name, parameters, arguments) \
  LEGACY_GL_EXPORT result APIENTRY name parameters {          \
    const BesideOurs beside;                                  \
    LEGACY_GL_CALL_DRIVER(find_gl, result, name, arguments);  \
  }
#include "platform/exported_gl_passed.inc"
