// A curve and a lit surface.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glMap1f(GL_MAP1_VERTEX_3, 0, 1, 3, 4,
          (GLfloat[]){-0.9, 0.6, 0, -0.3, 1, 0, 0.3, 0.2, 0, 0.9, 0.8, 0});
  glEnable(GL_MAP1_VERTEX_3);
  glMapGrid1f(12, 0, 1);
  glEvalMesh1(GL_LINE, 0, 12);
  glDisable(GL_MAP1_VERTEX_3);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 5);
  glEnable(GL_AUTO_NORMAL);
  glEnable(GL_MAP2_VERTEX_3);
  glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 3,
          (GLfloat[]){-0.8, -0.8, 0, 0.8, -0.7, 0.1, -0.7, -0.2, 0.4, 0.7, -0.1, 0.6, -0.8, 0.4, 0,
                      0.8, 0.5, -0.1});
  glMapGrid2f(4, 0, 1, 4, 0, 1);
  glEvalMesh2(GL_FILL, 0, 4, 0, 4);
  glDisable(GL_MAP2_VERTEX_3);
  glDisable(GL_LIGHTING);
  glColor4f(1, 1, 1, 1);
  glNormal3f(0, 0, 1);
}
