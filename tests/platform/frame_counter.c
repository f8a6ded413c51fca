/* Preloaded into a program: counts its frames. After FRAME_COUNTER_WARM_UP frames and then
 * FRAME_COUNTER_SECONDS seconds it writes "frames wall-seconds cpu-seconds" to FRAME_COUNTER_FILE
 * and ends the program. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

static double wall_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static double cpu_seconds(void) {
  struct rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

static double number(const char* name, double fallback) {
  const char* const text = getenv(name);
  return text ? atof(text) : fallback;
}

static void count_frame(void) {
  static long frames;
  static double wall, cpu;
  const long warm_up = (long)number("FRAME_COUNTER_WARM_UP", 50);
  if (frames++ < warm_up) return;
  if (frames == warm_up + 1) {
    wall = wall_seconds();
    cpu = cpu_seconds();
    return;
  }
  const double passed = wall_seconds() - wall;
  if (passed < number("FRAME_COUNTER_SECONDS", 5)) return;
  FILE* const file = fopen(getenv("FRAME_COUNTER_FILE"), "w");
  if (file) {
    fprintf(file, "%ld %f %f\n", frames - warm_up - 1, passed, cpu_seconds() - cpu);
    fclose(file);
  }
  _exit(0);
}

__attribute__((visibility("default"))) void glXSwapBuffers(void* display, unsigned long drawable);
__attribute__((visibility("default"))) unsigned eglSwapBuffers(void* display, void* surface);
__attribute__((visibility("default"))) void SDL_GL_SwapBuffers(void);

void glXSwapBuffers(void* display, unsigned long drawable) {
  static void (*next)(void*, unsigned long);
  if (!next) *(void**)&next = dlsym(RTLD_NEXT, "glXSwapBuffers");
  next(display, drawable);
  count_frame();
}

unsigned eglSwapBuffers(void* display, void* surface) {
  static unsigned (*next)(void*, void*);
  if (!next) *(void**)&next = dlsym(RTLD_NEXT, "eglSwapBuffers");
  const unsigned result = next(display, surface);
  count_frame();
  return result;
}

/* SDL takes glXSwapBuffers from the library that it opened itself, where no preloaded one is met.
 */
void SDL_GL_SwapBuffers(void) {
  static void (*next)(void);
  if (!next) *(void**)&next = dlsym(RTLD_NEXT, "SDL_GL_SwapBuffers");
  next();
  count_frame();
}
