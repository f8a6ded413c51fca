#pragma once

#include <legacy_gl/glu.h>

// The GLU names the type in the global namespace.
class GLUquadric {
 public:
  using ErrorCallback = void(LEGACY_GL_APIENTRY*)(GLenum error);

  GLenum normals = GLU_SMOOTH;
  GLenum draw_style = GLU_FILL;
  GLenum orientation = GLU_OUTSIDE;
  bool has_texture = false;
  ErrorCallback error_callback = nullptr;

  void report(GLenum error) const {
    if (error_callback != nullptr) {
      error_callback(error);
    }
  }

  bool inside() const { return orientation == GLU_INSIDE; }
  float normal_sign() const { return inside() ? -1.0F : 1.0F; }

  void texture_coordinate(float s, float t) const {
    if (has_texture) {
      lglTexCoord2f(s, t);
    }
  }
};
