// Attributes and matrices come back.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_SCISSOR_TEST);
  glScissor(5, 5, 40, 30);
  glPushMatrix();
  glTranslatef(0.2, 0.1, 0);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0.2, 0.1, 1);
  glVertex2f(-0.8, -0.7);
  glColor4f(0.1, 0.9, 0.2, 0.8);
  glVertex2f(0.7, -0.5);
  glColor4f(0.2, 0.1, 0.8, 0.6);
  glVertex2f(-0.1, 0.8);
  glEnd();
  glPopMatrix();
  glGetIntegerv(GL_ATTRIB_STACK_DEPTH, (GLint[1]){0});
  glPopAttrib();
  glGetFloatv(GL_MODELVIEW_MATRIX, (GLfloat[16]){0});
  glGetFloatv(GL_CURRENT_COLOR, (GLfloat[4]){0});
  glIsEnabled(GL_BLEND);
  glRectf(0.5, 0.5, 0.9, 0.8);
}
