#pragma once
#include "context/context.hpp"

namespace legacy_gl {

/// Draws the recorder's batch as it is.
void draw_batch_as_recorded(Context& context);

/// Makes the recorded normals from vertex `first` on longer where the driver would lose them.
void enlarge_recorded_normals(Context& context, std::uint32_t first);

}  // namespace legacy_gl
