#include "shapes.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

void draw_sphere(GLfloat radius, int slices) {
  GLUquadricObj* quadric = gluNewQuadric();
  gluSphere(quadric, (GLdouble)radius, slices, slices / 2);
  gluDeleteQuadric(quadric);
}

/* A square grid in the plane z = height, facing +z. */
static void draw_grid(GLfloat half_edge, GLfloat height, int cells) {
  int row, column;
  GLfloat cell = 2.0f * half_edge / (GLfloat)cells;
  glNormal3f(0.0f, 0.0f, 1.0f);
  for (row = 0; row < cells; row++) {
    GLfloat y = -half_edge + cell * (GLfloat)row;
    GLfloat next_y = -half_edge + cell * (GLfloat)(row + 1);
    glBegin(GL_TRIANGLE_STRIP);
    for (column = 0; column <= cells; column++) {
      GLfloat x = -half_edge + cell * (GLfloat)column;
      glVertex3f(x, next_y, height);
      glVertex3f(x, y, height);
    }
    glEnd();
  }
}

void draw_cube(GLfloat half_edge, int cells) {
  int face;
  glPushMatrix();
  for (face = 0; face < 4; face++) {
    glRotatef(90.0f, 0.0f, 1.0f, 0.0f);
    draw_grid(half_edge, half_edge, cells);
  }
  glRotatef(90.0f, 1.0f, 0.0f, 0.0f);
  draw_grid(half_edge, half_edge, cells);
  glRotatef(180.0f, 1.0f, 0.0f, 0.0f);
  draw_grid(half_edge, half_edge, cells);
  glPopMatrix();
}

void draw_floor(GLfloat half_edge, int cells) {
  glPushMatrix();
  glRotatef(-90.0f, 1.0f, 0.0f, 0.0f);
  draw_grid(half_edge, 0.0f, cells);
  glPopMatrix();
}

static void torus_vertex(GLfloat radius, GLfloat tube_radius, double around, double side) {
  double ring = (double)radius + (double)tube_radius * cos(side);
  glNormal3d(sin(around) * cos(side), sin(side), cos(around) * cos(side));
  glVertex3d(ring * sin(around), (double)tube_radius * sin(side), ring * cos(around));
}

void draw_torus(GLfloat radius, GLfloat tube_radius, GLfloat sweep_degrees, int rings, int sides) {
  int ring, side;
  double sweep = (double)sweep_degrees * pi / 180.0;
  for (ring = 0; ring < rings; ring++) {
    glBegin(GL_QUAD_STRIP);
    for (side = 0; side <= sides; side++) {
      double angle = 2.0 * pi * side / sides;
      torus_vertex(radius, tube_radius, sweep * ring / rings, angle);
      torus_vertex(radius, tube_radius, sweep * (ring + 1) / rings, angle);
    }
    glEnd();
  }
}
