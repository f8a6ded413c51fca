// What scenes with textures are made of.
#pragma once

#include "conformance/scene_kit.hpp"

namespace legacy_gl::test {

// A colour for each texel, all different.
std::vector<GLubyte> texture_colors(int width, int height);

// Texture `name` with all its levels, 16 times 8 texels, bound and enabled for GL_TEXTURE_2D.
void use_texture(const GlFunctions& gl, GLint internal_format, GLenum min_filter, GLenum mag_filter,
                 GLuint name = 1);
void use_texture_1d(const GlFunctions& gl, GLint internal_format, GLenum filter);

void textured_vertex(const GlFunctions& gl, float s, float t, float x, float y, float z = 0);
// Most of the picture, a colour at each corner, the texture once across and slightly turned.
void draw_textured_quad(const GlFunctions& gl);

}  // namespace legacy_gl::test
