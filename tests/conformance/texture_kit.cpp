#include "conformance/texture_kit.hpp"

#include <algorithm>

namespace legacy_gl::test {

std::vector<GLubyte> texture_colors(int width, int height) {
  std::vector<GLubyte> colors;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      colors.push_back(static_cast<GLubyte>(255 * x / std::max(width - 1, 1)));
      colors.push_back(static_cast<GLubyte>(255 * y / std::max(height - 1, 1)));
      colors.push_back(static_cast<GLubyte>((37 * x + 91 * y) % 256));
      colors.push_back(static_cast<GLubyte>(255 - (53 * x + 29 * y) % 200));
    }
  return colors;
}

namespace {

void set_filters(const GlFunctions& gl, GLenum target, GLenum min_filter, GLenum mag_filter) {
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(min_filter));
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(mag_filter));
  gl.Enable(target);
}

}  // namespace

void use_texture(const GlFunctions& gl, GLint internal_format, GLenum min_filter, GLenum mag_filter,
                 GLuint name) {
  gl.BindTexture(GL_TEXTURE_2D, name);
  int width = 16, height = 8;
  for (GLint level = 0;; ++level) {
    gl.TexImage2D(GL_TEXTURE_2D, level, internal_format, width, height, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, texture_colors(width, height).data());
    if (width == 1 && height == 1) break;
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
  }
  set_filters(gl, GL_TEXTURE_2D, min_filter, mag_filter);
}

void use_texture_1d(const GlFunctions& gl, GLint internal_format, GLenum filter) {
  gl.BindTexture(GL_TEXTURE_1D, 2);
  gl.TexImage1D(GL_TEXTURE_1D, 0, internal_format, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                texture_colors(16, 1).data());
  set_filters(gl, GL_TEXTURE_1D, filter, filter);
}

void textured_vertex(const GlFunctions& gl, float s, float t, float x, float y, float z) {
  gl.TexCoord2f(s, t);
  gl.Color4f(0.5F + 0.4F * x, 0.6F - 0.3F * y, 0.9F, 0.8F);
  gl.Vertex3f(x, y, z);
}

void draw_textured_quad(const GlFunctions& gl) {
  gl.Begin(GL_QUADS);
  textured_vertex(gl, 0.013F, 0.021F, -0.93F, -0.87F);
  textured_vertex(gl, 1.031F, 0.043F, 0.91F, -0.83F);
  textured_vertex(gl, 0.987F, 1.017F, 0.89F, 0.88F);
  textured_vertex(gl, 0.029F, 0.973F, -0.9F, 0.85F);
  gl.End();
}

}  // namespace legacy_gl::test
