// Lines with edge flags, points, and offsets of filled polygons.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glPolygonMode(GL_FRONT, GL_LINE);
  glPolygonMode(GL_BACK, GL_POINT);
  glPointSize(3);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0.2, 0.1, 1);
  glVertex2f(-0.8, -0.7);
  glColor4f(0.1, 0.9, 0.2, 0.8);
  glVertex2f(0.7, -0.5);
  glColor4f(0.2, 0.1, 0.8, 0.6);
  glVertex2f(-0.1, 0.8);
  glEnd();
  glBegin(GL_QUADS);
  glEdgeFlag(1);
  glVertex2f(-0.5, -0.5);
  glEdgeFlag(0);
  glVertex2f(0.6, -0.4);
  glEdgeFlag(1);
  glVertex2f(0.5, 0.6);
  glVertex2f(-0.4, 0.5);
  glVertex2f(-0.9, 0.9);
  glVertex2f(-0.6, 0.9);
  glVertex2f(-0.6, 0.6);
  glVertex2f(-0.9, 0.6);
  glEnd();
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glPolygonOffset(1, 4);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glRectf(-0.3, -0.3, 0.3, 0.3);
  glDisable(GL_POLYGON_OFFSET_FILL);
}
