// Arrays of the program and of a buffer object, by index and without.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  glBindBuffer(GL_ARRAY_BUFFER, 1);
  glBufferData(GL_ARRAY_BUFFER, 48,
               (GLfloat[]){-0.8, -0.8, 0.8, -0.7, 0.7, 0.8, -0.8, 0.7, 0, 0, 0.4, 0.9},
               GL_STATIC_DRAW);
  glVertexPointer(2, GL_FLOAT, 0, (void*)0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glColorPointer(4, GL_UNSIGNED_BYTE, 0,
                 (GLubyte[]){255, 0,   0, 255, 0,  255, 0,   255, 0,  0,  255, 255,
                             255, 255, 0, 255, 90, 10,  200, 255, 40, 80, 160, 255});
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDrawElements(GL_LINE_LOOP, 4, GL_UNSIGNED_SHORT, (GLushort[]){3, 1, 4, 5});
  glBegin(GL_TRIANGLES);
  glArrayElement(5);
  glArrayElement(4);
  glArrayElement(3);
  glEnd();
  glPopClientAttrib();
  glColor4f(1, 1, 1, 1);
}
