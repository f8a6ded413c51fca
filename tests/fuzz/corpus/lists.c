// A list that is called by another, with a state change within.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glColor4f(0.3, 0.9, 0.4, 1);
  glNewList(1, GL_COMPILE);
  glRotatef(20, 0, 0, 1);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0.2, 0.1, 1);
  glVertex2f(-0.8, -0.7);
  glColor4f(0.1, 0.9, 0.2, 0.8);
  glVertex2f(0.7, -0.5);
  glColor4f(0.2, 0.1, 0.8, 0.6);
  glVertex2f(-0.1, 0.8);
  glEnd();
  glEndList();
  glNewList(2, GL_COMPILE_AND_EXECUTE);
  glPushMatrix();
  glScalef(0.5, 0.5, 1);
  glCallList(1);
  glPopMatrix();
  glShadeModel(GL_FLAT);
  glEndList();
  glListBase(1);
  glCallLists(2, GL_UNSIGNED_BYTE, (GLubyte[]){1, 0});
  glListBase(0);
  glLoadIdentity();
  glGetIntegerv(GL_SHADE_MODEL, (GLint[1]){0});
  glIsList(2);
}
