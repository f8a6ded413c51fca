// State of GL 1.5 that nothing changes: glGet answers its initial value (GL 2.1 spec tables 6.6
// to 6.33).
#include "execute/queries.hpp"

namespace legacy_gl {

namespace {

using enum ValueKind;

template <GLint... Values>
void fixed(Context&, QueryValues& v) {
  (v.put(Values), ...);
}

/// What no driver under this library has: colour index mode and auxiliary buffers.
constexpr Query kAbsentBuffers[] = {
    {GL_RGBA_MODE, kBoolean, fixed<1>},
    {GL_INDEX_MODE, kBoolean, fixed<0>},
    {GL_INDEX_BITS, kInteger, fixed<0>},
    {GL_AUX_BUFFERS, kInteger, fixed<0>},
};

}  // namespace

QueryGroups initial_value_queries() {
  static constexpr std::span<const Query> kGroups[] = {kAbsentBuffers};
  return kGroups;
}

}  // namespace legacy_gl
