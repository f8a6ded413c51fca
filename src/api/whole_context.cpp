#include "api/whole_context.hpp"

#include <utility>

#if LEGACY_GL_SOFTWARE_FAST_PATH
#include "software/software_fast_path.hpp"
#endif

namespace legacy_gl {

/// What others may own too goes before the driver's side, which deletes what nobody owns then.
WholeContext::~WholeContext() {
  if (!driver) return;
  attribute_stacks = {};
  arrays = {};
  lists.names = nullptr;
  lists.compiling_list = nullptr;
  texture.units = {};
  texture.defaults = {};
  const std::shared_ptr<SharedTextures> shared = std::exchange(texture.shared, nullptr);
  if (shared.use_count() == 1) shared->names.erase(1, UINT32_MAX);
  driver->textures.free_deleted(*shared->deleted);
  driver->textures.free_deleted(*texture.deleted_defaults);
  driver->buffers.leave();
  driver->free_deleted();
}

void WholeContext::attach(const Driver& functions, legacy_gl_programs programs,
                          ProgramFiles files) {
  driver = &objects_.emplace(functions, programs, std::move(files));
  submission = &own_submission_.emplace(driver->functions);
#if LEGACY_GL_SOFTWARE_FAST_PATH
  submission->fast_path = make_software_fast_path(driver->functions);
#endif
  renderer = &own_renderer_;
}

}  // namespace legacy_gl
