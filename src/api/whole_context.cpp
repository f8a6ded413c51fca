#include "api/whole_context.hpp"

#include <utility>

#if LEGACY_GL_SOFTWARE_FAST_PATH
#include "software/software_fast_path.hpp"
#endif

namespace legacy_gl {

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
