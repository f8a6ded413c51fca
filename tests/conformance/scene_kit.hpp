// What scenes are made of: parameters, views, lights, materials and figures.
#pragma once

#include <array>
#include <cmath>

#include "conformance/scene.hpp"

namespace legacy_gl::test {

// Four floats that pass as a parameter: gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, vec(1, 0, 0)).
struct Parameters {
  std::array<GLfloat, 4> values;
  operator const GLfloat*() const { return values.data(); }
};

constexpr Parameters vec(float x, float y, float z, float w = 1.0F) { return {{x, y, z, w}}; }

// Clears to (0, 0, 0, 0), enables the depth test, sets a perspective view onto the unit sphere
// around the origin, and leaves the modelview matrix selected with the eye 4 units away.
void begin_scene(const GlFunctions& gl);
// The same with an orthographic view of x and y in [-1, 1]; modelview is the identity.
void begin_flat_scene(const GlFunctions& gl);

// Lighting on, light 0 white from the upper right and in front (directional), a bluish material
// with a highlight of shininess 20.
void begin_lit_scene(const GlFunctions& gl);
void use_directional_light(const GlFunctions& gl, GLenum light, Parameters color);
void use_positional_light(const GlFunctions& gl, GLenum light, Parameters position,
                          Parameters color);
void use_material(const GlFunctions& gl, GLenum face, Parameters ambient, Parameters diffuse,
                  Parameters specular, float shininess);
// Of the teapot book's table: brass, turquoise, black plastic.
void use_brass(const GlFunctions& gl, GLenum face);
void use_turquoise(const GlFunctions& gl, GLenum face);
void use_black_plastic(const GlFunctions& gl, GLenum face);

// Figures in GL_TRIANGLES with one unit normal for each vertex unless they say otherwise.
void draw_sphere(const GlFunctions& gl, float radius = 1.0F, int slices = 16, int stacks = 10);
void draw_torus(const GlFunctions& gl, float tube_radius = 0.35F, float ring_radius = 0.65F);
// Six faces of two triangles each, with face normals.
void draw_cube(const GlFunctions& gl, float half_edge);
// The square [-1, 1]² in the plane z = 0, normal +z, `cells`² cells.
void draw_patch(const GlFunctions& gl, int cells = 12);
// An open half tube that shows its inside and its outside.
void draw_half_tube(const GlFunctions& gl, float radius = 0.8F);
// A vertex colour that varies over the figure.
void color_by_position(const GlFunctions& gl, float x, float y, float z);
// Vertices around the middle, or those of a strip.
void draw_ring(const GlFunctions& gl, GLenum mode, int count = 8);
// draw_sphere with color_by_position at each vertex.
void draw_colored_sphere(const GlFunctions& gl, float radius = 1.0F);

// Vertices of a figure for the array scenes: position, normal and colour interleaved.
struct MeshVertex {
  std::array<GLfloat, 3> position;
  std::array<GLfloat, 3> normal;
  std::array<GLubyte, 4> color;
};
struct Mesh {
  std::vector<MeshVertex> vertices;
  std::vector<GLushort> triangle_indices;
};
Mesh sphere_mesh(int slices = 12, int stacks = 8);

// `draw` at a quarter of the viewport: column and row 0 or 1.
void in_quarter(const GlFunctions& gl, int column, int row, const Draw& draw);

// The scene begin_lit_scene, then `set`, then the sphere.
Scene lit_sphere_scene(std::string name, Draw set);

}  // namespace legacy_gl::test
