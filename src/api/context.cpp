// The C API of <legacy_gl/context.h>.
#include "context/context.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "api/sized_structs.hpp"
#include "cpu_pipeline/feedback.hpp"
#include "cpu_pipeline/selection.hpp"
#include "dlist/dispatch.hpp"
#include "execute/framebuffer.hpp"
#include "submit/backend.hpp"

namespace legacy_gl {

constinit thread_local Context* current_context = nullptr;
constinit thread_local Context* direct_context = nullptr;

void update_direct_context() {
  direct_context = current_context && !current_context->lists.compiling ? current_context : nullptr;
}

namespace {

thread_local std::string status_detail;

legacy_gl_status fail(legacy_gl_status status, std::string detail) {
  status_detail = std::move(detail);
  return status;
}

/// As much of `whole` as fits, with a closing 0; the length that all of it has.
std::size_t give(const std::string& whole, char* text, std::size_t size) {
  if (text && size) {
    const std::size_t count = std::min(size - 1, whole.size());
    std::memcpy(text, whole.data(), count);
    text[count] = 0;
  }
  return whole.size();
}

/// The driver's traits under the overrides of the options and, which win, of the environment.
DriverTraits chosen_traits(Context& context, const Driver& driver, const char* overrides) {
  std::string chosen = overrides ? overrides : "";
  if (const char* const variable = std::getenv("LEGACY_GL_DRIVER_TRAITS"))
    chosen.append(",").append(variable);
  std::string unknown;
  const DriverTraits traits = find_driver_traits(driver, chosen, unknown);
  if (!unknown.empty()) diagnose(context, "there are no driver traits named " + unknown);
  return traits;
}

legacy_gl_status create(legacy_gl_loader loader, const legacy_gl_options& options,
                        std::unique_ptr<Context>& context) {
  if (!loader) return fail(LEGACY_GL_INVALID_ARGUMENT, "the loader is NULL");
  if (options.max_lights > kMaxLights || (options.max_lights && options.max_lights < 8))
    return fail(LEGACY_GL_INVALID_ARGUMENT,
                "max_lights is " + std::to_string(options.max_lights) + ", not 8 to 256");
  if (options.programs < LEGACY_GL_PROGRAMS_DEFAULT ||
      options.programs > LEGACY_GL_PROGRAMS_GENERAL)
    return fail(LEGACY_GL_INVALID_ARGUMENT, "programs is not one of legacy_gl_programs");
  Driver driver;
  std::string detail;
  switch (load_driver(driver, loader, detail)) {
    case DriverStatus::kOk: break;
    case DriverStatus::kNoContext: return fail(LEGACY_GL_NO_DRIVER_CONTEXT, detail);
    case DriverStatus::kTooOld: return fail(LEGACY_GL_DRIVER_TOO_OLD, detail);
    case DriverStatus::kMissingFunction: return fail(LEGACY_GL_MISSING_FUNCTION, detail);
  }
  context = std::make_unique<Context>(options);
  driver.traits = chosen_traits(*context, driver, options.driver_traits);
  constexpr std::size_t kDefaultCacheBytes = std::size_t{32} << 20;
  context->backend = std::make_unique<Backend>(
      driver, options.programs,
      ProgramFiles(options.cache_directory ? options.cache_directory : "",
                   options.cache_bytes ? options.cache_bytes : kDefaultCacheBytes));
  if (options.share) {
    context->lists.names = options.share->lists.names;
    context->texture.names = options.share->texture.names;
  }
  // Table 6.x: viewport and scissor box start as the size of the window, which the driver knows.
  driver.GetIntegerv(GL_VIEWPORT, context->raster.viewport.box.data());
  driver.GetIntegerv(GL_SCISSOR_BOX, context->raster.scissor.box.data());
  GLfloat point_sizes[2] = {1, 1};
  driver.GetFloatv(driver.is_es() ? GL_ALIASED_POINT_SIZE_RANGE : GL_POINT_SIZE_RANGE, point_sizes);
  context->raster.point.size_max = point_sizes[1];
  context->raster.color_buffer.draw_buffer = context->read_buffer = initial_color_buffer(*context);
  return LEGACY_GL_OK;
}

}  // namespace

void raise_error(Context& context, GLenum error) {
  if (context.error == GL_NO_ERROR) context.error = error;
}

void diagnose(Context& context, const std::string& message) {
  if (!context.diagnostics_given.insert(message).second) return;
  if (context.options.diagnostic)
    context.options.diagnostic(message.c_str(), context.options.diagnostic_user);
  else std::fprintf(stderr, "legacy_gl: %s\n", message.c_str());
}

void report_no_context() {
  static thread_local bool said = false;
  if (said) return;
  said = true;
  std::fprintf(stderr, "legacy_gl: a GL function was called without a current context\n");
}

void leave_matrices(Context& context) {
  if (!context.recorder.has_pending() || context.recorder.all_lit()) return;
  if (light_object(context)) return;
  // Selection and feedback take vertices as they were given.
  if (!context.selection.is_rendering() || !context.backend->transform_recorded(context))
    draw_pending(context);
}

bool light_object(Context& context) {
  return context.selection.is_rendering() && !context.bitmaps_pending &&
         context.backend->light_recorded(context);
}

void leave_lighting(Context& context) {
  if (context.recorder.all_lit() && !context.bitmaps_pending) return;
  if (context.recorder.is_idle() || !light_object(context)) flush_pending(context);
}

bool stays_lit(Context& context) { return context.backend->stays_lit(context); }

namespace {

void without_rendering(Context& context) {
  if (context.selection.is_selecting()) select_recorded(context);
  else feed_back_recorded(context);
}

}  // namespace

void draw_pending(Context& context) {
  if (context.recorder.inside_begin_end()) return;
  if (!context.selection.is_rendering()) return without_rendering(context);
  if (context.bitmaps_pending) context.backend->draw_bitmaps(context);
  if (context.recorder.has_pending()) context.backend->draw_recorded(context, true);
}

void draw_part_of_batch(Context& context) {
  if (!context.selection.is_rendering()) return without_rendering(context);
  if (context.bitmaps_pending) context.backend->draw_bitmaps(context);
  context.backend->draw_recorded(context, false);
}

}  // namespace legacy_gl

legacy_gl_context::legacy_gl_context(const legacy_gl_options& chosen)
    : options(chosen), lighting(chosen.max_lights ? chosen.max_lights : 8) {
  options.share = nullptr;
  options.cache_directory = options.driver_traits = nullptr;  // the caller's texts
}

legacy_gl_context::~legacy_gl_context() = default;

using namespace legacy_gl;

int legacy_gl_version(void) { return LEGACY_GL_VERSION; }

legacy_gl_context* legacy_gl_create_context(legacy_gl_loader loader,
                                            const legacy_gl_options* options,
                                            legacy_gl_status* status) {
  std::unique_ptr<Context> context;
  legacy_gl_status result = LEGACY_GL_OK;
  try {
    legacy_gl_options known;
    const std::string wrong = read_options(options, known);
    result =
        wrong.empty() ? create(loader, known, context) : fail(LEGACY_GL_INVALID_ARGUMENT, wrong);
  } catch (const std::bad_alloc&) {
    result = LEGACY_GL_OUT_OF_MEMORY;
  }
  if (status) *status = result;
  return result == LEGACY_GL_OK ? context.release() : nullptr;
}

legacy_gl_status legacy_gl_make_current(legacy_gl_context* context) {
  if (context == current_context) return LEGACY_GL_OK;
  const std::thread::id here = std::this_thread::get_id();
  if (context && context->current_in != std::thread::id{} && context->current_in != here)
    return fail(LEGACY_GL_CURRENT_ELSEWHERE, "the context is current in another thread");
  if (current_context) {
    flush_pending(*current_context);
    current_context->current_in = {};
  }
  current_context = context;
  update_direct_context();
  if (context) {
    context->current_in = here;
    context->backend->reset_driver_state();
    context->dirty |= kDirtyRaster;
  }
  return LEGACY_GL_OK;
}

legacy_gl_context* legacy_gl_get_current(void) { return current_context; }

void legacy_gl_destroy_context(legacy_gl_context* context) {
  if (context == current_context) current_context = direct_context = nullptr;
  delete context;
}

void legacy_gl_flush(void) {
  if (current_context) flush_pending(*current_context);
}

void legacy_gl_reset_driver_state(void) {
  if (!current_context) return;
  current_context->backend->reset_driver_state();
  current_context->dirty |= kDirtyRaster;
}

legacy_gl_status legacy_gl_get_statistics(legacy_gl_statistics* statistics) {
  if (!current_context) return fail(LEGACY_GL_NO_CURRENT, "legacy_gl_make_current was not called");
  const std::string wrong = write_statistics(current_context->statistics, statistics);
  return wrong.empty() ? LEGACY_GL_OK : fail(LEGACY_GL_INVALID_ARGUMENT, wrong);
}

void legacy_gl_reset_statistics(void) {
  if (current_context) current_context->statistics = {};
}

size_t legacy_gl_get_program_source(char* text, size_t size) {
  if (!current_context) return 0;
  return give(current_context->backend->program_source(*current_context), text, size);
}

size_t legacy_gl_get_program_keys(char* text, size_t size) {
  if (!current_context) return 0;
  return give(current_context->backend->programs().keys(), text, size);
}

size_t legacy_gl_precompile(const char* keys, size_t length) {
  if (!current_context || !keys) return 0;
  flush_pending(*current_context);
  return current_context->backend->programs().precompile({keys, length},
                                                         current_context->statistics);
}

const char* legacy_gl_status_string(legacy_gl_status status) {
  switch (status) {
    case LEGACY_GL_OK: return "no error";
    case LEGACY_GL_INVALID_ARGUMENT: return "an argument is invalid";
    case LEGACY_GL_NO_DRIVER_CONTEXT: return "no driver context is current";
    case LEGACY_GL_DRIVER_TOO_OLD: return "the driver is too old";
    case LEGACY_GL_MISSING_FUNCTION: return "the driver misses a function";
    case LEGACY_GL_CURRENT_ELSEWHERE: return "the context is current in another thread";
    case LEGACY_GL_NO_CURRENT: return "no context is current in this thread";
    case LEGACY_GL_OUT_OF_MEMORY: return "out of memory";
  }
  return "unknown status";
}

const char* legacy_gl_status_detail(void) { return status_detail.c_str(); }
