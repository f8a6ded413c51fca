// Fog by depth under a perspective, and by coordinate.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glFrustum(-0.5, 0.5, -0.5, 0.5, 1, 8);
  glTranslatef(0, 0, -3);
  glMatrixMode(GL_MODELVIEW);
  glEnable(GL_FOG);
  glFogi(GL_FOG_MODE, GL_EXP2);
  glFogf(GL_FOG_DENSITY, 0.3);
  glFogfv(GL_FOG_COLOR, (GLfloat[]){0.7, 0.6, 0.9, 1});
  glFogi(GL_FOG_COORDINATE_SOURCE, GL_FRAGMENT_DEPTH);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0.2, 0.1, 1);
  glVertex2f(-0.8, -0.7);
  glColor4f(0.1, 0.9, 0.2, 0.8);
  glVertex2f(0.7, -0.5);
  glColor4f(0.2, 0.1, 0.8, 0.6);
  glVertex2f(-0.1, 0.8);
  glEnd();
  glFogi(GL_FOG_COORDINATE_SOURCE, GL_FOG_COORDINATE);
  glBegin(GL_TRIANGLES);
  glFogCoordf(0);
  glVertex3f(-0.9, 0.9, 0.5);
  glFogCoordf(2);
  glVertex3f(-0.2, 0.9, -0.5);
  glFogCoordf(1);
  glVertex3f(-0.9, 0.1, 0.9);
  glEnd();
}
