#include "platform/drop_in_context.hpp"

#include <legacy_gl/framebuffer_objects.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

namespace legacy_gl::platform {

namespace {

/// Beside ours: what the exported functions of framebuffer objects make of the driver's.
constexpr const char* kOfferedExtensions =
    "GL_ARB_framebuffer_object "
    "GL_EXT_framebuffer_object=GL_ARB_framebuffer_object "
    "GL_EXT_framebuffer_blit=GL_ARB_framebuffer_object "
    "GL_EXT_framebuffer_multisample=GL_ARB_framebuffer_object "
    "GL_EXT_packed_depth_stencil=GL_ARB_framebuffer_object";

struct DropInContext;
using Shared = std::shared_ptr<DropInContext>;

struct DropInContext {
  std::shared_ptr<std::vector<std::weak_ptr<DropInContext>>> group;  ///< that share lists
  legacy_gl_context* ours = nullptr;  ///< made when the driver's is current for the first time
  bool refused = false;               ///< ours could not be made
  std::atomic<bool> current = false;  ///< in some thread
  bool accumulation_buffer = false;
  std::atomic<bool> forgotten = false;  ///< the program destroyed it
  Shared self;                          ///< while it is current
};

std::mutex mutex;

std::unordered_map<DriverContext, Shared>& contexts() {
  // Never destroyed: a program may call until its very end.
  static auto& map = *new std::unordered_map<DriverContext, Shared>;
  return map;
}

/// Without a destructor: programs destroy their contexts in exit handlers, which run after those of
/// the thread's variables.
thread_local constinit DropInContext* current = nullptr;

Shared find(DriverContext context) {
  const std::lock_guard lock(mutex);
  const auto at = contexts().find(context);
  return at == contexts().end() ? nullptr : at->second;
}

legacy_gl_context* shares_with(const DropInContext& context) {
  for (const auto& member : *context.group)
    if (const Shared other = member.lock(); other && other->ours) return other->ours;
  return nullptr;
}

void make_ours(DropInContext& context, legacy_gl_loader loader) {
  const std::lock_guard lock(mutex);
  legacy_gl_options options{};
  options.share = shares_with(context);
  options.accumulation_buffer = context.accumulation_buffer;
  options.scalars_for_vectors = 1;
  options.cache_directory = std::getenv("LEGACY_GL_CACHE_DIR");
  legacy_gl_status status = LEGACY_GL_OK;
  context.ours = legacy_gl_create_context(loader, &options, &status);
  if (context.ours) return;
  context.refused = true;
  std::fprintf(stderr, "legacy_gl: no context: %s: %s\n", legacy_gl_status_string(status),
               legacy_gl_status_detail());
}

void destroy_ours(DropInContext& context) {
  const std::lock_guard lock(mutex);
  legacy_gl_destroy_context(context.ours);
  context.ours = nullptr;
}

/// The driver's context is still current.
void leave_current() {
  legacy_gl_make_current(nullptr);
  if (current && current->forgotten) destroy_ours(*current);
}

void enter(const Shared& next, legacy_gl_loader loader) {
  if (current) {
    current->current = false;
    const Shared released = std::move(current->self);
  }
  current = next.get();
  if (!next) return;
  next->self = next;
  const bool is_new = !next->ours && !next->refused;
  if (is_new) make_ours(*next, loader);
  if (!next->ours) return;
  legacy_gl_make_current(next->ours);
  if (is_new) legacy_gl_offer_extensions(kOfferedExtensions);
}

}  // namespace

void report_old_driver() {
  static std::atomic<bool> said = false;
  if (!said.exchange(true))
    std::fprintf(stderr, "legacy_gl: the driver gives no OpenGL 3.3 core context\n");
}

void adopt(DriverContext made, DriverContext share, bool accumulation_buffer) {
  const Shared other = share ? find(share) : nullptr;
  const auto context = std::make_shared<DropInContext>();
  context->accumulation_buffer = accumulation_buffer;
  context->group =
      other ? other->group : std::make_shared<std::vector<std::weak_ptr<DropInContext>>>();
  const std::lock_guard lock(mutex);
  context->group->push_back(context);
  contexts()[made] = context;
}

bool switch_to(DriverContext next, legacy_gl_loader loader,
               const std::function<bool()>& make_current) {
  const Shared found = next ? find(next) : nullptr;
  legacy_gl_flush();
  if (found && found.get() == current) return make_current();  // another surface at most
  if (found && found->current.exchange(true)) return false;    // in another thread
  leave_current();
  if (!make_current()) {
    if (found) found->current = false;
    if (current && current->ours) legacy_gl_make_current(current->ours);
    return false;
  }
  enter(found, loader);
  return true;
}

void forget(DriverContext context,
            const std::function<void(const std::function<void()>&)>& with_current) {
  const Shared found = find(context);
  if (!found) return;
  {
    const std::lock_guard lock(mutex);
    contexts().erase(context);
    found->forgotten = true;
  }
  if (found->current || !found->ours) return;
  legacy_gl_make_current(nullptr);
  with_current([&] { destroy_ours(*found); });
  if (current && current->ours) legacy_gl_make_current(current->ours);
}

}  // namespace legacy_gl::platform
