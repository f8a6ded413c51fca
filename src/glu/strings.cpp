// The texts of lgluErrorString are those of libGLU, because programs print and compare them.
#include <legacy_gl/glu.h>

namespace {

const char* error_text(GLenum error) {
  switch (error) {
    case GL_NO_ERROR: return "no error";
    case GL_INVALID_ENUM:
    case GLU_INVALID_ENUM: return "invalid enumerant";
    case GL_INVALID_VALUE:
    case GLU_INVALID_VALUE: return "invalid value";
    case GL_INVALID_OPERATION:
    case GLU_INVALID_OPERATION: return "invalid operation";
    case GL_STACK_OVERFLOW: return "stack overflow";
    case GL_STACK_UNDERFLOW: return "stack underflow";
    case GL_OUT_OF_MEMORY:
    case GLU_OUT_OF_MEMORY: return "out of memory";
    case 0x0506:  // GL_INVALID_FRAMEBUFFER_OPERATION, which OpenGL 1.5 has no name for.
      return "invalid framebuffer operation";
    case 0x8031:  // GL_TABLE_TOO_LARGE, of the imaging subset.
      return "table too large";
    case GLU_INCOMPATIBLE_GL_VERSION: return "incompatible gl version";
    default: return nullptr;
  }
}

const GLubyte* as_gl_string(const char* text) { return reinterpret_cast<const GLubyte*>(text); }

}  // namespace

LEGACY_GL_API const GLubyte* LEGACY_GL_APIENTRY lgluErrorString(GLenum error) {
  return as_gl_string(error_text(error));
}

LEGACY_GL_API const GLubyte* LEGACY_GL_APIENTRY lgluGetString(GLenum name) {
  switch (name) {
    case GLU_VERSION: return as_gl_string("1.3");
    case GLU_EXTENSIONS: return as_gl_string("");
    default: return nullptr;
  }
}
