/* A driver context, a lit triangle, and the colour that GL 2.1 spec 2.14.1 gives it. */
#ifndef LIT_TRIANGLE_H
#define LIT_TRIANGLE_H

#include <legacy_gl/context.h>
#include <legacy_gl/gl.h>
/* legacy_gl/gl.h comes first: this one includes GL/gl.h, and both have to live in one file. */
#include <GL/osmesa.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 16, HEIGHT = 16 };

static OSMesaContext make_driver_context(void) {
  static unsigned char pixels[WIDTH * HEIGHT * 4];
  static const int attributes[] = {OSMESA_FORMAT,
                                   OSMESA_RGBA,
                                   OSMESA_DEPTH_BITS,
                                   24,
                                   OSMESA_PROFILE,
                                   OSMESA_CORE_PROFILE,
                                   OSMESA_CONTEXT_MAJOR_VERSION,
                                   3,
                                   OSMESA_CONTEXT_MINOR_VERSION,
                                   3,
                                   0};
  OSMesaContext driver = OSMesaCreateContextAttribs(attributes, NULL);
  if (driver && !OSMesaMakeCurrent(driver, pixels, GL_UNSIGNED_BYTE, WIDTH, HEIGHT)) {
    OSMesaDestroyContext(driver);
    driver = NULL;
  }
  if (!driver) fprintf(stderr, "OSMesa gives no core context\n");
  return driver;
}

static void draw_lit_triangle(void) {
  /* 60 degrees from the normal, so that n . L is 1/2. */
  static const GLfloat direction[4] = {0.0f, 0.8660254f, 0.5f, 0.0f};
  static const GLfloat diffuse[4] = {1.0f, 0.4f, 0.0f, 1.0f};
  static const GLfloat black[4] = {0.0f, 0.0f, 0.0f, 1.0f};

  glClearColor(0.0f, 0.0f, 1.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  glLightfv(GL_LIGHT0, GL_POSITION, direction);
  glMaterialfv(GL_FRONT, GL_DIFFUSE, diffuse);
  glBegin(GL_TRIANGLES);
  glNormal3f(0.0f, 0.0f, 1.0f);
  glVertex3f(-1.0f, -1.0f, 0.0f);
  glVertex3f(1.0f, -1.0f, 0.0f);
  glVertex3f(0.0f, 1.0f, 0.0f);
  glEnd();
}

static int pixel_is(int x, int y, int red, int green, int blue) {
  GLubyte pixel[4] = {1, 2, 3, 4};
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  /* One step: 0.5 lies half-way between two of the 256 steps. */
  if (abs(pixel[0] - red) <= 1 && abs(pixel[1] - green) <= 1 && abs(pixel[2] - blue) <= 1) return 1;
  fprintf(stderr, "pixel (%d, %d) is %d %d %d, not %d %d %d\n", x, y, pixel[0], pixel[1], pixel[2],
          red, green, blue);
  return 0;
}

static int draws_are_counted(void) {
  legacy_gl_statistics statistics = LEGACY_GL_STATISTICS_INIT;
  if (legacy_gl_get_statistics(&statistics) == LEGACY_GL_OK && statistics.draws == 1) return 1;
  fprintf(stderr, "%s; %d draws\n", legacy_gl_status_detail(), (int)statistics.draws);
  return 0;
}

static int picture_is_right(void) {
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR) fprintf(stderr, "glGetError: 0x%04x\n", (unsigned)error);
  /* Half of the diffuse colour inside, the clear colour outside. */
  return (error == GL_NO_ERROR) & pixel_is(WIDTH / 2, HEIGHT / 2, 128, 51, 0) &
         pixel_is(0, HEIGHT - 1, 0, 0, 255);
}

#endif
