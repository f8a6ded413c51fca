#include <exception>
#include <legacy_gl/context.hpp>

#include "lit_triangle.h"
#include "version.h"

int main() {
  OSMesaContext driver = make_driver_context();
  if (!driver || !versions_agree()) return EXIT_FAILURE;
  bool right = false;
  try {
    const legacy_gl_options options = LEGACY_GL_OPTIONS_INIT;
    legacy_gl::OwnedContext context(reinterpret_cast<legacy_gl_loader>(OSMesaGetProcAddress),
                                    options);
    context.make_current();
    draw_lit_triangle();
    right = picture_is_right() && draws_are_counted();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  OSMesaDestroyContext(driver);
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
