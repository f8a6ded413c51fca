// A point light and a direction on a normal for each vertex.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glEnable(GL_LIGHT1);
  glEnable(GL_NORMALIZE);
  glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1, 2, 3, 1});
  glLightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.2);
  glLightfv(GL_LIGHT1, GL_POSITION, (GLfloat[]){-1, 0.5, 1, 0});
  glLightfv(GL_LIGHT1, GL_DIFFUSE, (GLfloat[]){0.3, 0.5, 0.2, 1});
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, (GLfloat[]){0.5, 0.6, 0.7, 1});
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 12);
  glBegin(GL_TRIANGLE_STRIP);
  glNormal3f(-0.5, -0.5, 0.7);
  glVertex3f(-0.8, -0.8, 0);
  glNormal3f(0.5, -0.5, 0.9);
  glVertex3f(0.8, -0.7, 0.1);
  glNormal3f(-0.5, 0.4, 0.7);
  glMaterialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, (GLfloat[]){0.9, 0.3, 0.2, 1});
  glVertex3f(-0.7, 0.8, -0.2);
  glNormal3f(0.5, 0.6, 0.7);
  glVertex3f(0.8, 0.8, 0);
  glEnd();
}
