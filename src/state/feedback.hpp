#pragma once
#include <cstddef>
#include <glm/vec4.hpp>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// GL 2.1 spec 5.3: what primitives write instead of pixels.
struct FeedbackState {
  GLenum type = GL_2D;
  GLfloat* buffer = nullptr;  ///< the application's
  std::size_t buffer_size = 0;
  std::size_t written = 0;  ///< values that were to be written; more than fit: overflow

  bool has_depth() const { return type != GL_2D; }
  bool has_w() const { return type == GL_4D_COLOR_TEXTURE; }
  bool has_color() const { return type != GL_2D && type != GL_3D; }
  bool has_texture() const { return type == GL_3D_COLOR_TEXTURE || type == GL_4D_COLOR_TEXTURE; }

  void put(float value);
  void put_token(GLenum token) { put(static_cast<float>(token)); }
  /// Table 5.1. `window`: x, y and z in window coordinates, and the w of clip coordinates.
  void put_vertex(const glm::vec4& window, const glm::vec4& color, const glm::vec4& texture);
  /// Of glRenderMode: the number of values, or -1 when they did not fit. Starts anew.
  GLint finish();
};

}  // namespace legacy_gl
