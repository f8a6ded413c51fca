/* molecule FILE: draws a molecule of methanol into a PPM file.
 *
 * A small program of the old kind: it makes an off-screen OpenGL context with OSMesa and draws with
 * lights, materials, display lists, the matrix stack and GLU quadrics. */
#include <GL/gl.h>
#include <GL/glu.h>
#include <GL/osmesa.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define WIDTH 400
#define HEIGHT 300

typedef struct {
  GLfloat position[3];
  GLfloat radius;
  GLfloat color[3];
} Atom;

static const Atom atoms[] = {
    {{-0.75f, 0.0f, 0.0f}, 0.42f, {0.3f, 0.3f, 0.32f}}, /* carbon */
    {{0.67f, 0.0f, 0.0f}, 0.4f, {0.8f, 0.1f, 0.08f}},   /* oxygen */
    {{-1.1f, 1.03f, 0.0f}, 0.27f, {0.9f, 0.9f, 0.9f}},  /* hydrogen */
    {{-1.1f, -0.51f, 0.89f}, 0.27f, {0.9f, 0.9f, 0.9f}},
    {{-1.1f, -0.51f, -0.89f}, 0.27f, {0.9f, 0.9f, 0.9f}},
    {{1.0f, -0.45f, 0.8f}, 0.27f, {0.9f, 0.9f, 0.9f}},
};

static const int bonds[][2] = {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 5}};

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static GLuint ball, rod;

static void make_lists(void) {
  GLUquadricObj* quadric = gluNewQuadric();
  ball = glGenLists(2);
  rod = ball + 1;
  glNewList(ball, GL_COMPILE);
  gluSphere(quadric, 1.0, 48, 32);
  glEndList();
  glNewList(rod, GL_COMPILE);
  gluCylinder(quadric, 0.11, 0.11, 1.0, 32, 8);
  glEndList();
  gluDeleteQuadric(quadric);
}

/* Points the z axis from one atom to another, and makes it as long as they are apart. */
static void aim(const GLfloat from[3], const GLfloat to[3]) {
  GLfloat x = to[0] - from[0], y = to[1] - from[1], z = to[2] - from[2];
  GLfloat length = sqrtf(x * x + y * y + z * z);
  glTranslatef(from[0], from[1], from[2]);
  glRotatef(acosf(z / length) * 57.29578f, -y, x, 0.0f);
  glScalef(1.0f, 1.0f, length);
}

static void draw(void) {
  static const GLfloat light[] = {-2.0f, 3.0f, 4.0f, 1.0f};
  static const GLfloat white[] = {0.7f, 0.7f, 0.7f, 1.0f};
  size_t i;

  glViewport(0, 0, WIDTH, HEIGHT);
  glClearColor(0.13f, 0.15f, 0.2f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glMatrixMode(GL_PROJECTION);
  gluPerspective(35.0, (double)WIDTH / HEIGHT, 1.0, 20.0);
  glMatrixMode(GL_MODELVIEW);
  gluLookAt(2.6, 1.6, 5.0, 0.0, 0.1, 0.0, 0.0, 1.0, 0.0);

  glEnable(GL_DEPTH_TEST);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightfv(GL_LIGHT0, GL_POSITION, light);
  glMaterialfv(GL_FRONT, GL_SPECULAR, white);
  glMaterialf(GL_FRONT, GL_SHININESS, 60.0f);
  glEnable(GL_COLOR_MATERIAL);
  glEnable(GL_NORMALIZE);

  for (i = 0; i < COUNT(atoms); i++) {
    glPushMatrix();
    glTranslatef(atoms[i].position[0], atoms[i].position[1], atoms[i].position[2]);
    glScalef(atoms[i].radius, atoms[i].radius, atoms[i].radius);
    glColor3fv(atoms[i].color);
    glCallList(ball);
    glPopMatrix();
  }
  glColor3f(0.6f, 0.62f, 0.65f);
  for (i = 0; i < COUNT(bonds); i++) {
    glPushMatrix();
    aim(atoms[bonds[i][0]].position, atoms[bonds[i][1]].position);
    glCallList(rod);
    glPopMatrix();
  }
}

static GLubyte framebuffer[HEIGHT][WIDTH][4];

static void write_ppm(const char* path) {
  FILE* file = fopen(path, "wb");
  int x, y;
  if (!file) {
    perror(path);
    exit(1);
  }
  fprintf(file, "P6 %d %d 255\n", WIDTH, HEIGHT);
  for (y = HEIGHT - 1; y >= 0; y--) {
    for (x = 0; x < WIDTH; x++) fwrite(framebuffer[y][x], 1, 3, file);
  }
  fclose(file);
}

int main(int argc, char** argv) {
  OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, NULL);
  if (argc != 2) {
    fprintf(stderr, "usage: %s FILE\n", argv[0]);
    return 1;
  }
  if (!context || !OSMesaMakeCurrent(context, framebuffer, GL_UNSIGNED_BYTE, WIDTH, HEIGHT)) {
    fprintf(stderr, "no OpenGL context\n");
    return 1;
  }

  make_lists();
  draw();
  glFinish();
  write_ppm(argv[1]);

  OSMesaDestroyContext(context);
  return 0;
}
