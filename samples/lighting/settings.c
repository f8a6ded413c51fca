#include "settings.h"

const material materials[MATERIAL_COUNT] = {
    {"brass",
     {0.329412f, 0.223529f, 0.027451f, 1.0f},
     {0.780392f, 0.568627f, 0.113725f, 1.0f},
     {0.992157f, 0.941176f, 0.807843f, 1.0f},
     27.8974f},
    {"turquoise",
     {0.1f, 0.18725f, 0.1745f, 1.0f},
     {0.396f, 0.74151f, 0.69102f, 1.0f},
     {0.297254f, 0.30829f, 0.306678f, 1.0f},
     12.8f},
    {"black-plastic",
     {0.0f, 0.0f, 0.0f, 1.0f},
     {0.01f, 0.01f, 0.01f, 1.0f},
     {0.5f, 0.5f, 0.5f, 1.0f},
     32.0f},
};

settings default_settings(void) {
  const settings s =
      {
          .width = 800,
          .height = 600,
          .shape_shown = {1, 1, 1},
          .shape_material = {MATERIAL_BRASS, MATERIAL_TURQUOISE, MATERIAL_BLACK_PLASTIC},
          .back_material = MATERIAL_BRASS,
          .torus_sweep_degrees = 360.0f,
          .detail = 128,
          .lights =
              {
                  [LIGHT_DIRECTIONAL] = {.on = 1,
                                         .position = {-0.45f, 0.8f, 0.55f, 0.0f},
                                         .ambient = {0.0f, 0.0f, 0.0f, 1.0f},
                                         .diffuse = {0.42f, 0.42f, 0.46f, 1.0f},
                                         .specular = {0.7f, 0.7f, 0.75f, 1.0f},
                                         .attenuation = {1.0f, 0.0f, 0.0f},
                                         .spot_direction = {0.0f, -1.0f, 0.0f},
                                         .spot_cutoff_degrees = 180.0f},
                  [LIGHT_POSITIONAL] = {.on = 1,
                                        .position = {1.95f, 2.6f, 2.2f, 1.0f},
                                        .ambient = {0.05f, 0.04f, 0.03f, 1.0f},
                                        .diffuse = {1.0f, 0.78f, 0.55f, 1.0f},
                                        .specular = {1.0f, 0.85f, 0.7f, 1.0f},
                                        .attenuation = {0.5f, 0.05f, 0.12f},
                                        .spot_direction = {0.0f, -1.0f, 0.0f},
                                        .spot_cutoff_degrees = 180.0f},
                  [LIGHT_SPOT] = {.on = 1,
                                  .position = {-1.3f, 4.2f, 2.6f, 1.0f},
                                  .ambient = {0.0f, 0.0f, 0.0f, 1.0f},
                                  .diffuse = {0.8f, 0.95f, 1.2f, 1.0f},
                                  .specular = {0.9f, 1.0f, 1.2f, 1.0f},
                                  .attenuation = {1.0f, 0.0f, 0.0f},
                                  .spot_direction = {0.27f, -1.0f, -0.58f},
                                  .spot_cutoff_degrees = 28.0f,
                                  .spot_exponent = 30.0f},
              },
          .global_ambient = {0.2f, 0.2f, 0.2f, 1.0f},
          .emission = {0.0f, 0.0f, 0.0f, 1.0f},
          .shininess = -1.0f,
      };
  return s;
}
