// Two units, of which one combines.
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

void program(void) {
  glClearColor(0.1, 0.2, 0.3, 0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, 2);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexImage2D(
      GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
      (GLubyte[]){60,  89,  118, 147, 176, 205, 84,  113, 142, 171, 200, 79,  108, 137, 166, 195,
                  74,  103, 132, 161, 190, 69,  98,  127, 156, 185, 64,  93,  122, 151, 180, 209,
                  88,  117, 146, 175, 204, 83,  112, 141, 170, 199, 78,  107, 136, 165, 194, 73,
                  102, 131, 160, 189, 68,  97,  126, 155, 184, 63,  92,  121, 150, 179, 208, 87});
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
  glTexEnvi(GL_TEXTURE_ENV, GL_SOURCE2_RGB, GL_CONSTANT);
  glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, (GLfloat[]){0.2, 0.7, 0.4, 0.6});
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexImage2D(
      GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE,
      (GLubyte[]){60,  89,  118, 147, 176, 205, 84,  113, 142, 171, 200, 79,  108, 137, 166, 195,
                  74,  103, 132, 161, 190, 69,  98,  127, 156, 185, 64,  93,  122, 151, 180, 209,
                  88,  117, 146, 175, 204, 83,  112, 141, 170, 199, 78,  107, 136, 165, 194, 73,
                  102, 131, 160, 189, 68,  97,  126, 155, 184, 63,  92,  121, 150, 179, 208, 87});
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
  glEnable(GL_TEXTURE_GEN_S);
  glTexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
  glBegin(GL_QUADS);
  glTexCoord2f(0.1, 0.2);
  glMultiTexCoord2f(GL_TEXTURE1, 0, 0);
  glVertex2f(-0.8, -0.8);
  glTexCoord2f(0.9, 0.1);
  glMultiTexCoord2f(GL_TEXTURE1, 1.2, 0);
  glVertex2f(0.8, -0.8);
  glTexCoord2f(0.8, 0.9);
  glMultiTexCoord2f(GL_TEXTURE1, 1, 1.3);
  glVertex2f(0.8, 0.8);
  glTexCoord2f(0.2, 0.8);
  glMultiTexCoord2f(GL_TEXTURE1, 0, 1);
  glVertex2f(-0.8, 0.8);
  glEnd();
}
