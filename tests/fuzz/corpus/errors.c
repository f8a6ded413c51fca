// Errors that change nothing.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_AMBIENT);
  glGetError();
  glLineWidth(0);
  glBegin(GL_AMBIENT);
  glGetError();
  glGetError();
  glFrustum(0, 1, 0, 1, -1, 1);
  glGetError();
  glEndList();
  glGetError();
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0.2, 0.1, 1);
  glVertex2f(-0.8, -0.7);
  glColor4f(0.1, 0.9, 0.2, 0.8);
  glVertex2f(0.7, -0.5);
  glColor4f(0.2, 0.1, 0.8, 0.6);
  glVertex2f(-0.1, 0.8);
  glEnd();
}
