/* What a person can change about the scene. */
#ifndef LIGHTING_SETTINGS_H
#define LIGHTING_SETTINGS_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct material {
  const char* name;
  float ambient[4];
  float diffuse[4];
  float specular[4];
  float shininess;
} material;

/* The materials of the usual table (Teapot poster, OpenGL Programming Guide). */
enum { MATERIAL_BRASS, MATERIAL_TURQUOISE, MATERIAL_BLACK_PLASTIC, MATERIAL_COUNT };
extern const material materials[MATERIAL_COUNT];

typedef struct light {
  int on;
  float position[4]; /* world coordinates; w = 0: the direction towards the light */
  float ambient[4];
  float diffuse[4];
  float specular[4];
  float attenuation[3]; /* k0, k1, k2 of 1 / (k0 + k1 d + k2 d^2) */
  float spot_direction[3];
  float spot_cutoff_degrees; /* 180: no spot */
  float spot_exponent;
} light;

enum { LIGHT_DIRECTIONAL, LIGHT_POSITIONAL, LIGHT_SPOT, LIGHT_COUNT };

enum { SHAPE_SPHERE, SHAPE_CUBE, SHAPE_TORUS, SHAPE_COUNT };

typedef struct settings {
  int width;
  int height;

  int shape_shown[SHAPE_COUNT];
  int shape_material[SHAPE_COUNT];
  int back_material;
  float torus_sweep_degrees; /* less than 360: an open torus */
  int detail;                /* segments around a shape */

  light lights[LIGHT_COUNT];
  float global_ambient[4];
  float emission[4];
  float shininess; /* < 0: each material's own */
  int local_viewer;
  int two_sided;
  int separate_specular;
  int faceted; /* GL_FLAT */
} settings;

settings default_settings(void);

void draw_scene_by_mesa(const settings* s);
void draw_scene_by_legacy_gl(const settings* s);

#ifdef __cplusplus
}
#endif

#endif
