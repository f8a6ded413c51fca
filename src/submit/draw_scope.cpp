#include "submit/draw_scope.hpp"

#include <algorithm>

#include "debug/enum_names.hpp"
#include "driver/debug_labels.hpp"
#include "driver/driver_objects.hpp"

namespace legacy_gl {

DrawnPrimitives::DrawnPrimitives(const std::vector<PrimitiveRun>& runs, std::uint32_t count)
    : mode(runs.empty() ? GLenum{GL_POINTS} : runs.front().mode),
      others(std::any_of(runs.begin(), runs.end(),
                         [this](const PrimitiveRun& run) { return run.mode != mode; })),
      vertices(count) {}

void DrawScope::open(const PathChoice& choice, const DrawnPrimitives& primitives) {
  if (debug::wants(debug::kPaths)) {
    const char* const call = debug::current_call();
    debug::log("  %s draws %s%s, %u vertices: %s (%s)", call ? call : "legacy_gl",
               debug::enum_text("PrimitiveType", primitives.mode).c_str(),
               primitives.others ? " and others" : "", primitives.vertices, name_of(choice.path),
               choice.rule);
  }
  // The other paths call the driver later, under another path.
  open_ = choice.path != DrawPath::kRecorder && choice.path != DrawPath::kCpuPipeline;
  if (open_) push_debug_group(context_.driver->functions, name_of(choice.path));
}

void DrawScope::close() { pop_debug_group(context_.driver->functions); }

}  // namespace legacy_gl
