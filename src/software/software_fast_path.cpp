#include "software/software_fast_path.hpp"

#include "record/pending.hpp"

namespace legacy_gl {

std::unique_ptr<FastPath> make_software_fast_path(const Driver& driver) {
  if (!driver.traits.rasterises_on_cpu || !driver.traits.matches_cpu_arithmetic) return nullptr;
  return std::make_unique<SoftwareFastPath>();
}

bool SoftwareFastPath::finish_batch(Context& context) {
  const Recorder& recorder = context.recorder;
  if (recorder.is_shaded()) shade_vertices(context);
  else if (recorder.layout().fields & kFieldTransformed) transform_vertices(context);
  else return false;
  return true;
}

}  // namespace legacy_gl
