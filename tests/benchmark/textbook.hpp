// The yardstick: the lighting equation as a textbook writes it in GLSL, on the core profile. Every
// vector in eye coordinates and float32, normalize(), pow(), one uniform for each value, matrices
// inverted in float32; compiled once for each number of lights.
#pragma once

#include <map>
#include <memory>
#include <span>

#include "oracle/oracle.hpp"
#include "support/contexts.hpp"

namespace legacy_gl::test {

class Textbook {
 public:
  Textbook(int width, int height);
  ~Textbook();

  void make_current();
  void clear();
  void viewport(int x, int y, int width, int height);
  // What the draws after it take. `modelview_projection` places the vertices.
  void set_state(const oracle::State& state, const oracle::Matrix4& modelview_projection);
  void upload(std::span<const oracle::Vertex> vertices);
  void draw(GLenum mode, int count);
  void point_size(float size);
  void discard_fragments();
  void finish();
  Image read();

 private:
  struct Functions;
  GLuint program(std::size_t light_count);

  CoreContext context_;
  std::unique_ptr<Functions> gl_;
  std::map<std::size_t, GLuint> programs_;
};

}  // namespace legacy_gl::test
