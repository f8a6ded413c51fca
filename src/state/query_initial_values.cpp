// State of GL 1.5 whose entry points are not built: nothing can have changed it, so glGet answers
// its initial value (GL 2.1 spec tables 6.6 to 6.33). A row goes when its feature comes.
#include "state/queries.hpp"

namespace legacy_gl {

namespace {

using enum ValueKind;

template <GLint... Values>
void fixed(Context&, QueryValues& v) {
  (v.put(Values), ...);
}

constexpr Query kStipples[] = {
    {GL_LINE_STIPPLE_PATTERN, kInteger, fixed<0xFFFF>},
    {GL_LINE_STIPPLE_REPEAT, kInteger, fixed<1>},
};

/// What no driver under this library has: colour index mode and auxiliary buffers.
constexpr Query kAbsentBuffers[] = {
    {GL_RGBA_MODE, kBoolean, fixed<1>},
    {GL_INDEX_MODE, kBoolean, fixed<0>},
    {GL_INDEX_BITS, kInteger, fixed<0>},
    {GL_AUX_BUFFERS, kInteger, fixed<0>},
};

}  // namespace

QueryGroups initial_value_queries() {
  static constexpr std::span<const Query> kGroups[] = {kStipples, kAbsentBuffers};
  return kGroups;
}

}  // namespace legacy_gl
