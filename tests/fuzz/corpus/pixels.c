// A bitmap, a rectangle of pixels with zoom, a copy.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glColor4f(1, 0.8, 0.2, 1);
  glWindowPos2i(10, 12);
  glBitmap(8, 4, 0, 0, 9, 1, (GLubyte[]){170, 0, 0, 0, 85, 0, 0, 0, 255, 0, 0, 0, 60, 0, 0, 0});
  glFlush();
  glPixelZoom(3, -2);
  glDrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE,
               (GLubyte[]){255, 0, 0, 255, 0, 255, 0, 200, 10, 20, 255, 100, 90, 90, 20, 255});
  glPixelZoom(1, 1);
  glRasterPos2f(0.2, 0.3);
  glCopyPixels(8, 6, 16, 12, GL_COLOR);
}
