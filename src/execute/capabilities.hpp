#pragma once
#include <cstdint>
#include <vector>

#include "context/context.hpp"

namespace legacy_gl {

/// glEnable, glDisable (GL 2.1 spec 2.1, appendix): false for a capability that GL 1.5 does not
/// have.
bool set_capability(Context& context, GLenum capability, bool enabled);

/// What glIsEnabled answers; false in `known` for a capability that GL 1.5 does not have.
bool capability_enabled(const Context& context, GLenum capability, bool& known);

/// What GL_ENABLE_BIT saves: every capability, the lights last.
void save_enables(const Context& context, std::vector<std::uint8_t>& enables);
void restore_enables(Context& context, const std::vector<std::uint8_t>& enables);

}  // namespace legacy_gl
