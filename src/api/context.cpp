// The C API of <legacy_gl/context.h>.
#include "record/pending.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "api/sized_structs.hpp"
#include "api/whole_context.hpp"
#include "debug/log.hpp"
#include "dlist/dispatch.hpp"
#include "driver/debug_labels.hpp"
#include "driver/driver_objects.hpp"
#include "execute/framebuffer.hpp"
#include "submit/prepare.hpp"

namespace legacy_gl {

namespace {

/// By a pointer: thread variables of a library take room of which a process has little. nullptr: no
/// detail, or no memory for one.
thread_local std::unique_ptr<std::string> status_detail;

legacy_gl_status fail(legacy_gl_status status, std::string_view detail) {
  try {
    if (!status_detail) status_detail = std::make_unique<std::string>();
    *status_detail = detail;
  } catch (const std::bad_alloc&) {
    status_detail.reset();
  }
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

void choose_paths(Context& context) {
  const char* const variable = std::getenv("LEGACY_GL_DISABLE");
  if (!variable) return;
  std::string unknown;
  context.paths = without_paths(variable, unknown);
  if (!unknown.empty()) diagnose(context, "LEGACY_GL_DISABLE names no path by " + unknown);
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
  debug::read_environment();
  Driver driver;
  std::string detail;
  switch (load_driver(driver, loader, detail)) {
    case DriverStatus::kOk: break;
    case DriverStatus::kNoContext: return fail(LEGACY_GL_NO_DRIVER_CONTEXT, detail);
    case DriverStatus::kTooOld: return fail(LEGACY_GL_DRIVER_TOO_OLD, detail);
    case DriverStatus::kMissingFunction: return fail(LEGACY_GL_MISSING_FUNCTION, detail);
  }
  load_debug_labels(driver, loader, options.debug_labels != 0);
  auto whole = std::make_unique<WholeContext>(options);
  choose_paths(*whole);
  driver.traits = chosen_traits(*whole, driver, options.driver_traits);
  constexpr std::size_t kDefaultCacheBytes = std::size_t{32} << 20;
  whole->attach(driver, options.programs,
                ProgramFiles(options.cache_directory ? options.cache_directory : "",
                             options.cache_bytes ? options.cache_bytes : kDefaultCacheBytes));
  context = std::move(whole);
  if (options.share) {
    context->lists.names = options.share->lists.names;
    context->texture.shared = options.share->texture.shared;
    context->driver->buffers.share_with(options.share->driver->buffers);
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

}  // namespace legacy_gl

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
  } catch (...) {
    result = fail(LEGACY_GL_OUT_OF_MEMORY, "while the context was made");
  }
  if (status) *status = result;
  return result == LEGACY_GL_OK ? context.release() : nullptr;
}

legacy_gl_status legacy_gl_make_current(legacy_gl_context* context) {
  if (context == current_context) return LEGACY_GL_OK;
  const std::thread::id here = std::this_thread::get_id();
  std::thread::id nowhere{};
  if (context && !context->current_in.compare_exchange_strong(nowhere, here))
    return fail(LEGACY_GL_CURRENT_ELSEWHERE, "the context is current in another thread");
  if (current_context) {
    guarded(*current_context, [] { flush_pending(*current_context); });
    current_context->current_in = std::thread::id{};
  }
  current_context = context;
  update_direct_context();
  if (context) {
    forget_driver_state(*context);
    free_deleted(*context);
  }
  return LEGACY_GL_OK;
}

legacy_gl_context* legacy_gl_get_current(void) { return current_context; }

void legacy_gl_destroy_context(legacy_gl_context* context) {
  if (context == current_context) current_context = direct_context = nullptr;
  delete context;
}

void legacy_gl_flush(void) {
  Context* const context = current_context;
  if (!context) return;
  guarded(*context, [context] {
    flush_pending(*context);
    free_deleted(*context);
  });
}

void legacy_gl_reset_driver_state(void) {
  if (!current_context) return;
  forget_driver_state(*current_context);
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
  Context* const context = current_context;
  if (!context) return 0;
  return guarded(*context, [&] { return give(program_source(*context), text, size); });
}

size_t legacy_gl_get_program_keys(char* text, size_t size) {
  Context* const context = current_context;
  if (!context) return 0;
  return guarded(*context, [&] { return give(context->driver->programs.keys(), text, size); });
}

size_t legacy_gl_precompile(const char* keys, size_t length) {
  Context* const context = current_context;
  if (!context || !keys) return 0;
  return guarded(*context, [&] {
    flush_pending(*context);
    return context->driver->programs.precompile({keys, length}, context->statistics);
  });
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

const char* legacy_gl_status_detail(void) { return status_detail ? status_detail->c_str() : ""; }
