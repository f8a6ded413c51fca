#pragma once
#include <optional>

#include "context/context.hpp"
#include "submit/arrays.hpp"

namespace legacy_gl {

/// The vertices that the draw reads; nothing when they are so few that the recorder serves them
/// better, or too far apart.
std::optional<ElementRange> find_dense_range(const ArrayDraw& draw, const ElementView& elements,
                                             const ArrayViews& views);

/// Some normal of the range may be so short that the recorder has to make it longer.
bool may_have_tiny_normals(const Context& context, const ArrayViews& views,
                           const ElementRange& range);

/// Nothing waits. Draws the vertices of `range`, converted straight into the driver's memory. False
/// when the driver gives none.
bool draw_arrays_streamed(Context& context, const ArrayDraw& draw, const ArrayViews& views,
                          const ElementView& elements, const ElementRange& range);

}  // namespace legacy_gl
