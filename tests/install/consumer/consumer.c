#include <legacy_gl/context.h>

#include "lit_triangle.h"
#include "version.h"

int main(void) {
  OSMesaContext driver = make_driver_context();
  legacy_gl_status status = LEGACY_GL_OK;
  legacy_gl_context* context;
  legacy_gl_options options = LEGACY_GL_OPTIONS_INIT;
  int right = 0;
  if (!driver || !versions_agree()) return EXIT_FAILURE;

  context = legacy_gl_create_context((legacy_gl_loader)OSMesaGetProcAddress, &options, &status);
  if (context && (status = legacy_gl_make_current(context)) == LEGACY_GL_OK) {
    draw_lit_triangle();
    right = picture_is_right() && draws_are_counted();
  } else {
    fprintf(stderr, "%s: %s\n", legacy_gl_status_string(status), legacy_gl_status_detail());
  }
  legacy_gl_destroy_context(context);
  OSMesaDestroyContext(driver);
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
