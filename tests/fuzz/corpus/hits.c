// Selection by names, and feedback.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glSelectBuffer(64, (GLuint[64]){0});
  glRenderMode(GL_SELECT);
  glInitNames();
  glPushName(4);
  glRectf(-0.5, -0.5, 0.5, 0.5);
  glLoadName(5);
  glRectf(1.5, 1.5, 2, 2);
  glPushName(6);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0.2, 0.1, 1);
  glVertex2f(-0.8, -0.7);
  glColor4f(0.1, 0.9, 0.2, 0.8);
  glVertex2f(0.7, -0.5);
  glColor4f(0.2, 0.1, 0.8, 0.6);
  glVertex2f(-0.1, 0.8);
  glEnd();
  glRenderMode(GL_RENDER);
  glFeedbackBuffer(256, GL_3D_COLOR, (GLfloat[256]){0});
  glRenderMode(GL_FEEDBACK);
  glPassThrough(3);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0.2, 0.1, 1);
  glVertex2f(-0.8, -0.7);
  glColor4f(0.1, 0.9, 0.2, 0.8);
  glVertex2f(0.7, -0.5);
  glColor4f(0.2, 0.1, 0.8, 0.6);
  glVertex2f(-0.1, 0.8);
  glEnd();
  glBegin(GL_LINES);
  glVertex3f(-2, 0, 0.5);
  glVertex3f(0.5, 0.3, -0.5);
  glEnd();
  glRenderMode(GL_RENDER);
}
