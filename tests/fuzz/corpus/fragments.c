// Stencil, alpha test, blending, masks.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_STENCIL_TEST);
  glStencilFunc(GL_ALWAYS, 1, 3);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  glRectf(-0.5, -0.6, 0.6, 0.5);
  glStencilFunc(GL_EQUAL, 1, 3);
  glStencilOp(GL_KEEP, GL_INCR, GL_DECR);
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_GREATER, 0.7);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_DST_COLOR);
  glColorMask(1, 0, 1, 1);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0.2, 0.1, 1);
  glVertex2f(-0.8, -0.7);
  glColor4f(0.1, 0.9, 0.2, 0.8);
  glVertex2f(0.7, -0.5);
  glColor4f(0.2, 0.1, 0.8, 0.6);
  glVertex2f(-0.1, 0.8);
  glEnd();
  glColorMask(1, 1, 1, 1);
  glDisable(GL_BLEND);
  glDisable(GL_ALPHA_TEST);
  glDisable(GL_STENCIL_TEST);
  glReadPixels(30, 30, 4, 2, GL_RGBA, GL_UNSIGNED_BYTE, (GLubyte[32]){0});
}
