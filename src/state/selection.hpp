#pragma once
#include <array>
#include <cstddef>

#include "state/gl_types.hpp"

namespace legacy_gl {

/// GL 2.1 spec 5.2: the names that are loaded, and what was hit since they changed last.
struct SelectionState {
  static constexpr unsigned kMaxNames = 64;

  GLenum render_mode = GL_RENDER;
  GLuint* buffer = nullptr;  ///< the application's
  std::size_t buffer_size = 0;
  std::size_t written = 0;  ///< values that hit records have asked for; more than fit: overflow
  GLint hits = 0;
  bool hit = false;
  float nearest = 1, farthest = 0;  ///< window depths of what was hit
  std::array<GLuint, kMaxNames> names{};
  unsigned name_count = 0;

  bool is_rendering() const { return render_mode == GL_RENDER; }
  bool is_feeding_back() const { return render_mode == GL_FEEDBACK; }
  bool is_selecting() const { return render_mode == GL_SELECT; }
  void add_hit(float window_depth);
  /// A record for what was hit; the names are about to change.
  void write_hit();
  /// Of glRenderMode: the number of records, or -1 when they did not fit. Starts anew.
  GLint finish();
};

}  // namespace legacy_gl
