#pragma once
#include "record/array_submit.hpp"

namespace legacy_gl {

/// Array draws in a display list are dereferenced when they are compiled (GL 2.1 spec 5.4): what
/// they point to is copied into the list as floats, the enabled arrays alone. Playing it takes the
/// current values of that time.
void record_arrays(legacy_gl_context& context, const ArrayViews& views, GLenum mode,
                   std::uint32_t first, std::uint32_t count);
void record_elements(legacy_gl_context& context, const ArrayViews& views, GLenum mode,
                     const ElementView& elements);

}  // namespace legacy_gl
