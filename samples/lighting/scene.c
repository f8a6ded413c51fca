/* Three shapes on a floor under three lights, as a program of 1997 draws them. The file knows
 * nothing of shaders, buffers or of which OpenGL it is compiled for. */
#include "old_gl.h"
#include "settings.h"
#include "shapes.h"

static void set_projection(const settings* s) {
  glViewport(0, 0, s->width, s->height);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  gluPerspective(32.0, (GLdouble)s->width / s->height, 1.0, 40.0);
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
}

/* A vertical gradient behind everything, in normalised device coordinates. */
static void draw_background(void) {
  glDisable(GL_LIGHTING);
  glDisable(GL_DEPTH_TEST);
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  glShadeModel(GL_SMOOTH);
  glBegin(GL_QUADS);
  glColor3ub(30, 34, 46);
  glVertex2f(-1.0f, -1.0f);
  glVertex2f(1.0f, -1.0f);
  glColor3ub(96, 112, 138);
  glVertex2f(1.0f, 1.0f);
  glVertex2f(-1.0f, 1.0f);
  glEnd();
  glEnable(GL_DEPTH_TEST);
}

static void set_light(GLenum name, const light* l) {
  if (!l->on) {
    glDisable(name);
    return;
  }
  glEnable(name);
  /* Under the viewing transformation, so that the light stands still in the scene. */
  glLightfv(name, GL_POSITION, l->position);
  glLightfv(name, GL_SPOT_DIRECTION, l->spot_direction);
  glLightfv(name, GL_AMBIENT, l->ambient);
  glLightfv(name, GL_DIFFUSE, l->diffuse);
  glLightfv(name, GL_SPECULAR, l->specular);
  glLightf(name, GL_CONSTANT_ATTENUATION, l->attenuation[0]);
  glLightf(name, GL_LINEAR_ATTENUATION, l->attenuation[1]);
  glLightf(name, GL_QUADRATIC_ATTENUATION, l->attenuation[2]);
  glLightf(name, GL_SPOT_CUTOFF, l->spot_cutoff_degrees);
  glLightf(name, GL_SPOT_EXPONENT, l->spot_exponent);
}

static void set_lighting(const settings* s) {
  int i;
  glEnable(GL_LIGHTING);
  glEnable(GL_NORMALIZE);
  glShadeModel(s->faceted ? GL_FLAT : GL_SMOOTH);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, s->global_ambient);
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, s->local_viewer);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, s->two_sided);
  glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                s->separate_specular ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
  for (i = 0; i < LIGHT_COUNT; i++) set_light(GL_LIGHT0 + (GLenum)i, &s->lights[i]);
}

static void set_material(const settings* s, GLenum face, int index) {
  const material* m = &materials[index];
  glMaterialfv(face, GL_AMBIENT, m->ambient);
  glMaterialfv(face, GL_DIFFUSE, m->diffuse);
  glMaterialfv(face, GL_SPECULAR, m->specular);
  glMaterialfv(face, GL_EMISSION, s->emission);
  glMaterialf(face, GL_SHININESS, s->shininess < 0.0f ? m->shininess : s->shininess);
}

static void set_matt_material(void) {
  static const GLfloat grey[4] = {0.55f, 0.55f, 0.57f, 1.0f};
  static const GLfloat none[4] = {0.0f, 0.0f, 0.0f, 1.0f};
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, grey);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, none);
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, none);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 0.0f);
}

/* A small bulb where a light stands, glowing by emission alone. */
static void draw_bulb(const light* l) {
  static const GLfloat none[4] = {0.0f, 0.0f, 0.0f, 1.0f};
  if (!l->on || l->position[3] == 0.0f) return;
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, none);
  glMaterialfv(GL_FRONT_AND_BACK, GL_SPECULAR, none);
  glMaterialfv(GL_FRONT_AND_BACK, GL_EMISSION, l->diffuse);
  glPushMatrix();
  glTranslatef(l->position[0], l->position[1], l->position[2]);
  draw_sphere(0.07f, 32);
  glPopMatrix();
}

static void draw_shapes(const settings* s) {
  int i;
  GLuint lists = glGenLists(SHAPE_COUNT);
  glNewList(lists + SHAPE_SPHERE, GL_COMPILE);
  draw_sphere(1.0f, s->detail);
  glEndList();
  glNewList(lists + SHAPE_CUBE, GL_COMPILE);
  draw_cube(0.78f, s->detail / 4);
  glEndList();
  glNewList(lists + SHAPE_TORUS, GL_COMPILE);
  draw_torus(0.86f, 0.3f, s->torus_sweep_degrees, s->detail, s->detail / 2);
  glEndList();

  for (i = 0; i < SHAPE_COUNT; i++) {
    if (!s->shape_shown[i]) continue;
    set_material(s, GL_FRONT, s->shape_material[i]);
    set_material(s, GL_BACK, s->back_material);
    glPushMatrix();
    switch (i) {
      case SHAPE_SPHERE: glTranslatef(-2.3f, 1.0f, -0.2f); break;
      case SHAPE_CUBE:
        glTranslatef(2.35f, 0.78f, -0.35f);
        glRotatef(-52.0f, 0.0f, 1.0f, 0.0f);
        break;
      default:
        glTranslatef(0.0f, 1.05f, 0.3f);
        glRotatef(-62.0f, 1.0f, 0.0f, 0.0f);
        glRotatef(-24.0f, 0.0f, 0.0f, 1.0f);
        break;
    }
    glCallList(lists + (GLuint)i);
    glPopMatrix();
  }
  glDeleteLists(lists, SHAPE_COUNT);
}

void draw_scene(const settings* s) {
  int i;
  glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_background();

  set_projection(s);
  gluLookAt(0.3, 3.9, 9.6, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0);
  set_lighting(s);
  set_matt_material();
  draw_floor(9.0f, 220);
  draw_shapes(s);
  for (i = 0; i < LIGHT_COUNT; i++) draw_bulb(&s->lights[i]);
  glFinish();
}
