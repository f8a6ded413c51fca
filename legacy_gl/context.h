/* Contexts of legacy_gl: create one over a core profile (GL >= 3.3) or GLES (>= 3.0) context that
 * is current, make it current, and call the OpenGL 1.x entry points of <legacy_gl/gl.h>.
 *
 *     legacy_gl_status status;
 *     legacy_gl_context *context = legacy_gl_create_context(loader, NULL, &status);
 *     if (!context) puts(legacy_gl_status_detail());
 *     legacy_gl_make_current(context);
 *
 * Threads: one current context a thread; a context is current in at most one thread. Every function
 * that reaches the driver expects the driver context that was current at creation to be current in
 * the calling thread.
 *
 * The contract with a program that also calls the core GL itself is docs/coexistence.md. */
#ifndef LEGACY_GL_CONTEXT_H
#define LEGACY_GL_CONTEXT_H

#include <legacy_gl/export.h>
#include <legacy_gl/version.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct legacy_gl_context legacy_gl_context;

typedef void (*legacy_gl_proc)(void);
/** The driver's get-proc-address, for example OSMesaGetProcAddress or eglGetProcAddress. */
typedef legacy_gl_proc (*legacy_gl_loader)(const char* name);

typedef enum legacy_gl_status {
  LEGACY_GL_OK = 0,
  LEGACY_GL_INVALID_ARGUMENT,  /**< a NULL loader, or an option out of its range */
  LEGACY_GL_NO_DRIVER_CONTEXT, /**< the driver answers no version: no context is current */
  LEGACY_GL_DRIVER_TOO_OLD,    /**< below GL 3.3 and below GLES 3.0 */
  LEGACY_GL_MISSING_FUNCTION,  /**< the loader has no address for a function that is needed */
  LEGACY_GL_CURRENT_ELSEWHERE, /**< the context is current in another thread */
  LEGACY_GL_NO_CURRENT,        /**< no context of this library is current in this thread */
  LEGACY_GL_OUT_OF_MEMORY
} legacy_gl_status;

/** What one call's lighting may cost, and how wrong it may be: docs/accuracy.md has the figures. */
typedef enum legacy_gl_quality {
  LEGACY_GL_QUALITY_DEFAULT = 0,
  LEGACY_GL_QUALITY_FASTEST,     /**< error bounded by 0.25/255 */
  LEGACY_GL_QUALITY_PRECISE,     /**< ten times as accurate as Mesa, at up to twice its time */
  LEGACY_GL_QUALITY_PER_FRAGMENT /**< Phong interpolation: the same equation in every fragment */
} legacy_gl_quality;

/** Programs are generated for the state they draw. The first state of all has its own at once. The
 * first use of any other is drawn by a general program, whose colours agree within half a step of 8
 * bits and whose positions agree to the bit; the specialised one is compiled when the state has
 * drawn enough to be worth it. */
typedef enum legacy_gl_programs {
  LEGACY_GL_PROGRAMS_DEFAULT = 0, /**< LEGACY_GL_PROGRAMS_GENERAL_FIRST */
  LEGACY_GL_PROGRAMS_GENERAL_FIRST,
  LEGACY_GL_PROGRAMS_SPECIALISED, /**< always the specialised one: a first use waits for it */
  LEGACY_GL_PROGRAMS_GENERAL      /**< never specialised: slowest to draw, soonest to start */
} legacy_gl_programs;

/** Called once for each thing that a program asks for and this library does not do. `message` is
 * valid during the call. */
typedef void (*legacy_gl_diagnostic)(const char* message, void* user);

/* The structs below begin with their size, so that a program and a library of different versions
 * understand each other. In C initialise them with LEGACY_GL_..._INIT; in C++11 and later they
 * initialise their size themselves (`legacy_gl_options options{};`). */
#if defined(__cplusplus) && __cplusplus >= 201103L
#define LEGACY_GL_OWN_SIZE(type) = sizeof(type)
#define LEGACY_GL_OPTIONS_INIT \
  {}
#define LEGACY_GL_STATISTICS_INIT \
  {}
#elif defined(__cplusplus)
#define LEGACY_GL_OWN_SIZE(type)
#define LEGACY_GL_OPTIONS_INIT \
  { sizeof(legacy_gl_options) }
#define LEGACY_GL_STATISTICS_INIT \
  { sizeof(legacy_gl_statistics) }
#else
#define LEGACY_GL_OWN_SIZE(type)
#define LEGACY_GL_OPTIONS_INIT \
  { .size = sizeof(legacy_gl_options) }
#define LEGACY_GL_STATISTICS_INIT \
  { .size = sizeof(legacy_gl_statistics) }
#endif

/** Every other field's zero means its default. A library that is older than the program refuses
 * fields that it does not know, unless they are 0. */
typedef struct legacy_gl_options {
  size_t size LEGACY_GL_OWN_SIZE(legacy_gl_options); /**< set by LEGACY_GL_OPTIONS_INIT */
  unsigned max_lights;                               /**< GL_MAX_LIGHTS: 8 to 256; 0: 8 */
  legacy_gl_quality quality;
  legacy_gl_diagnostic diagnostic; /**< NULL: stderr */
  void* diagnostic_user;
  legacy_gl_context* share; /**< display lists, textures and buffer objects are shared with this
                              context, the latter two as far as the two driver contexts share
                              objects; NULL: with none */
  /** Where compiled programs are kept for the next run; NULL: nowhere. Made if it is missing. A
   * file there that is damaged, of another driver or of another version is ignored. The text is
   * copied. */
  const char* cache_directory;
  size_t cache_bytes; /**< what all files there may take, the oldest go first; 0: 32 MiB */
  legacy_gl_programs programs;
  int accumulation_buffer; /**< 1: the context has an accumulation buffer for glAccum */
  int scalars_for_vectors; /**< 1: glMaterialf and its like, called with a name of several values,
                              set the first and the others to 0, as Mesa does and the drop-in
                              lets its programs; 0: GL_INVALID_ENUM, as the specification says */
  int debug_labels;        /**< 1: KHR_debug labels and groups where the driver has them, for
                              RenderDoc and apitrace: docs/debugging.md; 0: where LEGACY_GL_DEBUG
                              has "labels", or the driver's context is a debug context */
  /** What is to be believed of the driver against what is found, e.g. "-rasterises_on_cpu" or
   * "generic": docs/driver_traits.md lists the names, a minus turns one off. The environment
   * variable LEGACY_GL_DRIVER_TRAITS wins. NULL: what is found. The text is read at once. */
  const char* driver_traits;
} legacy_gl_options;

/** Counters since creation or the last reset. Sizes in bytes. */
typedef struct legacy_gl_statistics {
  size_t size LEGACY_GL_OWN_SIZE(legacy_gl_statistics); /**< set by LEGACY_GL_STATISTICS_INIT */
  uint64_t programs_generated;     /**< program variants turned into GLSL text */
  uint64_t programs_compiled;      /**< programs compiled and linked by the driver */
  uint64_t fragment_stages_shared; /**< programs with the fragment stage of an earlier one */
  uint64_t programs_loaded;        /**< programs taken from the cache directory */
  uint64_t general_draws;          /**< draws that a general program stood in for */
  uint64_t program_switches;
  uint64_t draws;    /**< draw calls handed to the driver */
  uint64_t batches;  /**< groups of primitives that shared one state */
  uint64_t vertices; /**< vertices handed to the driver */
  uint64_t vertex_bytes_uploaded;
  uint64_t index_bytes_uploaded;
  uint64_t uniform_bytes_uploaded;
  uint64_t uniform_block_updates;
  uint64_t begin_end_merged;    /**< Begin/End pairs that joined the batch before them */
  uint64_t lights_skipped;      /**< enabled lights that a draw left out since they add nothing */
  uint64_t light_terms_skipped; /**< zero terms (ambient, diffuse, specular) of the other lights */
  uint64_t attenuations_folded; /**< constant attenuations that no vertex computes */
  uint64_t spot_exponents_skipped; /**< spots of exponent 0 */
  uint64_t normalizations_skipped; /**< draws whose normals GL_NORMALIZE leaves as they are */
  uint64_t back_faces_skipped;     /**< two-sided lighting of faces that are culled */
  uint64_t lights_culled; /**< enabled lights that a draw left out since they do not reach it */
  uint64_t normal_matrix_updates; /**< times the normal matrix was computed */
  uint64_t list_vertices_welded;  /**< vertices that display lists share rather than repeat */
  uint64_t primitives_clipped;    /**< batches and list draws skipped: all is outside the view */
  uint64_t
      draws_lit_on_cpu; /**< small objects that were lit on the CPU, to share draws with others */
} legacy_gl_statistics;

/** LEGACY_GL_VERSION of the library that is linked, which may be newer than these headers. */
LEGACY_GL_API int legacy_gl_version(void);

/** Creates a context over the driver's current context. NULL options: defaults. On failure returns
 * NULL and, when `status` is not NULL, says why there; legacy_gl_status_detail() names the function
 * or the version. */
LEGACY_GL_API legacy_gl_context* legacy_gl_create_context(legacy_gl_loader loader,
                                                          const legacy_gl_options* options,
                                                          legacy_gl_status* status);

/** Makes the context current in this thread; NULL releases the one that is. What the context before
 * it had recorded is handed to the driver first. */
LEGACY_GL_API legacy_gl_status legacy_gl_make_current(legacy_gl_context* context);

/** The current context of this thread, or NULL. */
LEGACY_GL_API legacy_gl_context* legacy_gl_get_current(void);

/** Destroys the context and its driver objects. The driver context must be current. NULL is
 * ignored. */
LEGACY_GL_API void legacy_gl_destroy_context(legacy_gl_context* context);

/** "glLightfv" -> the address of lglLightfv; NULL for a name that OpenGL 1.0 to 1.5 does not have.
 */
LEGACY_GL_API legacy_gl_proc legacy_gl_get_proc_address(const char* name);

/** Hands all that is recorded to the driver. Call before touching the framebuffer or swapping by
 * other means. */
LEGACY_GL_API void legacy_gl_flush(void);

/** Forgets what this library believes is bound in the driver: call after the program used the core
 * GL itself. */
LEGACY_GL_API void legacy_gl_reset_driver_state(void);

/** Fills the counters of the current context, of those that fit in `statistics->size` bytes. What
 * the library does not know stays as it is. */
LEGACY_GL_API legacy_gl_status legacy_gl_get_statistics(legacy_gl_statistics* statistics);
LEGACY_GL_API void legacy_gl_reset_statistics(void);

/** The program key in words, the vertex shader and the fragment shader of the program that the
 * current state draws with. Writes at most `size` bytes with the closing 0, returns the length that
 * the whole text has. */
LEGACY_GL_API size_t legacy_gl_get_program_source(char* text, size_t size);

/** The keys of the programs that this context has drawn with, as text of one line each: what
 * legacy_gl_precompile takes in a later run. Writes at most `size` bytes with the closing 0,
 * returns the length that the whole text has. */
LEGACY_GL_API size_t legacy_gl_get_program_keys(char* text, size_t size);

/** Compiles (or loads from the cache directory) the programs of such a text now, so that no draw
 * has to. Returns how many keys of the text are ready. Keys of another version of this library, and
 * whatever else is not a key, are passed over. */
LEGACY_GL_API size_t legacy_gl_precompile(const char* keys, size_t length);

/** The status in words, e.g. "the driver is too old". */
LEGACY_GL_API const char* legacy_gl_status_string(legacy_gl_status status);

/** What the last status of this thread that was not LEGACY_GL_OK was about, e.g.
 * "glMapBufferRange". */
LEGACY_GL_API const char* legacy_gl_status_detail(void);

#ifdef __cplusplus
}
#endif
#endif
