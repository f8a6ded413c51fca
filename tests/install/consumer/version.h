/* Headers, library and package are of one version. PACKAGE_VERSION is what the package says. */
#ifndef VERSION_H
#define VERSION_H

#include <legacy_gl/context.h>
#include <stdio.h>
#include <string.h>

#if LEGACY_GL_VERSION < LEGACY_GL_MAKE_VERSION(0, 1, 0)
#error "versions cannot be compared by the preprocessor"
#endif

static int versions_agree(void) {
  char headers[32];
  snprintf(headers, sizeof headers, "%d.%d.%d", LEGACY_GL_VERSION_MAJOR, LEGACY_GL_VERSION_MINOR,
           LEGACY_GL_VERSION_PATCH);
  if (strcmp(headers, PACKAGE_VERSION) == 0 && legacy_gl_version() == LEGACY_GL_VERSION) return 1;
  fprintf(stderr, "headers %s, package %s, library %d\n", headers, PACKAGE_VERSION,
          legacy_gl_version());
  return 0;
}

#endif
