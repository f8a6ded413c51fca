/* Solid shapes with normals, drawn at the origin. */
#ifndef LIGHTING_SHAPES_H
#define LIGHTING_SHAPES_H

#include "old_gl.h"

void draw_sphere(GLfloat radius, int slices);

/* Each face is a grid: per-vertex lighting shows a highlight only where it has vertices. */
void draw_cube(GLfloat half_edge, int cells);

/* Around the y axis; rings around it, sides around the tube. */
void draw_torus(GLfloat radius, GLfloat tube_radius, GLfloat sweep_degrees, int rings, int sides);

/* A square at y = 0, facing up. */
void draw_floor(GLfloat half_edge, int cells);

#endif
